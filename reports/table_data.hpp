#pragma once
#include "reports/table.hpp"
#include "reports/template_data.hpp"

namespace mpmvv::reports {

/// A table for its template: numbers stand on the right, short texts in one line, addresses are links.
template_data::data table_data(const Table& table);

}  // namespace mpmvv::reports
