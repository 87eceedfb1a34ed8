#include "studies/codes/stresses.hpp"

#include <algorithm>
#include <cmath>

#include "studies/codes/output_fault.hpp"
#include "studies/codes/units.hpp"
#include "studies/runs/norms.hpp"

namespace mpmvv::codes {

using solver::Mat;

namespace {

template <int D>
Mat<D> exact_stress(const CaseParticles<D>& particles, const Vec<D>& X, double t) {
  const auto& solution = *particles.setup.solution;
  const Mat<D> F = solution.F(X, t);
  return solution.P(X, t) * F.transpose() / F.determinant();
}

template <int D>
Mat<D> written_stress(const Tensor& stress) {
  Mat<D> written;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) written(i, j) = stress[static_cast<std::size_t>(3 * i + j)];
  return written;
}

/// Sums over the lines of an end.
struct StressSums {
  double written = 0, exact = 0;                    ///< σ : σ, of the file and of the exact solution
  double both = 0;                                  ///< σ of the file : σ of the exact solution
  double displacement = 0, displacement_error = 0;  ///< |u(X, T)|², |u - u(X, T)|²
};

template <int D>
StressSums sums_over(const MatchedEnd<D>& end) {
  const double T = end.particles.end_time;
  StressSums sums;
  for (std::size_t line = 0; line < end.size(); ++line) {
    const Vec<D>& X = end.particles.X[end.particle[line]];
    const Mat<D> exact = exact_stress(end.particles, X, T), written = written_stress<D>(end.snapshot.stress[line]);
    sums.written += written.squaredNorm();
    sums.exact += exact.squaredNorm();
    sums.both += written.cwiseProduct(exact).sum();
    sums.displacement += end.particles.setup.solution->u(X, T).squaredNorm();
    sums.displacement_error += end.error(line, T).squaredNorm();
  }
  return sums;
}

/// Returns what the written stresses are times the exact ones, if it is about a power of 1000 or the negative of one;
/// else 1. Of displacements that are far off, the sign says nothing.
double factor_of(const StressSums& sums) {
  constexpr double band = 3;
  const double product = sums.written * sums.exact, ratio = std::sqrt(sums.written / sums.exact);
  if (!(sums.both * sums.both > 0.1 * product)) return 1;  // nothing like the exact ones
  const bool is_near = sums.displacement_error < sums.displacement / 16;
  const bool is_opposite = is_near && sums.both < 0 && sums.both * sums.both > 0.8 * product;
  for (const double factor : {1.0, 1e3, 1e6, 1e9, 1e-3, 1e-6, 1e-9})
    if (ratio < factor * band && ratio * band > factor) return is_opposite ? -factor : factor;
  return 1;
}

}  // namespace

void require_stresses(const Snapshot& end) {
  if (end.stress.empty())
    fail_output("no stresses in {} for stress_error (columns s_xx, ..., or leave it out)", end.file);
  for (const Tensor& stress : end.stress)
    if (!std::ranges::all_of(stress, [](double component) { return std::isfinite(component); }))
      fail_output("stresses that are no numbers in {}", end.file);
}

template <int D>
void require_stress_units(const MatchedEnd<D>& end) {
  const auto square = [&end](const Vec<D>& X, double t) { return exact_stress(end.particles, X, t).squaredNorm(); };
  if (end.snapshot.stress.empty() || !is_large_at_end(end.particles, square)) return;
  const double factor = factor_of(sums_over(end));
  if (factor == 1) return;
  const char* sign = factor < 0 ? "another sign? Tension is positive" : "";
  const char* unit =
      "another unit? Theirs is --mass-unit/(--length-unit --time-unit²), or the same of units of the adapter";
  fail_output("stresses in {} are about {:g} times those of the case ({}{}{}{})", end.snapshot.file, factor, sign,
              factor < 0 && std::abs(factor) != 1 ? "; " : "", std::abs(factor) != 1 ? unit : "",
              std::abs(factor) != 1 && D == 2 ? "; a thickness is no unit of mass: --thickness" : "");
}

template <int D>
double stress_error(const MatchedEnd<D>& end) {
  runs::ErrorNorms norms;
  for (std::size_t line = 0; line < end.size(); ++line) {
    const Vec<D>& X = end.particles.X[end.particle[line]];
    norms.add(
        (written_stress<D>(end.snapshot.stress[line]) - exact_stress(end.particles, X, end.particles.end_time)).norm());
  }
  return norms.l2();
}

template void require_stress_units(const MatchedEnd<1>&);
template void require_stress_units(const MatchedEnd<2>&);
template void require_stress_units(const MatchedEnd<3>&);
template double stress_error(const MatchedEnd<1>&);
template double stress_error(const MatchedEnd<2>&);
template double stress_error(const MatchedEnd<3>&);

}  // namespace mpmvv::codes
