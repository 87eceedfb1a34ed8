#include <fmt/format.h>

#include <algorithm>

#include "solver/basis/open_bspline.hpp"
#include "studies/checks/basis_function.hpp"
#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"

namespace mpmvv::checks {

namespace {

constexpr int cells = 6;

/// The largest errors of one open-knot basis over a fine set of points.
template <class B>
struct Violations {
  double unity = 0, gradient_sum = 0, slope = 0, boundary = 0;
  int functions = 0;

  Violations() {
    constexpr int degree = B::support - 1;
    const auto greville = [](int i) {  // mean of the inner knots: the coefficient of function i for the field x
      double sum = 0;
      for (int j = 1; j <= degree; ++j) sum += std::clamp(i - degree + j, 0, cells);
      return sum / degree;
    };
    for (const double x : linspace(0, cells, 6000)) {
      double N[B::support], dN[B::support];
      const int first = B{}.evaluate({x, cells, 0}, N, dN);
      double sum = 0, dsum = 0, field = 0, slope_of_field = 0;
      for (int k = 0; k < B::support; ++k) {
        sum += N[k], dsum += dN[k];
        field += greville(first + k) * N[k];
        slope_of_field += greville(first + k) * dN[k];
      }
      keep_larger(unity, std::abs(sum - 1));
      keep_larger(gradient_sum, std::abs(dsum));
      keep_larger(slope, std::abs(field - x));
      keep_larger(slope, std::abs(slope_of_field - 1));
      functions = std::max(functions, first + B::support);
      if (x == 0) keep_larger(boundary, std::abs(N[0] - 1));
      if (x == cells) keep_larger(boundary, std::abs(N[degree] - 1));
    }
  }
};

template <class B>
void add_violations(CheckResult& result, const std::string& name) {
  const Violations<B> v;
  const std::string basis(B::word);
  result.add(name + "_unity", v.unity, fmt::format("{}: largest |sum N - 1|", basis));
  result.add(name + "_gradient_sum", v.gradient_sum, fmt::format("{}: largest |sum dN|", basis));
  result.add(name + "_boundary", v.boundary,
             fmt::format("{}: largest |N - 1| of the first and last function on their face", basis));
  result.add(name + "_slope", v.slope, fmt::format("{}: largest error of value and slope of the field x", basis));
  result.add(name + "_functions", v.functions - cells, fmt::format("{}: functions beyond one per cell", basis));
}

template <class B>
void add_curves(CheckResult& result, const std::string& prefix) {
  const auto x = linspace(0, cells, 600);
  for (int i = 0; i < cells + B::support - 1; ++i) {
    std::vector<double> y;
    for (const double xi : x) {
      double N[B::support], dN[B::support];
      const int k = i - B{}.evaluate({xi, cells, 0}, N, dN);
      y.push_back(k >= 0 && k < B::support ? N[k] : 0);
    }
    result.add_curve(fmt::format("{} {}", prefix, i + 1), x, y);
  }
}

}  // namespace

/// Measures claim S-open, S §3.2, and adds the curves of S Fig. 3.
CheckResult check_open_bases() {
  CheckResult result;
  add_violations<solver::BSpline2Open>(result, "quadratic");
  add_violations<solver::BSpline3Open>(result, "cubic");
  add_curves<solver::BSpline2Open>(result, "quadratic");
  add_curves<solver::BSpline3Open>(result, "cubic");
  return result;
}

}  // namespace mpmvv::checks
