#pragma once
#include <vector>

namespace mpmvv::fits {

/// What a run cost and how accurate it was.
struct WorkPoint {
  double cost = 0;        ///< step seconds on one core, measured alone
  double error = 0;       ///< in the norm asked for
  double half_range = 0;  ///< of the cost: half the range of its repetitions

  bool operator==(const WorkPoint&) const = default;
};

/// The points of which no other is both cheaper (or as cheap) and more accurate (or as accurate), by increasing cost.
std::vector<WorkPoint> pareto_front(std::vector<WorkPoint> points);

/// The cost of reaching an error. Between two points of the front it follows the power law through both, and their
/// ranges add in squares; it is the cheapest point's where that is accurate enough already, and infinite where no point
/// is.
WorkPoint work_to_reach(double error, const std::vector<WorkPoint>& front);

inline double cost_to_reach(double error, const std::vector<WorkPoint>& front) {
  return work_to_reach(error, front).cost;
}

/// The powers of ten within [from, to], largest first. Both must be positive.
std::vector<double> decades(double from, double to);

}  // namespace mpmvv::fits
