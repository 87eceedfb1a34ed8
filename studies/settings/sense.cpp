#include "studies/settings/sense.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "solver/basis/bases.hpp"
#include "solver/boundary/wall.hpp"
#include "solver/integrator/words.hpp"
#include "solver/velocity_update/affine.hpp"
#include "solver/velocity_update/velocity_updates.hpp"
#include "studies/problems/problem.hpp"
#include "studies/settings/boundaries.hpp"
#include "studies/settings/named.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings {

using cases::Scheme;
using support::UsageError;

namespace {

bool is_affine(const solver::AnyBasis& basis) {
  return std::visit([]<class B>(const B&) { return solver::has_affine_fields<B>; }, basis);
}

void require_sense_of_mass(const cases::Case& c, int ghosts, bool mirrored) {
  if (c.scheme.mass != "consistent") return;
  if (c.scheme.wall_acceleration == "difference")
    throw UsageError(
        "wall_acceleration 'difference' with mass 'consistent', whose velocities are solved for with the walls held: "
        "there is none of theirs to take a difference from (use zero)");
  if (c.scheme.body_force == "grid")
    throw UsageError("body_force 'grid' with mass 'consistent', which m_i b(x_i) lumps again (use particles)");
  if (mirrored && c.resolution.cells <= 2 * ghosts)
    throw UsageError(fmt::format(
        "{} cells are too few for mass 'consistent' between mirrors (more than {}: no node may be the image "
        "of two ghosts)",
        c.resolution.cells, 2 * ghosts));
  if (c.resolution.ppc < 2)
    throw UsageError("mass 'consistent' with ppc = 1 (at least 2: it is singular with one particle per cell)");
}

void require_sense_of_velocity_update(const Scheme& s) {
  const bool plain = s.velocity_update == "flip" && s.position == "first-order";
  if (!plain && (solver::is_staggered(s.integrator) || s.integrator == "rk4"))
    throw UsageError(fmt::format(
        "velocity_update '{}' with integrator '{}' (flip with position 'first-order', or an integrator whose "
        "steps have positions and velocities at their ends: usl, usf, usavg, usl+, usavg+)",
        s.velocity_update, s.integrator));
  if (s.velocity_update == solver::Apic::word && !is_affine(named<solver::AnyBasis>(s.basis)))
    throw UsageError(fmt::format(
        "velocity_update '{}' with basis '{}' ({}: nodes a cell apart, whose weights spread wherever the particle is)",
        s.velocity_update, s.basis, fmt::join(words_with<solver::AnyBasis>(is_affine), ", ")));
  if (s.mass == "consistent" && s.velocity_update != "flip" && s.velocity_update != "fmpm")
    throw UsageError(
        fmt::format("mass 'consistent' with velocity_update '{}', which lumped masses define (use flip or fmpm)",
                    s.velocity_update));
  if (s.mass == "consistent" && (s.order > 0 || s.cfl_x > 0 || s.wall_method != "none"))
    throw UsageError(
        "order, cfl_x or wall_method with mass 'consistent', the limit in which nothing is expanded (leave it out)");
  if (s.velocity_update != "flip" && s.wall_acceleration == "difference")
    throw UsageError("wall_acceleration 'difference' with a velocity_update other than 'flip' (use zero)");
}

void require_sense_of_deformation(const Scheme& s) {
  if (s.deformation == "exponential" && s.integrator == "rk4")
    throw UsageError("deformation 'exponential' with integrator 'rk4', whose stages are linear (use linear)");
}

void require_sense_of_walls(const cases::Case& c, const problems::Problem& problem,
                            const std::vector<std::string>& faces) {
  const Scheme& s = c.scheme;
  bool moving = false;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (faces[k] != solver::Wall::word) continue;
    moving = true;
    if (!problem.has_wall(c.problem.parameters, k))
      throw UsageError(fmt::format("boundary '{}' on face {}{} of problem '{}', which has no moving wall there",
                                   solver::Wall::word, "xyz"[k / 2], k % 2 == 0 ? "min" : "max", problem.name));
  }
  if (!moving) return;
  if (solver::is_staggered(s.integrator) || solver::is_staged(s.integrator))
    throw UsageError(
        fmt::format("boundary 'wall' with integrator '{}' (one whose steps have positions and velocities at their "
                    "ends: usl, usf, usavg, usl+, usavg+)",
                    s.integrator));
  if (s.wall_acceleration == "difference")
    throw UsageError("wall_acceleration 'difference' with boundary 'wall', whose nodes have it anyway (leave it out)");
  if (s.mass == "consistent" && s.velocity_update != "fmpm")
    throw UsageError(
        fmt::format("boundary 'wall' with mass 'consistent' and velocity_update '{}' (use fmpm: it takes velocities, "
                    "where accelerations at walls are a difference of lumped ones)",
                    s.velocity_update));
}

}  // namespace

