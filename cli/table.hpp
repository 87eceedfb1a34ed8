#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "cli/lines.hpp"

namespace mpmvv::cli {

/// Rows of cells under their heads, each column as wide as its widest cell.
class Table {
 public:
  /// `verdict`: words that a terminal shows in colour; `prose`: the last column, wrapped to what a line has left.
  enum class Kind { text, number, verdict, prose };

  struct Column {
    std::string head;  ///< of several lines where it has line breaks; printable
    Kind kind = Kind::text;
  };

  explicit Table(std::vector<Column> columns, std::size_t indent = 2);

  void add(std::vector<std::string> cells);  ///< one for each column
  bool empty() const { return rows_.empty(); }

  std::size_t width() const;  ///< in columns of the terminal, without prose
  std::string text(std::size_t width, bool coloured) const;
  void print() const;  ///< as wide as the terminal is; nothing of a table without rows

 private:
  using Cells = std::vector<std::string>;

  std::vector<Cells> head_lines() const;
  std::string line(const Cells& cells, bool coloured) const;

  std::vector<Column> columns_;
  std::size_t indent_;
  std::vector<std::size_t> widths_;  ///< of columns; 0 of prose
  std::vector<Cells> rows_;
};

}  // namespace mpmvv::cli
