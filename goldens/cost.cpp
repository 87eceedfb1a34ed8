#include "goldens/cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "studies/fits/distributions.hpp"
#include "studies/fits/median.hpp"

namespace mpmvv::goldens {

namespace {

/// The numbers of pairs after which a case is looked at.
constexpr std::array<std::size_t, 4> looks{9, 15, 25, 45};

/// The chance of one look to put the true median beyond one end of the interval. Over the four looks it adds up to
/// 0.48 %.
constexpr double chance_of_look = 0.003;

std::vector<double> values_of(const std::vector<CostPair>& pairs, const std::function<double(const CostPair&)>& value) {
  std::vector<double> values;
  for (const CostPair& pair : pairs) values.push_back(value(pair));
  return values;
}

/// The rank, from either end, of the values that bound the interval. 0 when even the extremes may miss the true median.
std::size_t rank_of_bounds(std::size_t n) {
  std::size_t k = 0;
  while (fits::at_most_heads(static_cast<double>(k), static_cast<double>(n)) <= chance_of_look) ++k;
  return k;
}

std::vector<double> first_logs_of(const std::vector<CostPair>& pairs) {
  std::vector<double> logs = values_of(pairs, [](const CostPair& p) { return std::log(p.now / p.baseline); });
  logs.resize(std::min(logs.size(), looks.front()));
  return logs;
}

Verdict judged(double least, double most, double band) {
  if (most <= band) return Verdict::pass;
  return least > band ? Verdict::fail : Verdict::inconclusive;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// A mean without the extremes, and the square of its standard error.
struct TrimmedMean {
  double mean = 0, variance = 0;
};

TrimmedMean trimmed_mean(std::vector<double> values) {
  std::ranges::sort(values);
  const auto kept = static_cast<double>(values.size() - 2);
  const double mean = std::accumulate(values.begin() + 1, values.end() - 1, 0.0) / kept;
  values.front() = values[1], values.back() = values[values.size() - 2];
  double squares = 0;
  for (const double value : values) squares += std::pow(value - mean_of(values), 2);
  return {mean, squares / (kept * (kept - 1))};
}

}  // namespace

Verdict CostRatio::verdict() const {
  return judged(least, most, cost_band);
}

Verdict MeanCost::verdict() const {
  return judged(least, most, mean_cost_band);
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
          .pairs = pairs.size(),
          .first_logs = first_logs_of(pairs)};
}

CostRatio measure_cost(const std::function<CostPair()>& measure) {
  std::vector<CostPair> pairs;
  CostRatio cost;
  for (const std::size_t look : looks) {
    while (pairs.size() < look) pairs.push_back(measure());
    cost = cost_ratio(pairs);
    if (cost.verdict() != Verdict::inconclusive) break;
  }
  return cost;
}

MeanCost mean_cost(const std::vector<CostRatio>& cases) {
  double sum = 0, variance = 0, squares = 0;
  for (const CostRatio& one : cases) {
    if (one.first_logs.size() != looks.front()) throw std::logic_error("a case of the mean cost needs its first pairs");
    const TrimmedMean log = trimmed_mean(one.first_logs);
    sum += log.mean, variance += log.variance, squares += log.variance * log.variance;
  }
  const double n = static_cast<double>(cases.size()), mean = sum / n;
  const double degrees_of_each = static_cast<double>(looks.front()) - 3;  // two are left out, and one is the mean's
  const double half_width =
      variance > 0 ? fits::student_t_99(degrees_of_each * variance * variance / squares) * std::sqrt(variance) / n : 0;
  return {std::exp(mean), std::exp(mean - half_width), std::exp(mean + half_width)};
}

Verdict verdict_of(const std::vector<CostRatio>& cases) {
  if (cases.empty()) return Verdict::inconclusive;
  std::vector<Verdict> verdicts{mean_cost(cases).verdict()};
  for (const CostRatio& one : cases) verdicts.push_back(one.verdict());
  for (const Verdict worst : {Verdict::fail, Verdict::inconclusive})
    if (std::ranges::find(verdicts, worst) != verdicts.end()) return worst;
  return Verdict::pass;
}

}  // namespace mpmvv::goldens
