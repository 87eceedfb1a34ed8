#pragma once
#include "reports/chart.hpp"

namespace mpmvv::reports {

/// What the studies' numbers are multiplied by where the original of a figure has its quantity in another unit; else 1.
double upwards_factor(const records::Figure& figure);

/// Makes the chart of a figure that shows one of a paper look like the original (papers.toml): its units, lengths to
/// scale, groups of series in one colour.
void give_original_look(Chart& chart, const records::Figure& figure);

}  // namespace mpmvv::reports
