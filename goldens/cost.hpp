#pragma once
#include <functional>
#include <vector>

#include "studies/records/verdict.hpp"

namespace mpmvv::goldens {

using records::Verdict;

/// The most that a case may cost beside a baseline before the gate fails it.
inline constexpr double cost_band = 1.1;

/// The most that the cases may cost in their geometric mean. If every case costs 5 % more, the whole interval lies
/// above it where pairs of runs scatter by 0.05, and five times in six where they scatter by 0.1. Beside itself no
/// program failed in 1,200 simulated calls.
inline constexpr double mean_cost_band = 1.03;

/// ns per particle and step of two runs, one right after the other.
struct CostPair {
  double now = 0, baseline = 0;
};

/// What a case costs beside a baseline.
struct CostRatio {
  double now = 0, baseline = 0;  ///< medians
  double ratio = 0;              ///< median of the pairs' ratios
  double least = 0, most = 0;    ///< its interval by order statistics, of 99 % over all looks of `measure_cost`
  std::size_t pairs = 0;
  std::vector<double> first_logs;  ///< logarithms of the first nine ratios, which no look has chosen

  /// Pass or fail when the whole interval lies on one side of the band, else inconclusive.
  Verdict verdict() const;
};

/// What all cases cost beside a baseline.
struct MeanCost {
  double ratio = 0, least = 0, most = 0;  ///< geometric mean of the cases' ratios, and its interval of 99 %

  /// As a case's, by the band of the mean.
  Verdict verdict() const;
};

/// Needs at least one pair; with fewer than nine the interval is unbounded.
CostRatio cost_ratio(const std::vector<CostPair>& pairs);

/// Measures nine pairs. While the verdict is inconclusive it goes on to 15, 25 and 45 pairs and looks again there.
CostRatio measure_cost(const std::function<CostPair()>& measure);

/// Needs at least one case, each with the logarithms of nine ratios. Each case's logarithm is their mean without the
/// largest and the smallest; its variance comes from the same nine, with these two moved in to their neighbours (Tukey
/// and McLaughlin). The cases count alike; Student's t has the degrees of freedom of Welch and Satterthwaite.
MeanCost mean_cost(const std::vector<CostRatio>& cases);

/// Fail when a case or the mean fails, pass when all of them pass, else inconclusive; so without a case.
Verdict verdict_of(const std::vector<CostRatio>& cases);

}  // namespace mpmvv::goldens
