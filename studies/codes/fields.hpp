#pragma once
#include "studies/codes/code.hpp"
#include "studies/codes/template_text.hpp"

namespace mpmvv::codes {

/// What the words of a command may name: numbers and words of the case, what the adapter's variant says.
Fields fields_of(const cases::Case& c, const Code& code);

/// The same, and what templates of input files may name besides: particles and expressions.
Fields input_fields_of(const cases::Case& c, const Code& code);

/// A word of a command, or a file's name, with its fields in place.
std::string filled_word(const std::string& word, const Fields& fields, const Code& code);

/// The text of an input file.
std::string filled_input(const InputFile& input, const Fields& fields);

/// UsageError where a template of the adapter names what it does not have, or is none.
void require_sound_templates(const cases::Case& c, const Code& code);

}  // namespace mpmvv::codes
