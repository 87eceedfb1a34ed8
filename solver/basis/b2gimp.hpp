#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/basis/bspline.hpp"

namespace mpmvv::solver {

/// B2GIMP: quadratic B-splines averaged over a box of the particle's reference width l <= h, N §2.1. The mean is exact:
/// the box is cut at the knot inside it, and two Gauss points integrate the quadratic on either side. With l = h the
/// mean is the cubic B-spline; the basis therefore has four nodes.
struct B2Gimp {
  static constexpr std::string_view word = "b2gimp";
  static constexpr int support = 4;
  static constexpr int extra_inside = 1;
  static constexpr int ghost = 2;
  static constexpr ParticleWidth width = ParticleWidth::reference;

  static double position(int i, int) { return i; }

  int evaluate(const AxisPoint& at, double* N, double* dN) const {
    const double cell = std::floor(at.xi), knot = cell + 0.5;
    const double cut = std::clamp((knot - at.xi) / at.width, -0.5, 0.5);  // distance from the particle, in widths
    std::fill_n(N, support, 0.0);
    std::fill_n(dN, support, 0.0);
    add_share(-0.5, cut, at, knot - 1, N, dN);
    add_share(cut, 0.5, at, knot, N + 1, dN + 1);
    return static_cast<int>(cell) - 1;
  }

 private:
  /// Adds the contribution of one part of the box to the means N and dN. The part lies between `from` and `to`, in
  /// widths from the particle, on the span that begins at `knot`.
  static void add_share(double from, double to, const AxisPoint& at, double knot, double* N, double* dN) {
    const double share = to - from;
    const double middle = at.xi - knot + 0.5 * (from + to) * at.width, half = 0.5 * share * at.width;
    for (const double side : {-1, 1}) {
      double part[3], slope[3];
      quadratic_pieces(middle + side * half / std::numbers::sqrt3, part, slope);
      for (int i = 0; i < 3; ++i) {
        N[i] += 0.5 * share * part[i];
        dN[i] += 0.5 * share * slope[i];
      }
    }
  }
};

}  // namespace mpmvv::solver
