#pragma once
#include <string>
#include <vector>

#include "reports/table.hpp"

namespace mpmvv::reports {

/// The fitted orders of these studies, a group for each that has any.
Table orders_table(const std::vector<const records::StudyResult*>& studies);

/// The table in LaTeX, a booktabs table that runs over pages, with its texts but the groups' titles typeset; empty
/// without rows.
std::string latex_long_table(const Table& table);

}  // namespace mpmvv::reports
