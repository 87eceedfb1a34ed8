#include "studies/settings/part.hpp"

#include "solver/boundary/boundaries.hpp"
#include "studies/settings/boundaries.hpp"
#include "studies/settings/traits.hpp"
#include "studies/settings/validate.hpp"

namespace mpmvv::settings {

using cases::Case;
using cases::Scheme;

namespace {

std::string boundary_of(const std::string& given, const problems::Problem& problem) {
  return canonical_boundary(given, problem.dimension(), "its part");
}

/// Whether tests/studies/runs have shown that with such a scheme a part gives the same errors as the whole, whatever
/// the boundary.
bool is_shown(const Scheme& scheme) {
  return scheme.body_force == cases::BodyForce::particles && scheme.mass == cases::Mass::lumped &&
         scheme.wall_acceleration == cases::WallAcceleration::zero;
}

/// Whether the time step is well below the stability limit. Near the limit round-off grows, and the part may be stable
/// where the whole is unstable. Many terms of an expanded inverse lower the limit: that of two blocks with GIMP to a
/// Courant number of 0.2 from 14 terms on. The limit of a vortex is about 0.4, with CPDI 0.18.
bool is_stable(const Case& c, const problems::Problem& problem) {
  const bool has_domains = width_of(named<solver::AnyBasis>(c.scheme.basis)) == solver::ParticleWidth::domain;
  if (c.scheme.order > 8 && !has_domains) return false;
  const bool is_turned = problem.images == solver::Images::quarter_turns;
  const double largest_cfl = is_turned && has_domains ? 0.1 : is_turned || c.scheme.order > 1 ? 0.2 : 0.5;
  return problems::p_wave_cfl_number(c) <= largest_cfl * (1 + 1e-9);
}

/// Returns the case of the quarter whose mirror images make up the body; none where there is no such quarter.
std::optional<Case> quarter_of(const Case& c, const problems::Problem& problem) {
  const std::string& boundary = c.scheme.boundary;
  const bool is_mirrored =
      boundary == problem.boundary || (problem.boundary == solver::Periodic::word &&
                                       (boundary == solver::Symmetry::word || boundary == solver::Mirror::word));
  if (!problem.has_quarter() || c.problem.quarter || !is_mirrored) return std::nullopt;
  Case quarter = c;
  quarter.problem.quarter = true;
  quarter.scheme.boundary = boundary_of(problem.quarter_boundary(boundary), problem);
  if (!is_valid(quarter, problem)) return std::nullopt;
  return quarter;
}

/// Returns the images that make up the body of the case. Only the problem's default boundary is taken to share them.
solver::Images images_of(const Case& c, const problems::Problem& problem) {
  const bool are_shared = c.scheme.boundary == boundary_of(problem.default_boundary(c.problem.quarter), problem);
  return are_shared ? problem.images : solver::Images::none;
}

}  // namespace

std::optional<Part> part_of(const Case& c) {
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  const bool is_wanted = c.scheme.code.empty() && !c.measure.whole && c.measure.repeat == 0 && !c.measure.nodal_error;
  const bool is_symmetric = c.resolution.grid_offset == 0 && c.resolution.shuffle == 0;
  if (!is_wanted || !is_symmetric || !is_shown(c.scheme) || !is_stable(c, problem)) return std::nullopt;
  Part part{c};
  if (const auto quarter = quarter_of(c, problem)) part = {*quarter, 1 << problem.dimension()};
  part.images = images_of(part.body, problem);
  if (part.count() == 1) return std::nullopt;
  return part;
}

Case as_whole(Case c) {
  c.measure.whole = false;
  c.measure.whole = part_of(c).has_value();
  return c;
}

}  // namespace mpmvv::settings
