#pragma once
#include <cmath>

#include "solver/basis/basis.hpp"

namespace mpmvv::solver {

/// Evaluates the three quadratic B-splines that do not vanish on a knot span, and their slopes, at t in [0, 1] from the
/// left knot: S (21), with the middle one of the three nodes at t = 1/2 and the others at t = -1/2 and 3/2.
inline void quadratic_pieces(double t, double* N, double* dN) {
  N[0] = 0.5 * (1 - t) * (1 - t);
  N[1] = 0.75 - (t - 0.5) * (t - 0.5);
  N[2] = 0.5 * t * t;
  dN[0] = t - 1;
  dN[1] = 1 - 2 * t;
  dN[2] = t;
}

/// Evaluates the four cubic B-splines that do not vanish on a knot span, and their slopes, at t in [0, 1] from the left
/// knot.
inline void cubic_pieces(double t, double* N, double* dN) {
  const double s = 1 - t, ss = s * s, tt = t * t;
  N[0] = ss * (1. / 6 * s);
  N[1] = 2. / 3 - tt * (1 - 0.5 * t);
  N[2] = 2. / 3 - ss * (1 - 0.5 * s);
  N[3] = tt * (1. / 6 * t);
  dN[0] = -0.5 * ss;
  dN[1] = 1.5 * tt - 2 * t;
  dN[2] = 2 * s - 1.5 * ss;
  dN[3] = 0.5 * tt;
}

/// Quadratic B-splines centred on the nodes, S (19) to (21); ghost nodes keep the partition of unity at a face.
struct BSpline2 {
  static constexpr std::string_view word = "bspline2";
  static constexpr int support = 3;
  static constexpr int extra_inside = 1;
  static constexpr int ghost = 2;
  static constexpr ParticleWidth width = ParticleWidth::none;

  static double position(int i, int) { return i; }

  int evaluate(const AxisPoint& at, double* N, double* dN) const {
    const double left_knot = std::floor(at.xi - 0.5);
    quadratic_pieces(at.xi - 0.5 - left_knot, N, dN);
    return static_cast<int>(left_knot);
  }
};

/// Cubic B-splines centred on the nodes.
struct BSpline3 {
  static constexpr std::string_view word = "bspline3";
  static constexpr int support = 4;
  static constexpr int extra_inside = 1;
  static constexpr int ghost = 2;
  static constexpr ParticleWidth width = ParticleWidth::none;

  static double position(int i, int) { return i; }

  int evaluate(const AxisPoint& at, double* N, double* dN) const {
    const double left_knot = std::floor(at.xi);
    cubic_pieces(at.xi - left_knot, N, dN);
    return static_cast<int>(left_knot) - 1;
  }
};

}  // namespace mpmvv::solver
