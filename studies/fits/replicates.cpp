#include "studies/fits/replicates.hpp"

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <map>
#include <vector>

#include "studies/fits/distributions.hpp"

namespace mpmvv::fits {

namespace {

constexpr double least_probable = 0.05;  ///< a lack of fit less probable than this counts as real
constexpr double log_round_off = 1e-24;  ///< of sums of squares of logarithms

}  // namespace

ReplicateFit fit_replicates(std::span<const ErrorSample> samples, double from, double to) {
  const std::vector<ErrorSample> within_window = samples_within(samples, from, to);
  const auto has_logarithm = [](const ErrorSample& s) { return s.e > 0; };
  if (within_window.empty() || !std::ranges::all_of(within_window, has_logarithm)) return {};
  std::map<double, std::vector<double>> levels;  // log e by log h
  for (const ErrorSample& s : within_window) levels[std::log(s.h)].push_back(std::log(s.e));

  double n = 0, mean_x = 0, mean_y = 0;
  for (const auto& [x, ys] : levels)
    for (const double y : ys) ++n, mean_x += x, mean_y += y;
  mean_x /= n, mean_y /= n;
  double xx = 0, xy = 0;
  for (const auto& [x, ys] : levels)
    for (const double y : ys) xx += (x - mean_x) * (x - mean_x), xy += (x - mean_x) * (y - mean_y);
  const double slope = xy / xx;
  double within = 0, about = 0;  // sums of squares: within the levels, of their means about the line
  for (const auto& [x, ys] : levels) {
    double mean = 0;
    for (const double y : ys) mean += y / static_cast<double>(ys.size());
    for (const double y : ys) within += (y - mean) * (y - mean);
    const double miss = mean - mean_y - slope * (x - mean_x);
    about += static_cast<double>(ys.size()) * miss * miss;
  }

  ReplicateFit fit;
  const double m = static_cast<double>(levels.size()), free_within = n - m, free_about = m - 2;
  fit.observations = static_cast<int>(n);
  if (free_within < 1 || m < 2) return fit;
  fit.scatter = std::sqrt(within / free_within);
  if (free_about >= 1 && within > 0)
    fit.lack_of_fit = fisher_f_above(about / free_about / (within / free_within), free_about, free_within);
  else if (about > log_round_off)
    fit.lack_of_fit = 0;  // the replicates agree to the last digit but lie on no line
  fit.half_width = fit.lack_of_fit < least_probable ? student_t_95(free_about) * std::sqrt(about / free_about / xx)
                                                    : student_t_95(free_within) * fit.scatter / std::sqrt(xx);
  return fit;
}

ReplicateMean mean_of_replicates(std::span<const double> values) {
  const bool positive = std::ranges::all_of(values, [](double value) { return value > 0; });
  std::vector<double> numbers(values.begin(), values.end());
  if (positive) std::ranges::transform(numbers, numbers.begin(), [](double value) { return std::log(value); });
  const auto back = [positive](double number) { return positive ? std::exp(number) : number; };
  const double n = static_cast<double>(numbers.size()), mean = boost::math::statistics::mean(numbers);
  if (numbers.size() < 2) return {back(mean)};
  const double deviation = std::sqrt(boost::math::statistics::sample_variance(numbers));
  const double half_width = student_t_95(n - 1) * deviation / std::sqrt(n);
  return {back(mean), back(mean - half_width), back(mean + half_width)};
}

}  // namespace mpmvv::fits
