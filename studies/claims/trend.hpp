#pragma once
#include <string>
#include <vector>

#include "studies/claims/finding.hpp"

namespace mpmvv::claims {

/// One result over the versions of a store: a fitted order, the error at a level that was the finest of a version, a
/// stability limit or a value of a check.
struct Trend {
  std::string study;
  Finding::Kind kind = Finding::Kind::order;
  std::string name;
  std::vector<double> numbers;  ///< one per version, NaN where it has none
  double at = not_measured;     ///< of an error: the swept value of its level
  /// One per version: the status of a run behind the number that is not ok; of a limit that was not found "all stable",
  /// "all unstable" or "not found"; else empty.
  std::vector<std::string> remarks = {};
  std::string quantity = {};  ///< of an error, a limit or an extrapolated value: l2, cfl; else empty
};

/// The trend's name, and at which level.
std::string label(const Trend& trend);

/// The same with the unit of its quantity: "error of 'linear' in l2 (m) at 64".
std::string label_with_unit(const Trend& trend);

/// The trends of the versions' findings, in the order in which these first name them, those of a study together.
std::vector<Trend> trends_of(const std::vector<std::vector<Finding>>& versions);

}  // namespace mpmvv::claims
