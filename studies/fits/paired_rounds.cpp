#include "studies/fits/paired_rounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

#include "studies/fits/distributions.hpp"

namespace mpmvv::fits {

namespace {

constexpr std::size_t least_rounds = 3;

/// The geometric mean of each case's costs without those of one round.
std::vector<double> means_without(std::size_t round, std::span<const Rounds> paired) {
  std::vector<double> means;
  for (std::vector<double> costs : paired | std::views::transform(&Rounds::costs)) {
    costs.erase(costs.begin() + static_cast<std::ptrdiff_t>(round));
    means.push_back(geometric_mean(costs));
  }
  return means;
}

/// Half the width of the interval of what the jackknife gave.
double half_width_of(const std::vector<double>& without_one) {
  const auto n = static_cast<double>(without_one.size());
  double sum = 0, squares = 0;
  for (const double value : without_one) sum += value;
  for (const double value : without_one) squares += std::pow(value - sum / n, 2);
  return student_t_95(n - 1) * std::sqrt((n - 1) / n * squares);
}

}  // namespace

double geometric_mean(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

bool are_paired(std::span<const Rounds> all) {
  return !all.empty() && !all[0].session.empty() && all[0].costs.size() >= least_rounds &&
         std::ranges::all_of(all, [&](const Rounds& one) {
           return one.session == all[0].session && one.costs.size() == all[0].costs.size();
         });
}

Estimate over_rounds(std::span<const Rounds> paired, const std::function<double(std::span<const double>)>& number) {
  std::vector<double> means, without_one;
  for (const Rounds& one : paired) means.push_back(geometric_mean(one.costs));
  const double value = number(means);
  for (std::size_t round = 0; round < paired[0].costs.size(); ++round)
    without_one.push_back(number(means_without(round, paired)));
  if (!std::ranges::all_of(without_one, [](double x) { return std::isfinite(x); }) || !std::isfinite(value))
    return {value, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  if (value > 0 && std::ranges::min(without_one) > 0) {
    for (double& x : without_one) x = std::log(x);
    const double factor = std::exp(half_width_of(without_one));
    return {value, value / factor, value * factor};
  }
  const double half = half_width_of(without_one);
  return {value, value - half, value + half};
}

}  // namespace mpmvv::fits
