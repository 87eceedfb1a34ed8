#pragma once
#include <string>

namespace mpmvv::cli {

/// Prints a text with headings, paragraphs and tables in Markdown: on a terminal in lines and columns of its width,
/// else as it is.
void print_markdown(const std::string& text);

}  // namespace mpmvv::cli
