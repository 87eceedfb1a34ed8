#include "studies/settings/scheme_rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "solver/boundary/wall.hpp"
#include "studies/settings/boundaries.hpp"
#include "studies/settings/solver_words.hpp"
#include "studies/settings/traits.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings {

using cases::positive;
using cases::Scheme;
using problems::Problem;
using support::UsageError;

namespace {

using Takes = bool (*)(const solver::AnyVelocityUpdate&);

/// Throws UsageError where a key is given that the scheme's velocity update does not take.
void require_taken(const Settings& settings, const std::string& key, const Scheme& scheme, Takes takes) {
  const auto it = settings.find(key);
  if (it == settings.end() || takes(named<solver::AnyVelocityUpdate>(scheme.velocity_update))) return;
  throw UsageError(fmt::format("{} in {} has no meaning for velocity_update '{}' (only {} takes it)", key,
                               it->second.where, scheme.velocity_update,
                               fmt::join(words_with<solver::AnyVelocityUpdate>(takes), " or ")));
}

/// Sets the smoothing length, where the basis has one.
void set_smoothing_length(const Settings& settings, Scheme& scheme) {
  const auto it = settings.find("smoothing_length");
  if (takes_smoothing_length(named<solver::AnyBasis>(scheme.basis))) {
    if (it == settings.end())
      throw UsageError(fmt::format("basis '{}' without smoothing_length (in cells, > 0 and at most 1)", scheme.basis));
    scheme.smoothing_length = positive(it->second);
    if (scheme.smoothing_length > 1)
      throw UsageError(
          fmt::format("smoothing_length = {} in {} (in cells, > 0 and at most 1)", it->second.value, it->second.where));
  } else if (it != settings.end()) {
    throw UsageError(fmt::format("smoothing_length in {} has no meaning for basis '{}' (only {} takes it)",
                                 it->second.where, scheme.basis,
                                 fmt::join(words_with<solver::AnyBasis>(takes_smoothing_length), " or ")));
  }
}

/// Sets what depends on the velocity update: how positions follow, the order k, the wall method, and `cfl_x` of
/// periodic FMPM.
void set_velocity_update(const Settings& settings, Scheme& scheme) {
  const auto update = named<solver::AnyVelocityUpdate>(scheme.velocity_update);
  require_taken(settings, "position", scheme, takes_position);
  if (!takes_position(update)) scheme.position = cases::Position::none;
  for (const char* key : {"order", "wall_method"}) require_taken(settings, key, scheme, solver::expands_inverse);
  if (solver::expands_inverse(update) && (scheme.mass == cases::Mass::lumped || settings.contains("order"))) {
    const auto order = settings.find("order");
    if (order == settings.end())
      throw UsageError(fmt::format("velocity_update '{}' without order (its k, from 1 on: --order 2, or order = 2)",
                                   scheme.velocity_update));
    scheme.order = static_cast<int>(whole(order->second, 1, 10'000));
    if (!settings.contains("wall_method")) scheme.wall_method = cases::WallMethod::combined;
  }
  require_taken(settings, "cfl_x", scheme, takes_interval);
  if (const auto it = settings.find("cfl_x"); it != settings.end()) scheme.cfl_x = positive(it->second);
}

/// Sets the law: the problem's own, or the other one that its body may have.
void set_material(const Settings& settings, const Problem& problem, Scheme& scheme) {
  const auto it = settings.find("material");
  if (it == settings.end()) {
    scheme.material = problem.material;
    return;
  }
  if (scheme.material == problem.material || scheme.material == problem.other_material) return;
  throw UsageError(fmt::format("material '{}' in {} for problem '{}' (it is of {}{})", scheme.material,
                               it->second.where, problem.name, problem.material,
                               problem.other_material.empty() ? "" : " or " + problem.other_material));
}

/// Sets the depth and the velocity gradient of moving walls.
void set_walls(const Settings& settings, Scheme& scheme) {
  if (scheme.boundary.find(solver::Wall::word) != std::string::npos) {
    scheme.wall_depth = 1;
    if (const auto it = settings.find("wall_depth"); it != settings.end()) scheme.wall_depth = not_negative(it->second);
    if (!settings.contains("wall_gradient")) scheme.wall_gradient = cases::WallGradient::given;
    return;
  }
  for (const char* key : {"wall_depth", "wall_gradient"})
    if (const auto it = settings.find(key); it != settings.end())
      throw UsageError(fmt::format("{} in {} has no meaning for boundary '{}' (only wall takes it)", key,
                                   it->second.where, scheme.boundary));
}

}  // namespace

void complete_scheme(const Settings& settings, const Problem& problem, bool quarter, Scheme& scheme) {
  for (const SolverWords& list : solver_words()) {
    const auto it = settings.find(list.key);
    if (it == settings.end()) continue;
    cases::require_word(it->second, list.words);
    scheme.*list.member = it->second.value;
  }
  set_material(settings, problem, scheme);
  set_smoothing_length(settings, scheme);
  set_velocity_update(settings, scheme);
  if (!solver::integrator_named(scheme.integrator).is_staggered) {
    if (const auto it = settings.find("start"); it != settings.end())
      throw UsageError(fmt::format("start in {} has no meaning for integrator '{}' (only {} take it)", it->second.where,
                                   scheme.integrator,
                                   fmt::join(integrators_with(&solver::Integrator::is_staggered), " and ")));
    scheme.start = cases::Start::none;
  }
  const auto it = settings.find("boundary");
  scheme.boundary = it == settings.end()
                        ? canonical_boundary(problem.default_boundary(quarter), problem.dimension(), "its default")
                        : canonical_boundary(it->second.value, problem.dimension(), it->second.where);
  set_walls(settings, scheme);
}

}  // namespace mpmvv::settings
