#pragma once
#include <filesystem>

#include "studies/alarms.hpp"

namespace mpmvv {

/// What is published in the folder of the mutants' lists; none where nothing is. UsageError on every mistake in the
/// file, with FILE:LINE.
AlarmLog read_alarms(const std::filesystem::path& folder);

}  // namespace mpmvv
