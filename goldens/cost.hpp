#pragma once
#include <functional>
#include <vector>

#include "studies/records/verdict.hpp"

namespace mpmvv::goldens {

using records::Verdict;

/// The most that a case may cost beside a baseline before the gate fails it.
inline constexpr double cost_band = 1.1;

/// ns per particle and step of two runs, one right after the other.
struct CostPair {
  double now = 0, baseline = 0;
};

/// What a case costs beside a baseline.
struct CostRatio {
  double now = 0, baseline = 0;           ///< medians
  double ratio = 0, least = 0, most = 0;  ///< median of the pairs' ratios, and its interval of 99 % by order statistics
  std::size_t pairs = 0;

  /// Pass or fail when the whole interval lies on one side of the band, else inconclusive.
  Verdict verdict() const;
};

/// Needs at least one pair; with fewer than eight the interval is unbounded.
CostRatio cost_ratio(const std::vector<CostPair>& pairs);

/// Measures nine pairs, and while the verdict is inconclusive more of them, up to 45.
CostRatio measure_cost(const std::function<CostPair()>& measure);

}  // namespace mpmvv::goldens
