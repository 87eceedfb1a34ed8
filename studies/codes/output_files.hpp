#pragma once
#include "studies/codes/code.hpp"
#include "studies/codes/score.hpp"
#include "studies/codes/template_text.hpp"

namespace mpmvv::codes {

/// Reads what a code left in the folder of a case's run. Throws UsageError if it is not as the adapter says.
Output read_output(const cases::Case& c, const Code& code, const TemplateFields& fields,
                   const std::filesystem::path& folder);

}  // namespace mpmvv::codes
