#include <algorithm>

#include "solver/basis/bases.hpp"
#include "studies/checks/basis_function.hpp"
#include "studies/checks/check.hpp"

namespace mpmvv::checks {

namespace {

using namespace solver;

/// Returns the number of places in [-2, 2] at which the slope of f jumps: there its second difference, divided by the
/// step, exceeds 0.1.
template <class F>
int kinks(const F& f) {
  constexpr double step = 1e-4;
  int count = 0;
  double before = 0;
  for (int k = -20000; k <= 20000; ++k) {
    const double x = (k + 0.37) * step;
    const double jump = std::abs(f(x + step) - 2 * f(x) + f(x - step)) / step;
    if (jump > 0.1 && before <= 0.1) ++count;
    before = jump;
  }
  return count;
}

/// Returns the velocities sin(1.3 x_p) mapped to the grid and back, at the points `at`, as drawn in S Fig. 2:
///   v(x) = Σ_i N_i(x) Σ_p N_ip v_p / Σ_p N_ip
template <class B>
std::vector<double> mapped_field(const B& basis, const std::vector<double>& particles, const std::vector<double>& at) {
  constexpr int cells = 5, ghost = B::ghost, nodes = cells + 1 + 2 * ghost;
  double mass[nodes] = {}, momentum[nodes] = {};
  double N[B::support], dN[B::support];
  for (const double x : particles) {
    const int first = basis.evaluate({x, cells, 0.5}, N, dN) + ghost;
    for (int k = 0; k < B::support; ++k) mass[first + k] += N[k], momentum[first + k] += N[k] * std::sin(1.3 * x);
  }
  std::vector<double> field;
  for (const double x : at) {
    const int first = basis.evaluate({x, cells, 0.5}, N, dN) + ghost;
    double sum = 0;
    for (int k = 0; k < B::support; ++k)
      if (mass[first + k] > 0) sum += N[k] * momentum[first + k] / mass[first + k];
    field.push_back(sum);
  }
  return field;
}

}  // namespace

/// Measures claim S-fig4, with the curves of S Figs. 2 and 4: the GIMP weight looks smooth, its gradient has kinks.
CheckResult check_gimp_kinks() {
  constexpr double l = 0.5;
  const BasisFunction<UGimp> gimp(UGimp{l});
  const auto weight = [&gimp](double x) { return gimp.weight(x); };
  const auto gradient = [&gimp](double x) { return gimp.gradient(x); };
  CheckResult result;
  result.add("weight_kinks", kinks(weight), "kinks of the weight, l = h/2");
  result.add("gradient_kinks", kinks(gradient), "kinks of the gradient weight, l = h/2");
  const BasisFunction<UGimp> widest(UGimp{1});
  result.add("gradient_kinks_widest", kinks([&widest](double x) { return widest.gradient(x); }),
             "kinks of the gradient weight, l = h");

  const auto x = linspace(-1.5, 1.5, 600);
  std::vector<double> N, dN;
  for (const double xi : x) N.push_back(weight(xi)), dN.push_back(gradient(xi));
  result.add_curve("weight", x, N);
  result.add_curve("gradient weight", x, dN);
  const std::vector<double> breaks{-1 - l / 2, -1 + l / 2, -l / 2, l / 2, 1 - l / 2, 1 + l / 2};
  std::vector<double> at_breaks;
  for (const double kink : breaks) at_breaks.push_back(gradient(kink));
  result.add_curve("break points", breaks, at_breaks);

  const auto particles = linspace(0.25, 4.75, 9);
  const auto at = linspace(0, 5, 500);
  std::vector<double> values;
  for (const double p : particles) values.push_back(std::sin(1.3 * p));
  result.add_curve("particles", particles, values);
  result.add_curve("linear", at, mapped_field(Linear{}, particles, at));
  result.add_curve("bspline2", at, mapped_field(BSpline2{}, particles, at));
  result.add_curve("gimp, l = h/2", at, mapped_field(Gimp{}, particles, at));
  return result;
}

}  // namespace mpmvv::checks
