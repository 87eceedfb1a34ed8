#pragma once
#include <string>
#include <vector>

#include "studies/records/result.hpp"
#include "studies/store/database.hpp"

namespace mpmvv::store {

struct StoredPoint {
  records::Point point;
  std::string case_text;  ///< empty where the point is no run
};

/// The points of the series with this id, in their order. A few statements read all of them, because a statement for
/// each point would take most of the time in which a store is read.
std::vector<StoredPoint> load_points(const Database& database, const Value& series);

}  // namespace mpmvv::store
