#include "solver/scene.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <stdexcept>
#include <variant>
#include <vector>

#include "solver/integrator/integrators.hpp"
#include "solver/velocity_update/affine.hpp"

namespace mpmvv::solver {

namespace {

/// Whether the grid and the boundaries are unchanged by the scene's images. With `middle` the plane y = 0 is in the
/// middle of the domain, and both faces of that axis have the same kind of boundary. With `diagonal` and
/// `quarter_turns` the first two axes have the same cells, lower ends and kinds of boundary, and for `quarter_turns`
/// the origin is in the middle of both. No face that has another as its image may be a wall, which moves on its own.
template <int D>
bool are_shared(const Scene<D>& scene) {
  if constexpr (D > 1) {
    const auto kind = [&](std::size_t face) { return scene.boundary[face].index(); };
    const auto is_wall = [&](std::size_t face) { return std::holds_alternative<Wall>(scene.boundary[face]); };
    const auto has_middle = [&](std::size_t d) {
      const double half = scene.h * scene.cells[d] / 2;
      return kind(2 * d) == kind(2 * d + 1) && std::abs(scene.lower.data()[d] + half) <= 1e-12 * half;
    };
    if (is_wall(2) || is_wall(3)) return false;
    if (scene.images == Images::middle) return has_middle(1);
    return scene.cells[0] == scene.cells[1] && scene.lower[0] == scene.lower[1] && kind(0) == kind(2) &&
           kind(1) == kind(3) && (scene.images == Images::diagonal || has_middle(0));
  }
  return false;
}

/// Throws std::invalid_argument, with this text, if something does not hold.
void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

/// Requires that the nodes are there on which faces act. The images of ghosts must lie inside the domain: the other
/// face acts on those that lie on it or beyond.
template <int D>
void require_nodes_for_faces(const Scene<D>& scene) {
  const int ghosts = ghosts_of(scene.basis);
  const int layers = ghosts - reach(width_of(scene.basis));  // without those for corners that stick out
  for (std::size_t face = 0; face < scene.boundary.size(); ++face) {
    const AnyBoundary& boundary = scene.boundary[face];
    const bool is_mirror = std::holds_alternative<Mirror>(boundary);
    const bool is_symmetry = std::holds_alternative<Symmetry>(boundary);
    require(ghosts > 0 || !(is_mirror || std::holds_alternative<Periodic>(boundary)),
            "a periodic or mirror face of a basis without ghost nodes");
    require(!is_mirror || scene.cells[face / 2] > layers, "a mirror on an axis of too few cells");
    require(!is_symmetry || scene.cells[face / 2] > layers, "a plane of symmetry on an axis of too few cells");
  }
}

/// Requires that an axis is periodic on both faces or on neither, and that walls have a motion and a depth.
template <int D>
void require_faces(const Scene<D>& scene) {
  const auto is_periodic = [&](std::size_t face) { return std::holds_alternative<Periodic>(scene.boundary[face]); };
  for (std::size_t face = 0; face < scene.boundary.size(); face += 2)
    require(is_periodic(face) == is_periodic(face + 1), "an axis that is periodic on one face only");
  for (const AnyBoundary& boundary : scene.boundary)
    if (const auto* wall = std::get_if<Wall>(&boundary)) {
      require(wall->motion, "a wall without a motion");
      require(wall->depth >= 0 && std::isfinite(wall->depth), "a wall whose depth is not 0 or more");
    }
}

/// Requires that each particle has an entry in every field that the scheme reads.
template <int D>
void require_fields(const Scene<D>& scene) {
  const Particles<D>& particles = scene.particles;
  const std::size_t n = particles.size();
  for (const std::size_t size : {particles.id.size(), particles.v.size(), particles.F.size(), particles.m.size(),
                                 particles.V0.size(), particles.X.empty() ? n : particles.X.size()})
    require(size == n, "particles whose fields have different lengths");
  const ParticleWidth width = width_of(scene.basis);
  const bool is_reference = width == ParticleWidth::reference, is_current = width == ParticleWidth::current;
  require(!(is_reference || is_current) || particles.l.size() == n,
          "particles without the widths that the basis takes");
  require(!is_current || particles.l0.size() == n, "particles without the widths at rest that the basis takes");
  require(!is_reference || particles.l0.empty(), "widths that follow F with a basis whose widths do not");
  require(width != ParticleWidth::domain || (particles.R.size() == n && particles.R0.size() == n),
          "particles without the domains that the basis takes");
  for (const std::size_t size : {particles.l.size(), particles.R.size()})
    require(size == 0 || size == n, "particles whose fields have different lengths");
  require(particles.l0.empty() || particles.l0.size() == particles.l.size(), "widths at rest without widths");
  require(particles.R0.empty() || particles.R0.size() == particles.R.size(), "domains at rest without domains");
}

/// Requires masses and volumes, ids that no two particles share, and a surface load on particles that are there. What
/// can go wrong with the fields that a step advances is a `Fault`.
template <int D>
void require_particles(const Scene<D>& scene) {
  const Particles<D>& particles = scene.particles;
  require(particles.size() > 0, "a scene without particles");
  require(particles.size() <= INT_MAX, "more particles than indices can count");
  require_fields(scene);
  const auto is_amount = [](double amount) { return amount > 0 && std::isfinite(amount); };
  require(std::ranges::all_of(particles.m, is_amount), "a particle without a mass");
  require(std::ranges::all_of(particles.V0, is_amount), "a particle without a volume");
  std::vector<bool> is_there(particles.size());
  for (const std::uint32_t id : particles.id) {
    require(id < is_there.size() && !is_there[id], "particles whose ids are not 0, 1, ... in some order");
    is_there[id] = true;
  }
  if (!scene.surface_load) return;
  for (const auto& part : scene.surface_load->parts())
    require(part.particle < is_there.size(), "a load on the surface of a particle that is not there");
}

/// Requires that the parts of a scheme have numbers that they can take.
template <int D>
void require_numbers(const Scene<D>& scene) {
  if (const auto* gimp = std::get_if<UGimp>(&scene.basis))
    require(gimp->smoothing_length > 0 && gimp->smoothing_length <= 1, "a smoothing length that is not in (0, 1]");
  const double cutoff = scene.mass_cutoff.value_or(0);
  require(cutoff >= 0 && cutoff < 1, "a mass cutoff that is not in [0, 1)");
  if (const auto& mass = scene.consistent_mass) {
    require(mass->lumped_share >= 1e-12 && mass->lumped_share <= 1, "a lumped share that is not in [1e-12, 1]");
    require(mass->tolerance >= 1e-14 && mass->tolerance < 1, "a tolerance that is not in [1e-14, 1)");
    require(mass->covered >= 0 && mass->covered <= 1, "a fraction of covered mass that is not in [0, 1]");
  }
  std::visit(
      [&](const auto& update) {
        if constexpr (requires { update.order; })
          require(scene.consistent_mass || update.order > 0, "an expanded inverse without terms");
        if constexpr (requires { update.interval; }) require(update.interval > 0, "an expanded inverse every 0 steps");
      },
      scene.velocity_update);
}

/// Requires that the parts of a scheme can work together.
template <int D>
void require_scheme(const Scene<D>& scene) {
  const Integrator& integrator = integrator_named(scene.integrator);
  const AnyVelocityUpdate& update = scene.velocity_update;
  const bool keeps_history = std::visit([]<class M>(const M&) { return has_history<M>; }, scene.material);
  const bool has_affine = std::visit([]<class B>(const B&) { return has_affine_fields<B>; }, scene.basis);
  const bool has_wall = std::ranges::any_of(
      scene.boundary, [](const AnyBoundary& boundary) { return std::holds_alternative<Wall>(boundary); });
  require(!keeps_history || !integrator.is_staged, "a material with a history in stages");
  require(integrator.has_whole_steps() || !needs_whole_steps(update),
          "a velocity update other than flip, first order, with an integrator whose steps are staggered or staged");
  require(!integrator.is_staged || (scene.deformation == Deformation::linear && !scene.half_start),
          "exponential deformation or a half start in stages");
  require(!has_wall || integrator.has_whole_steps(),
          "a moving wall with an integrator whose steps are staggered or staged");
  require(!has_wall || !scene.consistent_mass || !adds_accelerations(update),
          "a moving wall with the consistent mass and a velocity update that adds accelerations");
  require(has_affine || !has_affine_field(update), "an affine velocity field on a basis without the weights for it");
  require(!scene.consistent_mass || takes_consistent_mass(update),
          "the consistent mass with a velocity update that lumped masses define");
  require(!scene.difference_acceleration || (!integrator.is_staged && !integrator.is_accelerated_first),
          "differences for accelerations at walls with an integrator that has none to take");
  require(!scene.difference_acceleration || (!scene.consistent_mass && adds_accelerations(update)),
          "differences for accelerations at walls, of which nothing is made");
}

}  // namespace

template <int D>
void require_sound(const Scene<D>& scene) {
  require(scene.h > 0 && std::isfinite(scene.h), "cells without a width");
  require(scene.lower.allFinite(), "a domain without a lower corner");
  for (const int cells : scene.cells) require(cells > 0, "an axis without cells");
  require(scene.threads > 0, "a scene without threads");
  require(scene.least_in_slab > 0, "a scene with slabs without particles");
  require_particles(scene);
  require(scene.images == Images::none || are_shared(scene), "images that the grid or the boundaries do not share");
  require_faces(scene);
  require_nodes_for_faces(scene);
  require_numbers(scene);
  require_scheme(scene);
}

template void require_sound<1>(const Scene<1>&);
template void require_sound<2>(const Scene<2>&);
template void require_sound<3>(const Scene<3>&);

}  // namespace mpmvv::solver
