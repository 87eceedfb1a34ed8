#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "studies/fits/observed_order.hpp"

namespace mpmvv::fits {
namespace {

constexpr std::size_t least_points = 6;
constexpr double least_share = 0.5;        // of E0 in the finest error
constexpr double largest_residual = 0.05;  // root mean square, relative
constexpr double least_gain = 5;           // power law's residual over ours
constexpr double round_off = 1e-6;         // residuals below it are equal
constexpr double largest_miss = 0.1;       // of the predicted finest error, relative

struct OrderRange {
  double lowest = 0, highest = 0;
};
constexpr OrderRange floor_orders{0.1, 8}, power_orders{-8, 8};

struct Model {
  double order = 0, constant = 0, floor = 0;
  double mean_square = 0;  // of the relative misfit

  double at(double h) const { return constant * std::pow(h, order) + floor; }
  double residual() const { return std::sqrt(mean_square); }
};

using Samples = std::span<const ErrorSample>;

Model with_misfit(Model model, Samples samples) {
  for (const ErrorSample& s : samples) {
    const double r = model.at(s.h) / s.e - 1;
    model.mean_square += r * r / static_cast<double>(samples.size());
  }
  return model;
}

/// Sums of the normal equations of min Σ (C a + E0 b - 1)², a = h^p/e, b = 1/e.
struct NormalEquations {
  double aa = 0, ab = 0, bb = 0, a = 0, b = 0;

  NormalEquations(Samples samples, double p) {
    for (const ErrorSample& s : samples) {
      const double a_s = std::pow(s.h, p) / s.e, b_s = 1 / s.e;
      aa += a_s * a_s;
      ab += a_s * b_s;
      bb += b_s * b_s;
      a += a_s;
      b += b_s;
    }
  }
};

Model power_law(Samples samples, double p) {
  const NormalEquations sums(samples, p);
  return with_misfit({.order = p, .constant = sums.a / sums.aa}, samples);
}

/// Non-negative least squares in two unknowns: an unknown that is negative in the free solution is zero at the minimum.
Model power_law_with_floor(Samples samples, double p) {
  const NormalEquations sums(samples, p);
  const double determinant = sums.aa * sums.bb - sums.ab * sums.ab;
  if (determinant <= 1e-12 * sums.aa * sums.bb) return power_law(samples, p);
  const double constant = (sums.a * sums.bb - sums.b * sums.ab) / determinant;
  const double floor = (sums.b * sums.aa - sums.a * sums.ab) / determinant;
  if (floor < 0) return power_law(samples, p);
  if (constant < 0) return with_misfit({.order = p, .floor = sums.b / sums.bb}, samples);
  return with_misfit({.order = p, .constant = constant, .floor = floor}, samples);
}

/// The misfit may have several minima in p: a scan finds the lowest, Brent's method refines it.
template <class ModelAtOrder>
Model best_model(const ModelAtOrder& model, OrderRange range) {
  constexpr double step = 0.1;
  constexpr int bits = std::numeric_limits<double>::digits / 2;
  Model best = model(range.lowest);
  const auto steps = std::lround((range.highest - range.lowest) / step);
  for (long k = 1; k <= steps; ++k)
    if (const Model m = model(range.lowest + static_cast<double>(k) * step); m.mean_square < best.mean_square) best = m;

  std::uintmax_t evaluations = 100;
  const double order = boost::math::tools::brent_find_minima(
                           [&](double p) { return model(p).mean_square; }, std::max(range.lowest, best.order - step),
                           std::min(range.highest, best.order + step), bits, evaluations)
                           .first;
  const Model refined = model(order);
  return refined.mean_square < best.mean_square ? refined : best;
}

Model best_power_law(Samples samples) {
  return best_model([&](double p) { return power_law(samples, p); }, power_orders);
}

Model best_power_law_with_floor(Samples samples) {
  return best_model([&](double p) { return power_law_with_floor(samples, p); }, floor_orders);
}

struct Evidence {
  double share = 0;           // E0 over the error at the finest level
  double residual = 0;        // of the model
  double power_residual = 0;  // of the best power law
  double miss = 0;            // relative, at the finest level, of the model fitted without it
  double order = 0;
};

/// `samples` from coarse to fine.
Evidence gather(const Model& model, Samples samples) {
  const ErrorSample& finest = samples.back();
  const Model coarse = best_power_law_with_floor(samples.first(samples.size() - 1));
  return {.share = model.floor / finest.e,
          .residual = model.residual(),
          .power_residual = best_power_law(samples).residual(),
          .miss = std::abs(coarse.at(finest.h) / finest.e - 1),
          .order = model.order};
}

/// The first acceptance test that fails, empty when none does.
std::string flaw(const Evidence& e) {
  constexpr double edge = 1e-3;
  if (!(e.share >= least_share))
    return fmt::format("the floor is {:.2g} of the finest error (at least {} needed)", e.share, least_share);
  if (!(e.residual <= largest_residual))
    return fmt::format("residual {:.2g} (at most {} allowed)", e.residual, largest_residual);
  if (!(e.power_residual >= least_gain * std::max(e.residual, round_off)))
    return fmt::format("residual {:.2g} is not clearly below the power law's {:.2g} (a factor of {} needed)",
                       e.residual, e.power_residual, least_gain);
  if (!(e.miss <= largest_miss))
    return fmt::format("fitted without the finest level it misses the error there by {:.2g} of it (at most {} allowed)",
                       e.miss, largest_miss);
  if (e.order < floor_orders.lowest + edge || e.order > floor_orders.highest - edge)
    return fmt::format("order {:.2g} lies at the end of the range searched", e.order);
  return {};
}

std::string praise(const Evidence& e) {
  return fmt::format(
      "residual {:.2g}, power law's {:.2g}; the floor is {:.2g} of the finest error, predicted to {:.2g}", e.residual,
      e.power_residual, e.share, e.miss);
}

}  // namespace

FloorFit fit_floor(std::span<const ErrorSample> samples, double from, double to) {
  std::vector<ErrorSample> fitted = usable_samples(samples, from, to);
  FloorFit fit;
  if (fitted.size() < least_points) {
    fit.reason = fmt::format("not fitted: {} usable points in the window ({} needed)", fitted.size(), least_points);
    return fit;
  }
  std::stable_sort(fitted.begin(), fitted.end(), [](const auto& a, const auto& b) { return a.h > b.h; });

  const Model model = best_power_law_with_floor(fitted);
  const Evidence evidence = gather(model, fitted);
  const std::string why_not = flaw(evidence);
  fit.constant = model.constant;
  fit.order = model.order;
  fit.floor = model.floor;
  fit.residual = evidence.residual;
  fit.accepted = why_not.empty();
  fit.reason = fit.accepted ? "accepted: " + praise(evidence) : "rejected: " + why_not;
  return fit;
}

}  // namespace mpmvv::fits