void require_sense(const cases::Case& c) {
  const Scheme& s = c.scheme;
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  const int dimension = problem.dimension();
  const auto faces = boundary_faces(s.boundary, dimension, "the case");
  const auto has = [&faces](const char* word) { return std::find(faces.begin(), faces.end(), word) != faces.end(); };

  const auto basis = named<solver::AnyBasis>(s.basis);
  const int ghosts = ghosts_of(basis);
  if (ghosts == 0 && (has("periodic") || has("mirror")))
    throw UsageError(
        fmt::format("basis '{}' has no ghost nodes, so boundary '{}' has nothing to act on (use dirichlet, "
                    "symmetry or free, or a basis without '-open')",
                    s.basis, s.boundary));
  for (std::size_t k = 0; k < faces.size(); k += 2)
    if ((faces[k] == "periodic") != (faces[k + 1] == "periodic"))
      throw UsageError(
          fmt::format("boundary '{}' is periodic on one face only (both faces of an axis, or neither)", s.boundary));
  if (s.wall_acceleration == "difference" && !has("dirichlet") && !has("symmetry"))
    throw UsageError(
        fmt::format("wall_acceleration 'difference' with boundary '{}' that holds no node (use it with "
                    "dirichlet or symmetry)",
                    s.boundary));
  if (s.wall_acceleration == "difference" && s.integrator == "uvf")
    throw UsageError(
        "wall_acceleration 'difference' with integrator 'uvf', which maps the velocity after the acceleration (use "
        "zero, or another integrator)");
  if (s.wall_acceleration == "difference" && s.integrator == "rk4")
    throw UsageError(
        "wall_acceleration 'difference' with integrator 'rk4', whose stages have rates and no step to take a "
        "difference "
        "over (use zero, or another integrator)");
  require_sense_of_mass(c, ghosts, has("mirror"));
  require_sense_of_velocity_update(s);
  require_sense_of_deformation(s);
  if (s.material == solver::MieGruneisen::word && s.integrator == "rk4")
    throw UsageError(
        "material 'mie-gruneisen' with integrator 'rk4', whose stages go back in time (use another: its history goes "
        "forward)");
  require_sense_of_walls(c, problem, faces);
  if (c.resolution.grid_offset > 0 && std::ranges::none_of(movable_axes(faces), std::identity{}))
    throw UsageError(
        fmt::format("grid_offset with boundary '{}', whose faces have their place among the nodes (periodic or free on "
                    "both faces of "
                    "an axis)",
                    s.boundary));
  if (const int least = std::max(4, 2 * ghosts); (has("symmetry") || has("mirror")) && c.resolution.cells < least)
    throw UsageError(
        fmt::format("{} cells are too few for boundary '{}' (at least {}: ghosts and their images must differ)",
                    c.resolution.cells, s.boundary, least));
  const auto width = width_of(basis);
  if ((width == solver::ParticleWidth::reference || width == solver::ParticleWidth::current) && c.resolution.ppc < 2)
    throw UsageError(
        fmt::format("basis '{}' with ppc = 1 (at least 2: a particle's width must stay below the cell's)", s.basis));
  const bool is_curved = problem.is_curved(c.problem.parameters);
  if (s.fill == "conforming" && !is_curved)
    throw UsageError(fmt::format(
        "fill 'conforming' has no meaning for problem '{}', which a lattice fills (use lattice)", problem.name));
  if (s.fill == "lattice" && is_curved && problem.is_loaded && problem.is_loaded(c.problem.parameters))
    throw UsageError(
        fmt::format("fill 'lattice' for problem '{}' with a traction on its surface, which stairs do not have (use "
                    "conforming)",
                    problem.name));
  if (c.problem.name == "one-particle" && (c.resolution.cells != 1 || c.resolution.ppc != 1))
    throw UsageError("problem 'one-particle' with other cells or ppc (cells = 1 and ppc = 1)");
  const bool has_solution = problem.has_solution(c.problem.parameters);
  if (s.start == "exact" && !has_solution)
    throw UsageError(
        fmt::format("problem '{}' has no exact velocity for start 'exact' (use start 'half')", problem.name));
  if (c.measure.nodal_error && !has_solution)
    throw UsageError(
        fmt::format("problem '{}' has no exact acceleration for nodal_error (leave it out)", problem.name));
  if (c.measure.velocity_error && !problem.has_speed(c.problem.parameters))
    throw UsageError(
        fmt::format("problem '{}' has no speed that velocity_error is measured by (leave it out)", problem.name));
  if (c.measure.stress_error && !has_solution)
    throw UsageError(fmt::format("problem '{}' has no exact stress for stress_error (leave it out)", problem.name));
  if (c.measure.nodal_error && s.wall_acceleration == "difference")
    throw UsageError(
        "nodal_error with wall_acceleration 'difference', which belongs to a step and not to the end time (use zero)");
  if (!(c.measure.blowup_error > 0) || !(c.measure.blowup_energy > 0))
    throw UsageError("blowup_error and blowup_energy must be > 0");
}

}  // namespace mpmvv::settings
