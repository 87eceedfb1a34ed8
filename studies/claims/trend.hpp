#pragma once
#include <string>
#include <vector>

#include "studies/claims/finding.hpp"

namespace mpmvv::claims {

/// One result over the versions of a store: a fitted order, the error at the finest level, a stability limit or a
/// value of a check.
struct Trend {
  std::string study;
  Finding::Kind kind = Finding::Kind::order;
  std::string name;
  std::vector<double> numbers;  ///< one per version, NaN where it has none
};

/// The trends of the versions' findings, in the order in which these first name them, those of a study together.
std::vector<Trend> trends_of(const std::vector<std::vector<Finding>>& versions);

}  // namespace mpmvv::claims
