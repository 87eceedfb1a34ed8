#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "cli/lines.hpp"

namespace mpmvv::cli {

/// Rows of cells under their heads, each column as wide as its widest cell. Where a line has no room for all of them
/// the first texts, as many as it takes, stand on lines of their own, above the rows that have them.
class Table {
 public:
  /// `verdict`: words that a terminal shows in colour. The last column may be `prose`, which is wrapped to what a line
  /// has left, or a `line`, which is cut there. Where that is little it stands below the row, and has no head.
  enum class Kind { text, number, verdict, prose, line };

  struct Column {
    std::string head;  ///< of several lines where it has line breaks; printable
    Kind kind = Kind::text;
  };

  explicit Table(std::vector<Column> columns, std::size_t indent = 2);

  void add(std::vector<std::string> cells);  ///< one for each column

  std::size_t width() const;  ///< in columns of the terminal, without an open last column
  std::string text(std::size_t width, bool coloured) const;  ///< in lines of this width, as far as words allow
  void print() const;        ///< as wide as the terminal is; nothing of a table without rows
  void print_apart() const;  ///< the same below an empty line

 private:
  using Cells = std::vector<std::string>;

  bool is_open() const;                        ///< the last column takes what a line has left
  std::size_t room(std::size_t width) const;   ///< what a line has left for it
  bool stands_below(std::size_t width) const;  ///< the last column, without room beside the rest and without a head
  std::vector<Cells> head_lines() const;
  std::string line(const Cells& cells, bool coloured) const;
  std::string row(Cells cells, std::size_t width, bool coloured) const;
  std::size_t columns_above(std::size_t width) const;  ///< how many stand above the rows
  Table without_first(std::size_t columns) const;
  std::string text_below_first(std::size_t columns, std::size_t width, bool coloured) const;

  std::vector<Column> columns_;
  std::size_t indent_;
  std::vector<std::size_t> widths_;  ///< of columns; 0 for an open one
  std::vector<Cells> rows_;
};

}  // namespace mpmvv::cli
