#pragma once
#include <filesystem>
#include <string>

#include "studies/cases/case.hpp"

namespace mpmvv::codes {

/// A case as one record that whoever writes a code's input and whoever scores its output read: its problem, parameters,
/// settings, the columns that an output may have, units; JSON, with an end of line.
std::string case_text(const cases::Case& c);

/// The case that such a file holds. UsageError when it holds none, or one that now reads otherwise than when it was
/// written.
cases::Case read_case(const std::filesystem::path& file);

}  // namespace mpmvv::codes
