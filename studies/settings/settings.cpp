#include "studies/settings/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>

#include "solver/boundary/wall.hpp"
#include "solver/integrator/words.hpp"
#include "solver/velocity_update/velocity_updates.hpp"
#include "studies/problems/problem.hpp"
#include "studies/settings/boundaries.hpp"
#include "studies/settings/named.hpp"
#include "studies/settings/scales.hpp"
#include "studies/settings/sense.hpp"
#include "studies/settings/setting_values.hpp"
#include "studies/settings/word_keys.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings {

using cases::Case;
using cases::ProblemChoice;
using cases::Scheme;
using problems::Problem;
using support::UsageError;

namespace {

const Problem& chosen_problem(const Settings& settings) {
  const Setting& name = required(settings, "problem");
  return problems::find_problem(name.value, name.where);
}

problems::Parameters given_parameters(const Settings& settings, const Problem& problem) {
  problems::Parameters given;
  for (const auto& [key, setting] : settings) {
    if (!key.starts_with("param.")) continue;
    const std::string name = key.substr(6);
    const problems::Parameter* known = nullptr;
    std::vector<std::string> names;
    for (const problems::Parameter& parameter : problem.parameters) {
      names.push_back(parameter.name);
      if (parameter.name == name) known = &parameter;
    }
    if (!known)
      throw UsageError(fmt::format("unknown parameter '{}' of problem '{}' in {} (known: {})", name, problem.name,
                                   setting.where, fmt::join(names, ", ")));
    given[name] = parse_number(setting);
    if (!known->allowed(given[name]))
      throw UsageError(fmt::format("{} = {} in {} (allowed: {})", name, setting.value, setting.where, known->range));
  }
  return given;
}

ProblemChoice make_choice(const Settings& settings, const Problem& problem) {
  ProblemChoice choice{problem.name, problems::complete_parameters(problem, given_parameters(settings, problem)), 0,
                       false};
  if (problem.objection)
    if (const std::string objection = problem.objection(choice.parameters); !objection.empty())
      throw UsageError(fmt::format("parameters of problem '{}': {}", problem.name, objection));
  choice.end_time = problem.end_time(choice.parameters);
  if (const auto it = settings.find("end_time"); it != settings.end()) choice.end_time = positive(it->second);
  if (const auto it = settings.find("quarter"); it != settings.end()) {
    choice.quarter = flag(it->second);
    if (choice.quarter && !problem.has_quarter)
      throw UsageError(fmt::format("quarter in {} has no meaning for problem '{}', which has no planes of symmetry",
                                   it->second.where, problem.name));
  }
  return choice;
}

using Takes = bool (*)(const solver::AnyVelocityUpdate&);

bool takes_position(const solver::AnyVelocityUpdate& update) {
  return std::visit(
      [](const auto& u) {
        return requires {
          u.position;
        };
      },
      update);
}

bool takes_interval(const solver::AnyVelocityUpdate& update) {
  return std::visit(
      [](const auto& u) {
        return requires {
          u.interval;
        };
      },
      update);
}

/// Refuses a key that the scheme's velocity update does not take.
void require_taken(const Settings& settings, const std::string& key, const Scheme& scheme, Takes takes) {
  const auto it = settings.find(key);
  if (it == settings.end() || takes(named<solver::AnyVelocityUpdate>(scheme.velocity_update))) return;
  throw UsageError(fmt::format("{} in {} has no meaning for velocity_update '{}' (only {} takes it)", key,
                               it->second.where, scheme.velocity_update,
                               fmt::join(words_with<solver::AnyVelocityUpdate>(takes), " or ")));
}

/// What goes with the velocity update: k, periodic FMPM, positions, walls.
void set_velocity_update(const Settings& settings, Scheme& scheme) {
  const auto update = named<solver::AnyVelocityUpdate>(scheme.velocity_update);
  require_taken(settings, "position", scheme, takes_position);
  if (!takes_position(update)) scheme.position = "none";
  for (const char* key : {"order", "wall_method"}) require_taken(settings, key, scheme, solver::expands_inverse);
  if (solver::expands_inverse(update) && (scheme.mass == "lumped" || settings.contains("order"))) {
    scheme.order = count<int>(required(settings, "order"), 1, 10'000);
    if (!settings.contains("wall_method")) scheme.wall_method = "combined";
  }
  require_taken(settings, "cfl_x", scheme, takes_interval);
  if (const auto it = settings.find("cfl_x"); it != settings.end()) scheme.cfl_x = positive(it->second);
}

/// What goes with moving walls.
void set_walls(const Settings& settings, Scheme& scheme) {
  if (scheme.boundary.find(solver::Wall::word) != std::string::npos) {
    scheme.wall_depth = 1;
    if (const auto it = settings.find("wall_depth"); it != settings.end()) scheme.wall_depth = not_negative(it->second);
    if (!settings.contains("wall_gradient")) scheme.wall_gradient = "given";
    return;
  }
  for (const char* key : {"wall_depth", "wall_gradient"})
    if (const auto it = settings.find(key); it != settings.end())
      throw UsageError(fmt::format("{} in {} has no meaning for boundary '{}' (only wall takes it)", key,
                                   it->second.where, scheme.boundary));
}

Scheme make_scheme(const Settings& settings, const Problem& problem, bool quarter) {
  Scheme scheme;
  for (const WordKey& key : word_keys()) {
    const auto it = settings.find(key.key);
    if (it == settings.end()) continue;
    const std::string& word = it->second.value;
    if (std::find(key.words.begin(), key.words.end(), word) == key.words.end())
      throw UsageError(fmt::format("unknown {} '{}' in {} (known: {})", key.key, word, it->second.where,
                                   fmt::join(key.words, ", ")));
    scheme.*key.member = word;
  }
  if (const auto it = settings.find("material"); it != settings.end() && scheme.material != problem.material)
    throw UsageError(fmt::format("material '{}' in {} for problem '{}' (it is of {})", scheme.material,
                                 it->second.where, problem.name, problem.material));
  scheme.material = problem.material;
  if (const auto it = settings.find("smoothing_length"); it != settings.end()) {
    if (scheme.basis != "ugimp")
      throw UsageError(fmt::format("smoothing_length in {} has no meaning for basis '{}' (only ugimp takes it)",
                                   it->second.where, scheme.basis));
    scheme.smoothing_length = positive(it->second);
    if (scheme.smoothing_length > 1)
      throw UsageError(
          fmt::format("smoothing_length = {} in {} (in cells, > 0 and at most 1)", it->second.value, it->second.where));
  } else if (scheme.basis == "ugimp") {
    throw UsageError("basis 'ugimp' without smoothing_length (in cells, > 0 and at most 1)");
  }
  set_velocity_update(settings, scheme);
  if (!solver::is_staggered(scheme.integrator)) {
    if (const auto it = settings.find("start"); it != settings.end())
      throw UsageError(fmt::format("start in {} has no meaning for integrator '{}' (only cd and uvf take it)",
                                   it->second.where, scheme.integrator));
    scheme.start = "none";
  }
  const auto it = settings.find("boundary");
  scheme.boundary = it == settings.end()
                        ? canonical_boundary(problem.default_boundary(quarter), problem.dimension(), "its default")
                        : canonical_boundary(it->second.value, problem.dimension(), it->second.where);
  set_walls(settings, scheme);
  return scheme;
}

void set_grid_offset(const Settings& settings, Case& c) {
  const auto it = settings.find("grid_offset");
  if (it == settings.end()) return;
  c.resolution.grid_offset = not_negative(it->second);
  if (!(c.resolution.grid_offset < 1))
    throw UsageError(
        fmt::format("grid_offset = {} in {} (in cells, from 0 to below 1)", it->second.value, it->second.where));
}

/// Δt from `cfl` or `dt`, and the number of steps.
void set_time_step(const Settings& settings, const Problem& problem, Case& c) {
  const bool has_cfl = settings.contains("cfl"), has_dt = settings.contains("dt");
  if (has_cfl == has_dt)
    throw UsageError(has_cfl ? fmt::format("both cfl and dt given in {} (one of them)", settings.at("dt").where)
                             : std::string("neither cfl nor dt given (one of them is required)"));
  const double T = c.problem.end_time;
  const double h = problem.length(c.problem.parameters) / c.resolution.cells;
  const double wanted = has_dt ? positive(settings.at("dt"))
                               : positive(settings.at("cfl")) * h / problem.wave_speed(c.problem.parameters);
  const double steps = has_dt ? std::round(T / wanted) : std::ceil(T / wanted - 1e-9);
  if (!(steps <= 1e12))
    throw UsageError(fmt::format("time steps of {} s until {} s given in {} (at most 1e12 of them)", wanted, T,
                                 settings.at(has_dt ? "dt" : "cfl").where));
  if (has_dt && (steps < 1 || std::abs(steps * wanted - T) > 1e-9 * T))
    throw UsageError(fmt::format("dt = {} in {} does not divide the end time {} s (the nearest that does: {})",
                                 settings.at("dt").value, settings.at("dt").where, T, T / std::max(steps, 1.0)));
  c.resolution.steps = static_cast<std::int64_t>(std::max(steps, 1.0));
  c.resolution.dt = T / static_cast<double>(c.resolution.steps);
  if (const auto it = settings.find("steps"); it != settings.end()) {
    if (settings.contains("end_time"))
      throw UsageError(fmt::format("both steps and end_time given in {} (one of them)", it->second.where));
    c.resolution.steps = count<std::int64_t>(it->second, 1, 1'000'000'000'000);
    c.problem.end_time = c.resolution.dt * static_cast<double>(c.resolution.steps);
  }
}

}  // namespace

ProblemChoice make_choice(std::span<const Setting> given) {
  const Settings settings = by_key(given);
  const Problem& problem = chosen_problem(settings);
  ProblemChoice choice = make_choice(settings, problem);
  require_scales(choice, problem, most_extreme(given));
  return choice;
}

Case make_case(std::span<const Setting> given) {
  const Settings settings = by_key(given);
  const Problem& problem = chosen_problem(settings);

  Case c;
  c.problem = make_choice(settings, problem);
  require_scales(c.problem, problem, most_extreme(given));
  c.scheme = make_scheme(settings, problem, c.problem.quarter);
  c.resolution.cells = count<int>(required(settings, "cells"), 1, 1'000'000);
  c.resolution.ppc = count<int>(required(settings, "ppc"), 1, 100);
  set_grid_offset(settings, c);
  if (const auto it = settings.find("shuffle"); it != settings.end())
    c.resolution.shuffle = count<int>(it->second, 0, 1'000'000'000);
  if (problem.lead_time && !settings.contains("end_time"))
    c.problem.end_time +=
        problem.lead_time(c.problem.parameters, problem.length(c.problem.parameters) / c.resolution.cells);
  set_time_step(settings, problem, c);
  if (const auto it = settings.find("every_step"); it != settings.end()) c.measure.every_step = flag(it->second);
  if (const auto it = settings.find("nodal_error"); it != settings.end()) c.measure.nodal_error = flag(it->second);
  if (const auto it = settings.find("velocity_error"); it != settings.end())
    c.measure.velocity_error = flag(it->second);
  if (const auto it = settings.find("stress_error"); it != settings.end()) c.measure.stress_error = flag(it->second);
  c.measure.blowup_error = number(settings, "blowup_error", c.measure.blowup_error);
  c.measure.blowup_energy = number(settings, "blowup_energy", c.measure.blowup_energy);
  if (const auto it = settings.find("repeat"); it != settings.end()) c.measure.repeat = count<int>(it->second, 3, 99);
  require_scales(c, problem, most_extreme(given));
  require_sense(c);
  return c;
}

}  // namespace mpmvv::settings
