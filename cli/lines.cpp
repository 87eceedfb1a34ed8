#include "cli/lines.hpp"

#include <algorithm>

#include "cli/console.hpp"

namespace mpmvv::cli {

namespace {

bool starts_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

}  // namespace

std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, starts_character));
}

std::string padded(const std::string& text, std::size_t columns, Align align) {
  const std::string blanks(columns - std::min(columns, columns_of(text)), ' ');
  return align == Align::left ? text + blanks : blanks + text;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t columns) {
  std::vector<std::string> lines(1);
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (lines.back().empty())
      lines.back() = word;
    else if (columns_of(lines.back()) + 1 + columns_of(word) <= columns)
      lines.back() += ' ' + word;
    else
      lines.push_back(word);
    begin = end + 1;
  }
  return lines;
}

void print_indented(const std::string& text, std::size_t blanks) {
  const std::string indent(blanks, ' ');
  for (const std::string& line : wrapped(text, text_width() - indent.size())) print("{}{}\n", indent, line);
}

std::string cut(const std::string& text, std::size_t columns) {
  if (columns_of(text) <= columns) return text;
  if (columns == 0) return "";
  std::size_t end = 0;
  for (std::size_t shown = 0; shown < columns; ++end) shown += starts_character(text[end]);
  return text.substr(0, end - 1) + "…";
}

}  // namespace mpmvv::cli
