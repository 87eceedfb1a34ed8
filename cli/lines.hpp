#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace mpmvv::cli {

/// Texts as a terminal shows them: UTF-8, one column a character.
std::size_t columns_of(const std::string& text);

enum class Align { left, right };
std::string padded(const std::string& text, std::size_t columns, Align align);

/// The text in lines of at most so many columns, broken at blanks; a longer word has a line of its own.
std::vector<std::string> wrapped(const std::string& text, std::size_t columns);

/// Prints the text in lines of the terminal's width, each behind so many blanks.
void print_indented(const std::string& text, std::size_t blanks = 4);

/// The text, with … in place of what goes beyond so many columns.
std::string cut(const std::string& text, std::size_t columns);

}  // namespace mpmvv::cli
