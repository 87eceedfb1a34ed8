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
  grid        ///< f_i += m_i b at the position of the node (`BodyForce::at_position`)
};

/// Which velocities faces and walls hold where the expanded inverse is applied, N §2.4. `Step::holds_before_expansion`
/// and `Step::hold_after_expansion` (step_grid.hpp) decide by it.
enum class WallMethod {
  velocity,    ///< the expanded ones alone
  lumped,      ///< the lumped ones alone, from which the expansion starts
  combined,    ///< both
  elimination  ///< both, and no term of the expansion adds to held nodes: it expands on the free nodes alone
};

/// Everything a run is made from, in SI units. In one and two dimensions masses, volumes, forces and energies are per
/// m² and per m of the missing directions. Faces are ordered xmin, xmax, ymin, ...
template <int D>
struct Scene {
  Vec<D> lower = Vec<D>::Zero();  ///< lower corner of the domain, m
  double h = 1;                   ///< cell width, m
  Index<D> cells{};
  Particles<D> particles;
  AnyBasis basis;
  AnyMaterial material;
  std::array<AnyBoundary, 2 * D> boundary;
  Images images = Images::none;        ///< how their images continue the particles to the whole body
  BodyForce<D>* body_force = nullptr;  ///< none when null; must outlive the run
  BodyForceOn body_force_on = BodyForceOn::particles;
  const SurfaceLoad<D>* surface_load = nullptr;  ///< none when null; must outlive the run
  bool difference_acceleration = false;          ///< wall acceleration by S (30) instead of zero
  bool half_start = false;                       ///< halves the first grid acceleration, W §4
  std::string_view integrator = "usl";           ///< its word; must outlive the scene
  AnyVelocityUpdate velocity_update;
  Deformation deformation = Deformation::linear;
  WallMethod wall_method = WallMethod::combined;
  int threads = 1;
  /// How many particles a slab holds at least, on average, unless there is only one. Slabs are what threads share, and
  /// the blocks in smaller ones are not full: with 64 to a slab a step of a bar takes 1.1 times as long, with 32 it
  /// takes 1.25 times as long.
  std::size_t least_in_slab = 512;
  /// A node that no wall holds has an acceleration if its mass exceeds this fraction of a full cell's mass (the mean
  /// mass density of the particles at rest times h^D). The default is `mass_cutoff_of` the basis. Every node with mass
  /// has a velocity. Up to 1e-10 the cutoff does not change a result where the motion does not shear the body along
  /// walls (tests show it). Where a body is sheared along a symmetry wall, results of GIMP depend on it: a particle
  /// that overlaps the wall by e cells gives a ghost node a mass of order e² and a shear force of order e. With CPDI
  /// both are of order e, and results change in proportion to the cutoff.
  std::optional<double> mass_cutoff;
  std::optional<ConsistentMassSettings> consistent_mass;  ///< lumped mass when empty
};

/// Throws std::invalid_argument, which says why, for a scene that cannot be run.
template <int D>
void require_sound(const Scene<D>& scene);

}  // namespace mpmvv::solver
