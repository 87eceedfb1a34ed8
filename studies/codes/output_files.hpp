#pragma once
#include "studies/codes/code.hpp"
#include "studies/codes/score.hpp"
#include "studies/codes/template_text.hpp"

namespace mpmvv::codes {

/// What a code left in the folder of its run. UsageError where it is not as the adapter says, or of another time than
/// the end time.
Output read_output(const Code& code, const Fields& fields, const std::filesystem::path& folder, double end_time);

}  // namespace mpmvv::codes
