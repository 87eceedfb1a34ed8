#include <cmath>

#include "solver/basis/bases.hpp"
#include "studies/checks/basis_function.hpp"
#include "studies/checks/check.hpp"

namespace mpmvv::checks {

namespace {

constexpr int tilings = 1600;

/// Returns Σ_p ∇N(x_p) V_p over one random tiling of the node's support by particles of mean width dx (widths drawn
/// from dx/2 to 3dx/2, a random start), with h = 1. This is the internal force of a constant unit stress, S (42), which
/// is exactly 0.
double force(const BasisFunction<solver::UGimp>& gimp, double l, double dx, Random& random) {
  const double end = 1 + l / 2 + 2 * dx;
  double sum = 0;
  for (double left = -end - random.uniform(0, dx); left < end;) {
    const double width = dx * random.uniform(0.5, 1.5);
    sum += gimp.gradient(left + width / 2) * width;
    left += width;
  }
  return sum;
}

}  // namespace

/// Measures the root mean square of `force` over random tilings against dx, for two smoothing lengths, claim S-fig6.
/// Above dx = l the values of dx lie twice as close, because with l = h/10 the range from there to h is short.
CheckResult check_force_quadrature() {
  CheckResult result;
  for (const auto& [l, name] : {std::pair{0.1, "l = h/10"}, std::pair{0.002, "l = h/500"}}) {
    const BasisFunction<solver::UGimp> gimp(solver::UGimp{l});
    Random random(20086);
    std::vector<double> widths, errors;
    for (double dx = l / 16; dx < 0.8; dx *= std::pow(2, dx < l ? 0.5 : 0.25)) {
      double sum = 0;
      for (int k = 0; k < tilings; ++k) {
        const double f = force(gimp, l, dx, random);
        sum += f * f;
      }
      widths.push_back(dx);
      errors.push_back(std::sqrt(sum / tilings));
    }
    result.add_curve(name, widths, errors);
  }
  return result;
}

}  // namespace mpmvv::checks
