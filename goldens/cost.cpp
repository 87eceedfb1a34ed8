#include "goldens/cost.hpp"

#include <algorithm>
#include <limits>

#include "studies/fits/distributions.hpp"
#include "studies/fits/median.hpp"

namespace mpmvv::goldens {

namespace {

constexpr std::size_t least_pairs = 9, most_pairs = 45;

std::vector<double> values_of(const std::vector<CostPair>& pairs, const std::function<double(const CostPair&)>& value) {
  std::vector<double> values;
  for (const CostPair& pair : pairs) values.push_back(value(pair));
  return values;
}

/// The rank, from either end, of the values that bound the interval: chance puts the true median beyond each with a
/// probability of at most 0.5 %. 0 when even the extremes may miss it.
std::size_t rank_of_bounds(std::size_t n) {
  std::size_t k = 0;
  while (fits::at_most_heads(static_cast<double>(k), static_cast<double>(n)) <= 0.005) ++k;
  return k;
}

}  // namespace

Verdict CostRatio::verdict() const {
  if (most <= cost_band) return Verdict::pass;
  return least > cost_band ? Verdict::fail : Verdict::inconclusive;
}

CostRatio cost_ratio(const std::vector<CostPair>& pairs) {
  auto ratios = values_of(pairs, [](const CostPair& p) { return p.now / p.baseline; });
  std::ranges::sort(ratios);
  const std::size_t rank = rank_of_bounds(ratios.size());
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  return {.now = fits::median_of(values_of(pairs, &CostPair::now)),
          .baseline = fits::median_of(values_of(pairs, &CostPair::baseline)),
          .ratio = fits::median_of(ratios),
          .least = rank == 0 ? 0 : ratios[rank - 1],
          .most = rank == 0 ? unbounded : ratios[ratios.size() - rank],
          .pairs = pairs.size()};
}

CostRatio measure_cost(const std::function<CostPair()>& measure) {
  std::vector<CostPair> pairs;
  while (pairs.size() < least_pairs) pairs.push_back(measure());
  while (pairs.size() < most_pairs && cost_ratio(pairs).verdict() == Verdict::inconclusive) pairs.push_back(measure());
  return cost_ratio(pairs);
}

}  // namespace mpmvv::goldens
