#pragma once
#include "studies/codes/code.hpp"
#include "studies/codes/template_text.hpp"

namespace mpmvv::codes {

/// What the words of a command may name: numbers and words of the case, what the adapter's variant says.
Fields fields_of(const cases::Case& c, const Code& code);

/// The same, and what templates of input files may name besides: particles and expressions.
Fields input_fields_of(const cases::Case& c, const Code& code);

}  // namespace mpmvv::codes
