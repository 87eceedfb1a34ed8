#pragma once
#include "solver/basis/bspline.hpp"

namespace mpmvv::solver {

/// Convected particle domain interpolation of quadratic B-splines: see solver/stencils/cpdi_stencil.hpp.
struct B2Cpdi : BSpline2 {
  static constexpr std::string_view word = "b2cpdi";
  static constexpr int ghost = BSpline2::ghost + domain_reach;
  static constexpr ParticleWidth width = ParticleWidth::domain;
};

}  // namespace mpmvv::solver
