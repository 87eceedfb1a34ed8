#include "studies/settings/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "studies/problems/problem.hpp"
#include "studies/settings/given.hpp"
#include "studies/settings/other_code.hpp"
#include "studies/settings/part.hpp"
#include "studies/settings/scales.hpp"
#include "studies/settings/scheme_rules.hpp"
#include "studies/settings/validate.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings {

using cases::Case;
using cases::ProblemChoice;
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
    given[name] = known->allowed(0) ? parse_number(setting) : cases::parse_number_in_size(setting);
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
    choice.quarter = parse_flag(it->second);
    if (choice.quarter && !problem.has_quarter())
      throw UsageError(
          fmt::format("quarter in {} has no meaning for problem '{}', which has no planes of symmetry (leave it out)",
                      it->second.where, problem.name));
  }
  return choice;
}

/// Sets Δt from `cfl` or `dt`, and the number of steps; where `steps` is given, also the end time that they reach.
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
    c.resolution.steps = whole(it->second, 1, 1'000'000'000'000);
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
  require_keys_of_code(settings);

  Case c;
  c.problem = make_choice(settings, problem);
  require_scales(c.problem, problem, most_extreme(given));
  for (const SettingKey& key : setting_keys())
    if (const auto it = settings.find(key.key); it != settings.end() && key.member && key.member->set)
      key.member->set(c, it->second);
  complete_scheme(settings, problem, c.problem.quarter, c.scheme);
  for (const char* key : {"cells", "ppc"}) required(settings, key);
  if (problem.lead_time && !settings.contains("end_time"))
    c.problem.end_time +=
        problem.lead_time(c.problem.parameters, problem.length(c.problem.parameters) / c.resolution.cells);
  set_time_step(settings, problem, c);
  require_scales(c, problem, most_extreme(given));
  c.scheme.code.empty() ? validate(c, problem) : validate_other_code(c, problem);
  if (c.measure.whole) c = as_whole(c);
  return c;
}

}  // namespace mpmvv::settings
