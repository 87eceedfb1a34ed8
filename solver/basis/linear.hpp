#pragma once
#include <cmath>

#include "solver/basis/basis.hpp"

namespace mpmvv::solver {

/// Piecewise-linear hats, S (17). A point on a node takes the gradient of the cell to its right, but on the domain's
/// last face that of the last cell. So a particle on either face of the domain reaches no ghost node. This holds where
/// (x - lower)/h is exact in floating point; on other grids its rounding decides on which side of a node a point is. As
/// the gradient on a node is one-sided, it needs a velocity on the far node of that cell, even if no other particle
/// gives that node mass. `least_weight` gives it some, too little to matter otherwise.
struct Linear {
  static constexpr std::string_view word = "linear";
  static constexpr int support = 2;
  static constexpr int extra_inside = 1;
  static constexpr int ghost = 2;
  static constexpr ParticleWidth width = ParticleWidth::none;
  static constexpr double least_weight = 1e-60;
  static constexpr double mass_cutoff = 1e-12;

  static double position(int i, int) { return i; }

  int evaluate(const AxisPoint& at, double* N, double* dN) const {
    const double cell = std::floor(at.xi) - (at.xi == at.cells ? 1. : 0.);
    const double t = at.xi - cell;
    N[0] = 1 - t + least_weight;
    N[1] = t + least_weight;
    dN[0] = -1;
    dN[1] = 1;
    return static_cast<int>(cell);
  }
};

}  // namespace mpmvv::solver
