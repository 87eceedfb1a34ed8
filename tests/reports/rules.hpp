#pragma once
#include <algorithm>
#include <iterator>
#include <vector>

#include "reports/chart.hpp"

namespace mpmvv::reports {

/// What of a kind a chart draws.
inline std::vector<Rule> rules(const Chart& chart, Rule::Kind kind) {
  std::vector<Rule> result;
  std::ranges::copy_if(chart.rules, std::back_inserter(result), [&](const Rule& r) { return r.kind == kind; });
  return result;
}

}  // namespace mpmvv::reports
