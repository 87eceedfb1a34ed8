#pragma once
#include "studies/codes/code.hpp"
#include "studies/codes/score.hpp"
#include "studies/codes/template_text.hpp"

namespace mpmvv::codes {

/// What a code left in the folder of a case's run. UsageError where it is not as the adapter says, or of another time
/// than the end time. Of a planted mistake that does not say its time, the time is not put to the question: its errors
/// are meant to be large.
Output read_output(const cases::Case& c, const Code& code, const TemplateFields& fields,
                   const std::filesystem::path& folder);

}  // namespace mpmvv::codes
