#pragma once
#include <string>
#include <vector>

#include "reports/table.hpp"

/// Tables in LaTeX, for \input into a document that is 125 mm wide or more.
namespace mpmvv::reports {

/// The text of a cell: numbers, with an interval or without one, in mathematics (`$1.23 \times 10^{-4}$`), others
/// typeset.
std::string latex_cell(const std::string& text);

/// Cells as a line of a table.
std::string latex_line(const std::vector<std::string>& cells);

/// The table as a booktabs table that runs over pages. Its first column takes what the others leave; a column `norm`
/// has symbols, which a line below the table explains. Columns without a number are left out. Empty without rows.
std::string latex_long_table(const Table& table);

/// The tables as booktabs tables, long ones in pieces. Columns of prose, and others where the line is too short for
/// all, are broken and share what the rest leaves of it.
std::string latex_tables(const std::vector<Table>& tables);

/// The first lines of a file of tables: its title and the packages that it needs, as comments.
std::string latex_head(const std::string& title);

}  // namespace mpmvv::reports
