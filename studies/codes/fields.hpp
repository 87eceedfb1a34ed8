#pragma once
#include "studies/codes/code.hpp"
#include "studies/codes/template_text.hpp"

namespace mpmvv::codes {

/// Returns the fields for words of commands and names of files: those of the case, the adapter and its variant.
TemplateFields fields_of(const cases::Case& c, const Code& code);

/// Returns the fields for templates of input files: the same, with particles and expressions.
TemplateFields input_fields_of(const cases::Case& c, const Code& code);

/// Returns a word of a command, or the name of a file, with its fields filled in.
std::string filled_word(const std::string& word, const TemplateFields& fields, const Code& code);

/// Returns the text of an input file.
std::string filled_input(const InputFile& input, const TemplateFields& fields);

/// Throws UsageError if a template of the adapter names a field that does not exist, or is no valid template.
void require_sound_templates(const cases::Case& c, const Code& code);

}  // namespace mpmvv::codes
