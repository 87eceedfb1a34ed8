#pragma once
#include <compare>
#include <string>

namespace mpmvv::cases {

/// How a problem is solved. What each word means: docs/theory.md; they are checked in studies/settings/settings.hpp.
struct Scheme {
  std::string basis = "linear";
  double smoothing_length = 0;  ///< in cells; only for `ugimp`, 0 elsewhere
  std::string integrator = "usl";
  std::string start = "half";  ///< first step of `cd` and `uvf`; other integrators have no start
  std::string velocity_update = "flip";
  int order = 0;                         ///< k of `xpic` and `fmpm`, 0 elsewhere
  double cfl_x = 0;                      ///< CFL number of `fmpm`'s own steps; 0: every one
  std::string position = "first-order";  ///< how positions follow `flip`; others have a way of their own
  std::string wall_method = "none";      ///< how walls hold what `xpic` and `fmpm` expand; others expand nothing
  double wall_depth = 0;                 ///< cells inside a moving wall that it holds; 0 without one
  std::string wall_gradient = "none";    ///< of the velocity it holds; none without one
  std::string mass = "lumped";
  std::string boundary = "dirichlet";
  std::string wall_acceleration = "zero";
  std::string deformation = "linear";
  std::string body_force = "particles";
  std::string fill = "lattice";
  std::string material = "neo-hookean-log";

  auto operator<=>(const Scheme&) const = default;
};

}  // namespace mpmvv::cases
