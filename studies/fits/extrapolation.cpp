#include "studies/fits/extrapolation.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace mpmvv::fits {

using support::not_measured;

namespace {

constexpr std::size_t least_grids = 4;
constexpr double least_order = 0.5, formal_order = 2, largest_sure_order = 2.1;
constexpr double bold_factor = 1.25, timid_factor = 3;
constexpr double lowest_order = 0.05, highest_order = 8;  ///< of the scan

enum class Weights { equal, finer_more };

/// One fitted model of the error.
struct ErrorModel {
  std::string form;
  double order = not_measured;  ///< of the free fit
  double limit = 0, at_finest = 0;
  double deviation = std::numeric_limits<double>::infinity();  ///< σ
};

/// Samples in order, from the finest grid to the coarsest.
using Grids = std::vector<ErrorSample>;

/// Squared weights that sum to the number of samples.
Eigen::VectorXd weights_of(const Grids& samples, Weights weights) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  if (weights == Weights::equal) return Eigen::VectorXd::Ones(n);
  Eigen::VectorXd w(n);
  for (Eigen::Index k = 0; k < n; ++k) w[k] = 1 / samples[static_cast<std::size_t>(k)].h;
  return w * (static_cast<double>(n) / w.sum());
}

/// Least squares of φ0 + Σ c_j h^powers_j; `unknowns` is how many unknowns the model has, for the degrees of freedom of
/// σ.
ErrorModel fit_model(const Grids& samples, Weights weights, const std::vector<double>& powers, int unknowns) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  const auto columns = static_cast<Eigen::Index>(powers.size()) + 1;
  Eigen::MatrixXd A(n, columns);
  Eigen::VectorXd phi(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const ErrorSample& s = samples[static_cast<std::size_t>(k)];
    A(k, 0) = 1;
    for (Eigen::Index j = 1; j < columns; ++j)
      A(k, j) = std::pow(s.h / samples.back().h, powers[static_cast<std::size_t>(j - 1)]);
    phi[k] = s.e;
  }
  const Eigen::VectorXd root = weights_of(samples, weights).cwiseSqrt();
  const Eigen::VectorXd c = (root.asDiagonal() * A).fullPivHouseholderQr().solve(root.cwiseProduct(phi));
  const Eigen::VectorXd misfit = root.cwiseProduct(A * c - phi);
  ErrorModel model;
  model.limit = c[0];
  model.at_finest = A.row(0).dot(c);
  model.deviation = std::sqrt(misfit.squaredNorm() / static_cast<double>(n - unknowns));
  return model;
}

/// φ0 + α h^p with the p of the least misfit: a scan finds its neighbourhood, Brent's method the value.
ErrorModel fit_power(const Grids& samples, Weights weights) {
  constexpr double step = 0.05;
  const auto misfit = [&](double p) { return fit_model(samples, weights, {p}, 3).deviation; };
  double best = lowest_order;
  for (int k = 1; k <= std::lround((highest_order - lowest_order) / step); ++k)
    if (const double p = lowest_order + k * step; misfit(p) < misfit(best)) best = p;
  std::uintmax_t evaluations = 100;
  best = boost::math::tools::brent_find_minima(misfit, std::max(lowest_order, best - step),
                                               std::min(highest_order, best + step),
                                               std::numeric_limits<double>::digits / 2, evaluations)
             .first;
  ErrorModel model = fit_model(samples, weights, {best}, 3);
  model.order = best;
  model.form = fmt::format("φ0 + α h^{:.2f}", best);
  return model;
}

ErrorModel named(ErrorModel model, const char* form) {
  model.form = form;
  return model;
}

