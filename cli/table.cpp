#include "cli/table.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "cli/console.hpp"
#include "studies/support/printable.hpp"

namespace mpmvv::cli {

namespace {

constexpr std::size_t below = 4;        ///< columns by which prose below its row is indented
constexpr std::size_t gap = 2;          ///< between columns
constexpr std::size_t least_open = 24;  ///< columns that an open column needs to stand beside the others

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
    if (column.kind == Kind::prose || column.kind == Kind::line) continue;
    for (const std::string& line : lines_of(column.head)) widths_.back() = std::max(widths_.back(), columns_of(line));
  }
}

void Table::add(std::vector<std::string> cells) {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    cells[k] = support::printable(cells[k]);
    if (!is_open() || k + 1 < columns_.size()) widths_[k] = std::max(widths_[k], columns_of(cells[k]));
  }
  rows_.push_back(std::move(cells));
}

bool Table::is_open() const {
  return columns_.back().kind == Kind::prose || columns_.back().kind == Kind::line;
}

std::size_t Table::width() const {
  std::size_t width = indent_ + gap * (columns_.size() - 1);
  for (const std::size_t column : widths_) width += column;
  return width;
}

std::size_t Table::room(std::size_t width) const {
  return width > this->width() ? width - this->width() : 0;
}

bool Table::stands_below(std::size_t width) const {
  return is_open() && room(width) < least_open;
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

/// The row in one line, or with its prose in as many as it takes: beside the rest, or, where that leaves little, below.
std::string Table::row(Cells cells, std::size_t width, bool coloured) const {
  if (!is_open()) return line(cells, coloured);
  const std::string last = std::exchange(cells.back(), "");
  const bool is_beside = !stands_below(width);
  const std::size_t margin = is_beside ? this->width() : indent_ + below;
  const std::size_t left = std::max(width, margin + 1) - margin;
  std::vector<std::string> lines =
      columns_.back().kind == Kind::line ? std::vector{cut(last, left)} : wrapped(last, left);
  if (is_beside) cells.back() = std::exchange(lines.front(), "");
  std::string text = line(cells, coloured);
  for (const std::string& more : lines)
    if (!more.empty()) text += std::string(margin, ' ') + more + '\n';
  return text;
}

std::size_t Table::columns_above(std::size_t width) const {
  std::size_t above = 0;
  const auto is_text = [&] { return above + 2 < columns_.size() && columns_[above].kind == Kind::text; };
  for (std::size_t taken = this->width(); taken > width && is_text(); ++above)
    taken -= widths_[above] + (above == 0 ? 0 : gap);  // the rest is indented by a gap
  return above;
}

Table Table::without_first(std::size_t columns) const {
  const auto first = static_cast<std::ptrdiff_t>(columns);
  Table rest({columns_.begin() + first, columns_.end()}, indent_ + gap);
  rest.widths_.assign(widths_.begin() + first, widths_.end());
  return rest;
}

std::string Table::text_below_first(std::size_t columns, std::size_t width, bool coloured) const {
  const auto first = static_cast<std::ptrdiff_t>(columns);
  const auto above = [&](const Cells& cells) {
    std::string lines;
    const std::string joined = fmt::format("{}", fmt::join(cells.begin(), cells.begin() + first, ", "));
    for (const std::string& line : wrapped(joined, std::max(width, indent_ + 1) - indent_))
      lines += std::string(indent_, ' ') + line + '\n';
    return lines;
  };
  Cells heads;
  for (const Column& column : columns_) heads.push_back(fmt::format("{}", fmt::join(lines_of(column.head), " ")));
  const Table rest = without_first(columns);
  std::string text = above(heads) + rest.text(width, coloured), last;
  for (const Cells& cells : rows_) {
    const std::string head = above(cells);
    if (head != last) text += head;
    last = head;
    text += rest.row({cells.begin() + first, cells.end()}, width, coloured);
  }
  return text;
}

std::string Table::text(std::size_t width, bool coloured) const {
  if (const std::size_t above = columns_above(width); above > 0) return text_below_first(above, width, coloured);
  std::string text;
  for (Cells heads : head_lines()) {
    if (stands_below(width)) heads.back().clear();
    text += line(heads, false);
  }
  for (const Cells& cells : rows_) text += row(cells, width, coloured);
  return text;
}

/// Output that goes to no terminal may be read by programs: its prose is not wrapped and no line is cut.
void Table::print() const {
  constexpr std::size_t endless = 1'000'000;
  if (rows_.empty()) return;
  print_text(text(output_columns().value_or(endless), has_colours()));
}

void Table::print_apart() const {
  if (rows_.empty()) return;
  print_text("\n");
  print();
}

}  // namespace mpmvv::cli
