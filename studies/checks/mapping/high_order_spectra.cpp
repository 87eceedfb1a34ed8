#include <algorithm>
#include <cmath>
#include <string>

#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/matrix_product.hpp"
#include "studies/checks/mapping/particle_tiling.hpp"
#include "studies/checks/mapping/spectrum.hpp"

namespace mpmvv::checks::mapping {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr int most_terms = 64;

/// A free elastic bar of ten cells in one dimension, linear about its state of rest, with h = E = ρ = 1 (then the CFL
/// number is Δt). It holds the matrices of FMPM(k) with USL and GIMP, N table 1.
class LinearBar {
 public:
  explicit LinearBar(const ParticleTiling<1>& tiling) : volumes_(tiling.volumes()) {
    const OverlayGrid<1> grid{solver::Vec<1>(0), solver::Vec<1>(1), {16}};
    const NodalBasis<1> basis(solver::Gimp{}, grid);
    const Matrix S = Matrix(basis.weights(tiling.x, tiling.width)).transpose();
    const Matrix G = Matrix(basis.gradients(0, tiling.x, tiling.width)).transpose();
    const Vector masses = S.transpose() * volumes_;
    std::vector<int> reached;
    for (int n = 0; n < masses.size(); ++n)
      if (masses[n] > 1e-12) reached.push_back(n);
    m_ = masses(reached);
    S_ = Matrix(S(Eigen::all, reached));
    G_ = Matrix(G(Eigen::all, reached));
    round_trip_ = m_.cwiseInverse().asDiagonal() * matrix_product(S_.transpose() * volumes_.asDiagonal(), S_);
  }

  /// Returns the largest of (1 - (1 - s)^k)/s over the eigenvalues s of S⁺S. By this factor the expansion multiplies a
  /// mode of the lumped velocity.
  double gain(int order) const {
    const Vector root = m_.cwiseSqrt();
    const Matrix symmetric = root.asDiagonal() * round_trip_ * root.cwiseInverse().asDiagonal();
    double largest = 0;
    for (const double s : symmetric_eigenvalues(symmetric))
      keep_larger(largest, s > 1e-14 ? -std::expm1(order * std::log1p(-std::min(s, 1.0))) / s : order);
    return largest;
  }

  /// Returns the spectral radius of the map of a step from the velocities V and strains e of the particles to the next
  /// ones: v⁺ = m̃_k⁻¹ (SᵀMV - Δt Gᵀ V⁰ e), V' = S v⁺, e' = e + Δt G v⁺.
  double spectral_radius(int order, double dt) const {
    const Eigen::Index n = volumes_.size();
    Matrix from_particles(m_.size(), 2 * n);
    from_particles << S_.transpose() * volumes_.asDiagonal(), -dt * G_.transpose() * volumes_.asDiagonal();
    const Matrix lumped = m_.cwiseInverse().asDiagonal() * from_particles;
    Matrix v = lumped;
    for (int term = 1; term < order; ++term) v += lumped - matrix_product(round_trip_, v);
    Matrix map = Matrix::Zero(2 * n, 2 * n);
    map.bottomRightCorner(n, n).setIdentity();
    map.topRows(n) += matrix_product(S_, v);
    map.bottomRows(n) += dt * matrix_product(G_, v);
    return mapping::spectral_radius(map);
  }

  /// Returns the CFL number up to which no mode grows, to a thousandth. A scan in steps of 0.05 finds the first number
  /// at which a mode grows, and bisection narrows the last step.
  double limit(int order) const {
    double stable = 0, unstable = 0.05;
    while (unstable < 4 && is_stable(order, unstable)) stable = unstable, unstable += 0.05;
    while (unstable - stable > 1e-3)
      (is_stable(order, (stable + unstable) / 2) ? stable : unstable) = (stable + unstable) / 2;
    return stable;
  }

  bool is_stable(int order, double dt) const { return spectral_radius(order, dt) <= 1 + 1e-9; }

 private:
  Vector volumes_, m_;
  Matrix S_, G_, round_trip_;
};

/// Returns bars with two particles per cell, at ten places in a cell.
std::vector<LinearBar> bars_in_motion() {
  std::vector<LinearBar> bars;
  for (int place = 0; place < 10; ++place)
    bars.emplace_back(uniform_tiling<1>(solver::Vec<1>(3 + 0.1 * place), solver::Vec<1>(10), {20}));
  return bars;
}

/// Returns bars of particles of uneven widths.
std::vector<LinearBar> uneven_bars() {
  std::vector<LinearBar> bars;
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    bars.emplace_back(
        random_tiling<1>(solver::Vec<1>(3.05 + 0.2 * static_cast<double>(seed)), solver::Vec<1>(10), {24}, seed));
  return bars;
}

void add_limits(const std::string& name, const std::vector<LinearBar>& bars, CheckResult& result) {
  std::vector<double> orders, limits, gains;
  double radius = 0;
  for (int k = 1; k <= most_terms; k *= 2) {
    double least = 4, gain = 0;
    for (const LinearBar& bar : bars) keep_smaller(least, bar.limit(k)), keep_larger(gain, bar.gain(k));
    for (const LinearBar& bar : bars) keep_larger(radius, bar.spectral_radius(k, least / 2));
    orders.push_back(k), limits.push_back(least), gains.push_back(gain);
  }
  result.add_curve("limit, " + name, orders, limits);
  result.add_curve("largest gain, " + name, orders, gains);
  result.add("limit_16_over_4, " + name, limits[4] / limits[2], "limit at k = 16 over that at k = 4, " + name);
  result.add("limit_64_over_16, " + name, limits[6] / limits[4], "limit at k = 64 over that at k = 16, " + name);
  result.add("gain_16, " + name, gains[4], "largest gain of a mode at k = 16, " + name);
  result.add("growth, " + name, radius - 1, "spectral radius less one at half the limit, k to 64, " + name);
}

}  // namespace

}  // namespace mpmvv::checks::mapping

namespace mpmvv::checks {

/// Measures limits of stability and largest gains of FMPM(k) on free linear bars, k up to 64: claim X-highk.
CheckResult check_high_order_spectra() {
  CheckResult result;
  mapping::add_limits("two per cell", mapping::bars_in_motion(), result);
  mapping::add_limits("uneven", mapping::uneven_bars(), result);
  return result;
}

}  // namespace mpmvv::checks
