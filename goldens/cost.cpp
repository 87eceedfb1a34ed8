#include "goldens/cost.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <limits>

namespace mpmvv {

namespace {

constexpr std::size_t least_pairs = 9, most_pairs = 45;

double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

std::vector<double> values_of(const std::vector<CostPair>& pairs, const std::function<double(const CostPair&)>& value) {
  std::vector<double> values;
  for (const CostPair& pair : pairs) values.push_back(value(pair));
  return values;
}

/// How many of the values lie outside the interval on either side: as many as chance leaves below the true median with
/// a probability of at most 0.5 %. None when even the extremes may miss it.
std::size_t count_outside(std::size_t n) {
  const boost::math::binomial below(static_cast<double>(n), 0.5);
  std::size_t k = 0;
  while (cdf(below, static_cast<double>(k)) <= 0.005) ++k;
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
  const std::size_t outside = count_outside(ratios.size());
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  return {.now = median_of(values_of(pairs, &CostPair::now)),
          .baseline = median_of(values_of(pairs, &CostPair::baseline)),
          .ratio = median_of(ratios),
          .least = outside == 0 ? 0 : ratios[outside - 1],
          .most = outside == 0 ? unbounded : ratios[ratios.size() - outside],
          .pairs = pairs.size()};
}

CostRatio measure_cost(const std::function<CostPair()>& measure) {
  std::vector<CostPair> pairs;
  while (pairs.size() < least_pairs) pairs.push_back(measure());
  while (pairs.size() < most_pairs && cost_ratio(pairs).verdict() == Verdict::inconclusive) pairs.push_back(measure());
  return cost_ratio(pairs);
}

}  // namespace mpmvv
