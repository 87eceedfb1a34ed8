#pragma once
#include <cmath>

#include "solver/basis/basis.hpp"

namespace mpmvv::solver {

/// Piecewise-linear hats, S (17). On a node the gradient is that of the cell to its right, but on the domain's
/// last face that of the last cell, so that a particle on either face of a body reaches no ghost node.
struct Linear {
  static constexpr std::string_view word = "linear";
  static constexpr int support = 2;
  static constexpr int extra_inside = 1;
  static constexpr int ghost = 2;
  static constexpr ParticleWidth width = ParticleWidth::none;

  int evaluate(const AxisPoint& at, double* N, double* dN) const {
    const int cell = static_cast<int>(std::floor(at.xi)) - (at.xi == at.cells ? 1 : 0);
    const double t = at.xi - cell;
    N[0] = 1 - t;
    N[1] = t;
    dN[0] = -1;
    dN[1] = 1;
    return cell;
  }
};

}  // namespace mpmvv::solver
