#include "studies/settings/part.hpp"

#include "solver/boundary/boundaries.hpp"
#include "studies/settings/boundaries.hpp"
#include "studies/settings/traits.hpp"
#include "studies/settings/validate.hpp"

namespace mpmvv::settings {

using cases::Case;
using cases::Scheme;

namespace {

/// Whether it is among what the test compares.
bool is_shown(const Scheme& scheme, const problems::Problem& problem) {
  const bool is_boundary_shown =
      scheme.boundary == problem.boundary ||
      (problem.boundary == solver::Periodic::word &&
       (scheme.boundary == solver::Symmetry::word || scheme.boundary == solver::Mirror::word));
  return is_boundary_shown && scheme.body_force == cases::BodyForce::particles && scheme.mass == cases::Mass::lumped &&
         scheme.wall_acceleration == cases::WallAcceleration::zero;
}

/// Whether the time step is well below the stability limit: near it round-off grows, and what is unstable of the whole
/// need not be so of its part. Many terms of an expanded inverse lower the limit, those of two blocks with GIMP from 14
/// terms on to a Courant number of 0.2.
bool is_stable(const Case& c, const problems::Problem& problem) {
  const auto basis = named<solver::AnyBasis>(c.scheme.basis);
  if (c.scheme.order > 8 && width_of(basis) != solver::ParticleWidth::domain) return false;
  const double largest_cfl = (c.scheme.order > 1 ? 0.2 : 0.5) * (1 + 1e-9),
               length = problem.length(c.problem.parameters);
  return problem.wave_speed(c.problem.parameters) * c.resolution.dt * c.resolution.cells <= largest_cfl * length;
}

}  // namespace

std::optional<Case> part_of(const Case& c) {
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  const bool is_wanted = c.scheme.code.empty() && !c.measure.whole && c.measure.repeat == 0 && !c.measure.nodal_error;
  const bool is_symmetric = c.resolution.grid_offset == 0 && c.resolution.shuffle == 0;
  if (!is_wanted || !is_symmetric || !problem.has_quarter() || c.problem.quarter || !is_shown(c.scheme, problem) ||
      !is_stable(c, problem))
    return std::nullopt;
  Case part = c;
  part.problem.quarter = true;
  part.scheme.boundary =
      canonical_boundary(problem.quarter_boundary(c.scheme.boundary), problem.dimension(), "its quarter");
  if (!is_valid(part, problem)) return std::nullopt;
  return part;
}

int images_of_part(const Case& part) {
  return 1 << problems::find_problem(part.problem.name, "the case").dimension();
}

Case as_whole(Case c) {
  c.measure.whole = false;
  c.measure.whole = part_of(c).has_value();
  return c;
}

}  // namespace mpmvv::settings
