#include <algorithm>

#include "solver/basis/bases.hpp"
#include "studies/checks/basis_function.hpp"
#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"

namespace mpmvv::checks {

namespace {

/// A continuous, piecewise-linear function with slopes a1, a2, a3, breaks at 0 and l, and the value b at the first
/// break.
struct ThreePieces {
  double a1, a2, a3, b, l;

  double operator()(double x) const {
    if (x < 0) return b + a1 * x;
    if (x < l) return b + a2 * x;
    return b + a2 * l + a3 * (x - l);
  }

  /// Returns ∫ f from 0 to x.
  double antiderivative(double x) const {
    if (x < 0) return b * x + a1 * x * x / 2;
    if (x < l) return b * x + a2 * x * x / 2;
    return b * l + a2 * l * l / 2 + (b + a2 * l) * (x - l) + a3 * (x - l) * (x - l) / 2;
  }
};

/// Returns the integral of f over a particle of width dx at `delta`, less its value at the middle times dx, S (37).
double direct(const ThreePieces& f, double delta, double dx) {
  return f.antiderivative(delta + dx / 2) - f.antiderivative(delta - dx / 2) - f(delta) * dx;
}

double equation_39(const ThreePieces& f, double delta, double dx) {
  return (f.a3 - f.a2) * f.l * f.l / 2 + (f.a2 - f.a3) * f.l * dx / 2 + (f.a2 - f.a3) * f.l * delta +
         (f.a3 - f.a1) * delta * delta / 2 + (f.a1 - 2 * f.a2 + f.a3) * delta * dx / 2 + (f.a3 - f.a1) * dx * dx / 8;
}

/// Returns the same difference for the gradient of the solver's uGIMP, whose integral is its weight. The node lies l/2
/// from the first break, h = 1.
double direct_gimp(double l, double delta, double dx) {
  const BasisFunction<solver::UGimp> gimp(solver::UGimp{l});
  const double x = delta - l / 2;
  return gimp.weight(x + dx / 2) - gimp.weight(x - dx / 2) - gimp.gradient(x) * dx;
}

}  // namespace

/// Compares S (39) to (41) with the error computed directly, over random pieces and particles, claim S-jump.
CheckResult check_jump_errors() {
  Random random(20081);
  double worst_39 = 0, worst_40 = 0, worst_41 = 0;
  for (int k = 0; k < 10000; ++k) {
    const double l = random.uniform(0.02, 0.3);
    const double delta = random.uniform(0, l);
    const double spanning_both = 2 * std::max(delta, l - delta) * random.uniform(1, 1.5);
    const ThreePieces f{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3), l};
    keep_larger(worst_39, std::abs(direct(f, delta, spanning_both) - equation_39(f, delta, spanning_both)));

    const double equation_40 = -(spanning_both - l + 2 * (1 - spanning_both / l) * delta);
    keep_larger(worst_40, std::abs(direct_gimp(l, delta, spanning_both) - equation_40));

    const double dx = random.uniform(0, l), near = random.uniform(0, std::min(dx / 2, l - dx / 2));
    const double equation_41 = -(near * near - near * dx + dx * dx / 4) / l;
    keep_larger(worst_41, std::abs(direct_gimp(l, near, dx) - equation_41));
  }
  CheckResult result;
  result.add("equation_39", worst_39, "largest difference of S (39) and the direct error, 10000 random pieces");
  result.add("equation_40", worst_40, "largest difference of S (40) and the direct error, ugimp gradient");
  result.add("equation_41", worst_41, "largest difference of S (41) and the direct error, ugimp gradient");
  return result;
}

}  // namespace mpmvv::checks
