#pragma once
#include "solver/basis/linear.hpp"

namespace mpmvv::solver {

/// Convected particle domain interpolation of the hats: see solver/stencils/cpdi_stencil.hpp.
struct Cpdi : Linear {
  static constexpr std::string_view word = "cpdi";
  static constexpr int ghost = Linear::ghost + domain_reach;
  static constexpr ParticleWidth width = ParticleWidth::domain;
};

}  // namespace mpmvv::solver
