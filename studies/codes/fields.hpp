#pragma once
#include <string>
#include <vector>

#include "studies/codes/code.hpp"
#include "studies/codes/template_text.hpp"

namespace mpmvv::codes {

/// Returns the fields for words of commands and names of files: those of the case, the adapter and its variant.
TemplateFields fields_of(const cases::Case& c, const Code& code);

/// Returns a word of a command, or the name of a file, with its fields filled in.
std::string filled_word(const std::string& word, const TemplateFields& fields, const Code& code);

/// Returns the texts of the adapter's input files, in its order. Their fields are those of words, particles, and
/// expressions. A template in the adapter's units has neither expressions nor the problem's parameters.
std::vector<std::string> input_texts(const cases::Case& c, const Code& code);

/// Throws UsageError if a template of the adapter names a field that does not exist, or is no valid template.
void require_sound_templates(const cases::Case& c, const Code& code);

}  // namespace mpmvv::codes
