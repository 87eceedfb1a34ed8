#pragma once
#include <algorithm>
#include <cmath>

#include "solver/basis/basis.hpp"

namespace mpmvv::solver {

/// Evaluates hats averaged over a box of full width l <= 1 around the point, and their gradients, S (29); xi and l are
/// in units of h. Let d be the signed distance from the nearest node, and c this distance clamped to ±l/2. The weights
/// of the two outer nodes are (l/2 ∓ c)²/2l + max(0, ±(c - d)), with the upper signs for the left node. This is (29)
/// without its case distinction. Returns the index of the left node.
inline int gimp_weights(double xi, double l, double* N, double* dN) {
  const double nearest = std::floor(xi + 0.5);
  const double d = xi - nearest;
  const double c = std::clamp(d, -0.5 * l, 0.5 * l);
  const double left = 0.5 * l - c, right = 0.5 * l + c;
  const double inverse = 1 / l;
  N[0] = 0.5 * left * left * inverse + std::max(c - d, 0.0);
  N[2] = 0.5 * right * right * inverse + std::max(d - c, 0.0);
  N[1] = 1 - N[0] - N[2];
  dN[0] = -left * inverse;
  dN[2] = right * inverse;
  dN[1] = -dN[0] - dN[2];
  return static_cast<int>(nearest) - 1;
}

/// uGIMP: the box has one width, the smoothing length, for all particles and all times. It may be any length in (0, h];
/// with h the basis is the quadratic B-spline.
struct UGimp {
  static constexpr std::string_view word = "ugimp";
  static constexpr int support = 3;
  static constexpr int extra_inside = 1;
  static constexpr int ghost = 2;
  static constexpr ParticleWidth width = ParticleWidth::none;

  double smoothing_length = 1;  ///< in units of h

  static double position(int i, int) { return i; }

  int evaluate(const AxisPoint& at, double* N, double* dN) const {
    return gimp_weights(at.xi, smoothing_length, N, dN);
  }
};

/// Standard GIMP: each particle keeps its reference width.
struct Gimp {
  static constexpr std::string_view word = "gimp";
  static constexpr int support = 3;
  static constexpr int extra_inside = 1;
  static constexpr int ghost = 2;
  static constexpr ParticleWidth width = ParticleWidth::reference;

  static double position(int i, int) { return i; }

  int evaluate(const AxisPoint& at, double* N, double* dN) const { return gimp_weights(at.xi, at.width, N, dN); }
};

/// cpGIMP: the width follows the particle's stretch, l_p = l_p⁰ diag F, W (7), (63).
struct CpGimp : Gimp {
  static constexpr std::string_view word = "cpgimp";
  static constexpr ParticleWidth width = ParticleWidth::current;
};

}  // namespace mpmvv::solver
