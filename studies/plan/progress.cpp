#include "studies/plan/progress.hpp"

#include <algorithm>
#include <cmath>

#include "studies/plan/estimates.hpp"

namespace mpmvv::plan {

void Remaining::add(const cases::Case& c, double estimate) {
  estimates_[c] = estimate;
}

void Remaining::finish(const cases::Case& c, double measured) {
  const auto left = estimates_.find(c);
  if (left == estimates_.end()) return;
  if (std::isfinite(measured)) {
    estimated_ += left->second;
    measured_ += measured;
  }
  estimates_.erase(left);
}

/// Cases that run in parallel take at least as long as the longest that threads do not share; timed cases are measured
/// after them, one by one.
double Remaining::seconds(int jobs) const {
  constexpr double trust = 1;  // seconds for which the estimates are taken as they are
  double beside = std::max(0.0, expected_), longest = 0, alone = 0;
  for (const auto& [c, estimate] : estimates_) {
    alone += share_alone(c) * estimate;
    beside += (1 - share_alone(c)) * estimate;
  }
  for (const auto& [c, estimate] : estimates_) {
    const bool is_shared = c.measure.repeat == 0 && outlasts_others(estimate, beside, jobs) && can_be_shared(c);
    if (!is_shared) longest = std::max(longest, (1 - share_alone(c)) * estimate);
  }
  const double correction = (measured_ + trust) / (estimated_ + trust);
  return correction * (std::max(beside / jobs, longest) + alone);
}

}  // namespace mpmvv::plan
