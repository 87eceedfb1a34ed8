#include "cli/table.hpp"

#include <algorithm>
#include <sstream>

#include "cli/console.hpp"
#include "studies/support/printable.hpp"

namespace mpmvv::cli {

namespace {

constexpr std::size_t gap = 2;           ///< between columns
constexpr std::size_t least_prose = 24;  ///< columns that prose gets on the narrowest terminal

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

Table::Table(std::vector<Column> columns, std::size_t indent) : columns_(std::move(columns)), indent_(indent) {
  for (const Column& column : columns_) {
    widths_.push_back(0);
    if (column.kind == Kind::prose) continue;
    for (const std::string& line : lines_of(column.head)) widths_.back() = std::max(widths_.back(), columns_of(line));
  }
}

void Table::add(std::vector<std::string> cells) {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    cells[k] = support::printable(cells[k]);
    if (columns_[k].kind != Kind::prose) widths_[k] = std::max(widths_[k], columns_of(cells[k]));
  }
  rows_.push_back(std::move(cells));
}

std::size_t Table::width() const {
  std::size_t width = indent_ + gap * (columns_.size() - 1);
  for (const std::size_t column : widths_) width += column;
  return width;
}

/// Heads stand on the line above the first row, their other lines above that.
std::vector<Table::Cells> Table::head_lines() const {
  std::vector<Cells> lines;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const auto head = lines_of(columns_[k].head);
    while (lines.size() < head.size()) lines.emplace(lines.begin(), columns_.size());
    for (std::size_t l = 0; l < head.size(); ++l) lines[lines.size() - head.size() + l][k] = head[l];
  }
  return lines;
}

std::string Table::line(const Cells& cells, bool coloured) const {
  std::string line(indent_, ' ');
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Kind kind = columns_[k].kind;
    const std::string cell = padded(cells[k], widths_[k], kind == Kind::number ? Align::right : Align::left);
    line += (k == 0 ? "" : std::string(gap, ' '));
    line += coloured && kind == Kind::verdict ? coloured_verdict(cell) : cell;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

std::string Table::text(std::size_t width, bool coloured) const {
  std::string text;
  for (const Cells& heads : head_lines()) text += line(heads, false);
  for (Cells cells : rows_) {
    std::vector<std::string> rest;
    if (columns_.back().kind == Kind::prose) {
      const std::size_t left = width > this->width() ? width - this->width() : 0;
      rest = wrapped(cells.back(), std::max(left, least_prose));
      cells.back() = rest.front();
      rest.erase(rest.begin());
    }
    text += line(cells, coloured);
    for (const std::string& more : rest) text += std::string(this->width(), ' ') + more + '\n';
  }
  return text;
}

void Table::print() const {
  constexpr std::size_t endless = 1'000'000;  // where no terminal breaks lines, programs may read them
  if (!rows_.empty()) print_text(text(output_columns().value_or(endless), has_colours()));
}

}  // namespace mpmvv::cli
