#pragma once
#include <vector>

#include "studies/fits/paired_rounds.hpp"

namespace mpmvv::fits {

/// A number that times make, and how far it may lie from there.
struct Ranged {
  double value, half_range = 0;
};

/// Between the quotients of the ranges' ends; anywhere where the divisor's range reaches 0.
Estimate quotient(const Ranged& number, const Ranged& over);

/// What a run cost and how accurate it was.
struct WorkPoint {
  double cost = 0;        ///< step seconds on one core, measured alone
  double error = 0;       ///< in the norm asked for
  double half_range = 0;  ///< of the cost: half the range of its repetitions
  Rounds rounds = {};     ///< the cost in each round, where it is known

  bool operator==(const WorkPoint&) const = default;
};

/// The points of which no other is both cheaper (or as cheap) and more accurate (or as accurate, to rounding), by
/// increasing cost.
std::vector<WorkPoint> pareto_front(std::vector<WorkPoint> points);

/// The cost of reaching an error. Between two points of the front it follows the power law through both, also in each
/// round, and their ranges add in squares; it is the cheapest point's where that is accurate enough already, and
/// infinite where no point is.
WorkPoint work_to_reach(double error, const std::vector<WorkPoint>& front);

/// The quotient of two costs, over their rounds where these are paired, else of their ranges.
Estimate quotient(const WorkPoint& cost, const WorkPoint& over);

/// The powers of ten within [from, to], largest first. Both must be positive.
std::vector<double> decades(double from, double to);

}  // namespace mpmvv::fits
