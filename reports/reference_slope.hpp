#pragma once
#include "reports/chart.hpp"

namespace mpmvv::reports {

/// Adds a dashed line of slope p, in powers of h, with a slope triangle and its name to a chart with two logarithmic
/// axes, where it lies clear of everything that is in the chart already; nothing where there is no such place. `sweep`
/// says what x is: `cells` and `ppc` are 1/h, all else is h.
void add_reference_slope(Chart& chart, double p, const std::string& sweep);

}  // namespace mpmvv::reports