/// The model that the procedure takes, and the order that the free fit found.
ErrorModel choose(const Grids& samples) {
  const auto better = [](const ErrorModel& a, const ErrorModel& b) { return a.deviation < b.deviation; };
  ErrorModel free = std::min(fit_power(samples, Weights::equal), fit_power(samples, Weights::finer_more), better);
  if (free.order >= least_order && free.order <= formal_order) return free;
  std::vector<ErrorModel> fixed;
  for (const Weights weights : {Weights::equal, Weights::finer_more}) {
    fixed.push_back(named(fit_model(samples, weights, {1}, 2), "φ0 + α h"));
    fixed.push_back(named(fit_model(samples, weights, {2}, 2), "φ0 + α h²"));
    if (free.order < least_order) fixed.push_back(named(fit_model(samples, weights, {1, 2}, 3), "φ0 + α h + β h²"));
  }
  ErrorModel best = *std::ranges::min_element(fixed, better);
  best.order = free.order;
  return best;
}

double uncertainty(const ErrorModel& model, const Grids& samples) {
  const auto [least, most] = std::ranges::minmax(samples, {}, &ErrorSample::e);
  const double range = (most.e - least.e) / static_cast<double>(samples.size() - 1);
  const double distance = std::abs(model.at_finest - model.limit), miss = std::abs(samples[0].e - model.at_finest);
  if (!(model.deviation < range)) {
    const double rest = distance + model.deviation + miss;
    return range > 0 ? timid_factor * model.deviation / range * rest : rest;
  }
  const bool sure = model.order >= least_order && model.order <= largest_sure_order;
  return (sure ? bold_factor : timid_factor) * distance + model.deviation + miss;
}

/// Roache's index or why there is none.
struct ConvergenceIndex {
  double value = not_measured;
  std::string missing;
};

/// The order p solves (h3^p - h2^p) / (h2^p - h1^p) = (φ3 - φ2) / (φ2 - φ1).
ConvergenceIndex convergence_index(const Grids& s) {
  if (s[1].e == s[0].e) return {not_measured, "no GCI: the two finest grids agree"};
  const double ratio = (s[2].e - s[1].e) / (s[1].e - s[0].e);
  if (!(ratio > 0)) return {not_measured, "no GCI: not monotone on the three finest grids"};
  const auto excess = [&](double p) {
    const double fine = std::pow(s[0].h / s[1].h, p), coarse = std::pow(s[2].h / s[1].h, p);
    return (coarse - 1) / (1 - fine) - ratio;
  };
  constexpr double lowest = 0.01, highest = 20;
  if (!(excess(lowest) < 0)) return {not_measured, "no GCI: changes do not shrink with the grid"};
  if (!(excess(highest) > 0)) return {not_measured, "no GCI: the two finest grids hardly differ"};
  std::uintmax_t evaluations = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      excess, lowest, highest, boost::math::tools::eps_tolerance<double>(40), evaluations);
  const double p = 0.5 * (low + high);
  return {bold_factor * std::abs(s[1].e - s[0].e) / (std::pow(s[1].h / s[0].h, p) - 1), ""};
}

std::string edge_of_scan(double order) {
  constexpr double near = 1e-3;
  if (order > lowest_order + near && order < highest_order - near) return "";
  return fmt::format("free order at the edge of the scan ({} to {})", lowest_order, highest_order);
}

}  // namespace

Extrapolation extrapolate(std::span<const ErrorSample> samples, double from, double to) {
  Grids chosen = samples_within(samples, from, to);
  std::ranges::stable_sort(chosen, {}, &ErrorSample::h);
  Extrapolation result;
  result.from = from;
  result.to = to;
  result.points = static_cast<int>(chosen.size());
  if (chosen.size() < least_grids) {
    result.model = fmt::format("none: {} usable points in the window ({} needed)", chosen.size(), least_grids);
    return result;
  }
  const ErrorModel model = choose(chosen);
  result.model = model.form;
  result.order = model.order;
  result.limit = model.limit;
  result.deviation = model.deviation;
  result.finest = chosen[0].e;
  result.uncertainty = uncertainty(model, chosen);
  const ConvergenceIndex index = convergence_index(chosen);
  result.convergence_index = index.value;
  const std::string edge = edge_of_scan(model.order);
  result.remark = index.missing + (index.missing.empty() || edge.empty() ? "" : "; ") + edge;
  return result;
}

}  // namespace mpmvv::fits
