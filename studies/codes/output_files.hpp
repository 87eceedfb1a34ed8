#pragma once
#include "studies/codes/code.hpp"
#include "studies/codes/score.hpp"
#include "studies/codes/template_text.hpp"

namespace mpmvv::codes {

/// Reads what a code left in the folder of a case's run. Throws UsageError if it is not as the adapter says, or of
/// another step or time than the last. A time that is not the end time, though within the adapter's time_tolerance, is
/// the one at which `score` measures. If the output says no time, `score` judges by its errors whether it is of another
/// time. A planted mistake is meant to have large errors: there the end time is filled in, so that `score` does not
/// judge.
Output read_output(const cases::Case& c, const Code& code, const TemplateFields& fields,
                   const std::filesystem::path& folder);

}  // namespace mpmvv::codes
