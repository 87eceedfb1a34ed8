#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "solver/basis/bases.hpp"
#include "solver/body_force.hpp"
#include "solver/boundary/boundaries.hpp"
#include "solver/boundary/images.hpp"
#include "solver/consistent_mass_settings.hpp"
#include "solver/deformation.hpp"
#include "solver/material/materials.hpp"
#include "solver/particles.hpp"
#include "solver/surface_load.hpp"
#include "solver/velocity_update/velocity_updates.hpp"

namespace mpmvv::solver {

/// Where the body force is evaluated.
enum class BodyForceOn {
  particles,  ///< S (16)
  grid        ///< f_i = m_i b(x_i)
};

/// How walls hold velocities found by the expanded inverse, N §2.4.
enum class WallMethod {
  velocity,    ///< those found
  lumped,      ///< those that the expansion starts from
  combined,    ///< both
  elimination  ///< throughout: the expansion is that of the matrix without the nodes held
};

/// Everything a run is made from. Faces are ordered xmin, xmax, ymin, ...
template <int D>
struct Scene {
  Vec<D> lower = Vec<D>::Zero();
  double h = 1;
  Index<D> cells{};
  Particles<D> particles;
  AnyBasis basis;
  AnyMaterial material;
  std::array<AnyBoundary, 2 * D> boundary;
  Images images = Images::none;        ///< of the particles, which make the body with them
  BodyForce<D>* body_force = nullptr;  ///< none when null; must outlive the run
  BodyForceOn body_force_on = BodyForceOn::particles;
  const SurfaceLoad<D>* surface_load = nullptr;  ///< none when null; must outlive the run
  bool difference_acceleration = false;          ///< wall acceleration by S (30) instead of zero
  bool half_start = false;                       ///< the first grid acceleration halved, W §4
  std::string_view integrator = "usl";
  AnyVelocityUpdate velocity_update;
  Deformation deformation = Deformation::linear;
  WallMethod wall_method = WallMethod::combined;
  int threads = 1;
  /// A node is accelerated when its mass exceeds this fraction of a full cell's (the mean particle mass density times
  /// h^D), by default `mass_cutoff_of` the basis; every node with mass has a velocity. Up to 1e-10 it does not decide a
  /// result where the motion meets the walls squarely (tests show it). GIMP sheared along a symmetry wall does depend
  /// on it: a particle that overlaps the wall by e gives a ghost node a mass of order e² and a shear force of order e.
  /// With CPDI both are of order e, and the cutoff changes results in proportion to itself.
  std::optional<double> mass_cutoff;
  std::optional<ConsistentMassSettings> consistent_mass;  ///< lumped when empty
};

}  // namespace mpmvv::solver
