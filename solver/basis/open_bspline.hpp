#pragma once
#include <algorithm>
#include <cmath>

#include "solver/basis/bspline.hpp"

namespace mpmvv::solver {

/// Evaluates the `order` B-splines that do not vanish on a knot span, and their gradients, by the recursion of Cox and
/// de Boor, S (22), (23). The open uniform knot vector is 0, ..., 0, 1, 2, ..., cells, ..., cells. Its end knots have
/// multiplicity `order`, which gives cells + order - 1 functions (the text's multiplicity order - 1 does not:
/// docs/misprints.md, M1). `span` is the index of the cell, and also that of the first function. N and dN have `order`
/// entries.
template <int order>
void cox_de_boor(double xi, int span, int cells, double* N, double* dN) {
  const auto knot = [cells](int i) { return static_cast<double>(std::clamp(i, 0, cells)); };
  double lower[order] = {};  // the functions of order k - 1
  N[0] = 1;
  for (int k = 2; k <= order; ++k) {
    std::copy(N, N + k - 1, lower);
    std::fill(N, N + k, 0.0);
    std::fill(dN, dN + k, 0.0);
    for (int j = 0; j + 1 < k; ++j) {
      const double left = knot(span - k + 2 + j), right = knot(span + 1 + j);
      const double share = lower[j] / (right - left);
      N[j] += share * (right - xi);
      N[j + 1] += share * (xi - left);
      dN[j] -= (k - 1) * share;
      dN[j + 1] += (k - 1) * share;
    }
  }
}

/// B-splines on an open knot vector, S §3.2: there are no ghost nodes, and on each face one function equals 1. Away
/// from the faces they are the uniform B-splines.
template <int degree>
struct OpenBSpline {
  static_assert(degree == 2 || degree == 3);
  static constexpr std::string_view word = degree == 2 ? "bspline2-open" : "bspline3-open";
  static constexpr int support = degree + 1;
  static constexpr int extra_inside = degree;
  static constexpr int ghost = 0;
  static constexpr ParticleWidth width = ParticleWidth::none;

  /// Returns the Greville abscissa of a function, the mean of its inner knots, in cells.
  static double position(int i, int cells) {
    double sum = 0;
    for (int k = i - degree + 1; k <= i; ++k) sum += std::clamp(k, 0, cells);
    return sum / degree;
  }

  int evaluate(const AxisPoint& at, double* N, double* dN) const {
    const int span = std::min(static_cast<int>(std::floor(at.xi)), at.cells - 1);
    if (span < degree - 1 || span > at.cells - degree) {
      cox_de_boor<degree + 1>(at.xi, span, at.cells, N, dN);
    } else if constexpr (degree == 2) {
      quadratic_pieces(at.xi - span, N, dN);
    } else {
      cubic_pieces(at.xi - span, N, dN);
    }
    return span;
  }
};

using BSpline2Open = OpenBSpline<2>;
using BSpline3Open = OpenBSpline<3>;

}  // namespace mpmvv::solver
