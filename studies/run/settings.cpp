#include "studies/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "solver/mpm.hpp"
#include "studies/boundaries.hpp"
#include "studies/error.hpp"
#include "studies/problem.hpp"
#include "studies/sense.hpp"

namespace mpmvv {

namespace {

using Settings = std::map<std::string, Setting>;

template <class Words>
std::vector<std::string> strings(const Words& words) {
  return {words.begin(), words.end()};
}

/// Key and member of Scheme that take one of a few words.
struct WordKey {
  std::string key;
  std::string Scheme::*member;
  std::vector<std::string> words;
};

const std::vector<WordKey>& word_keys() {
  static const std::vector<WordKey> keys{
      {"basis", &Scheme::basis, strings(solver::words<solver::AnyBasis>())},
      {"integrator", &Scheme::integrator, strings(solver::integrator_words())},
      {"start", &Scheme::start, {"half", "exact"}},
      {"velocity_update", &Scheme::velocity_update, {"flip"}},
      {"mass", &Scheme::mass, {"lumped", "consistent"}},
      {"wall_acceleration", &Scheme::wall_acceleration, {"zero", "difference"}},
      {"deformation", &Scheme::deformation, {"linear"}},
      {"body_force", &Scheme::body_force, {"particles", "grid"}},
      {"fill", &Scheme::fill, {"lattice"}},
      {"material", &Scheme::material, strings(solver::words<solver::AnyMaterial>())},
  };
  return keys;
}

double number(const Settings& settings, const std::string& key, double absent) {
  const auto it = settings.find(key);
  return it == settings.end() ? absent : parse_number(it->second);
}

double positive(const Setting& setting) {
  const double value = parse_number(setting);
  if (!(value > 0))
    throw UsageError(fmt::format("{} = {} in {} (a number > 0)", setting.key, setting.value, setting.where));
  return value;
}

template <class Integer>
Integer count(const Setting& setting, Integer least, Integer most) {
  Integer value = 0;
  const char* end = setting.value.data() + setting.value.size();
  const auto [stop, error] = std::from_chars(setting.value.data(), end, value);
  if (error != std::errc{} || stop != end || value < least || value > most)
    throw UsageError(fmt::format("{} = {} in {} (a whole number from {} to {})", setting.key, setting.value,
                                 setting.where, least, most));
  return value;
}

const Setting& required(const Settings& settings, const std::string& key) {
  const auto it = settings.find(key);
  if (it == settings.end()) throw UsageError(fmt::format("no {} given (it is required)", key));
  return it->second;
}

bool flag(const Setting& setting) {
  if (setting.value == "true" || setting.value == "false") return setting.value == "true";
  throw UsageError(fmt::format("{} = {} in {} (true or false)", setting.key, setting.value, setting.where));
}

Parameters given_parameters(const Settings& settings, const Problem& problem) {
  Parameters given;
  for (const auto& [key, setting] : settings) {
    if (!key.starts_with("param.")) continue;
    const std::string name = key.substr(6);
    const Parameter* known = nullptr;
    std::vector<std::string> names;
    for (const Parameter& parameter : problem.parameters) {
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

Scheme make_scheme(const Settings& settings, const Problem& problem) {
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
  if (!solver::is_staggered(scheme.integrator)) {
    if (const auto it = settings.find("start"); it != settings.end())
      throw UsageError(fmt::format("start in {} has no meaning for integrator '{}' (only cd and uvf take it)",
                                   it->second.where, scheme.integrator));
    scheme.start = "none";
  }
  const auto it = settings.find("boundary");
  scheme.boundary = it == settings.end() ? canonical_boundary(problem.boundary, problem.dimension(), "its default")
                                         : canonical_boundary(it->second.value, problem.dimension(), it->second.where);
  return scheme;
}

/// Δt from `cfl` or `dt`, and the number of steps.
void set_time_step(const Settings& settings, const Problem& problem, Case& c) {
  const bool has_cfl = settings.contains("cfl"), has_dt = settings.contains("dt");
  if (has_cfl == has_dt)
    throw UsageError(has_cfl ? fmt::format("both cfl and dt given in {} (one of them)", settings.at("dt").where)
                             : std::string("neither cfl nor dt given (one of them is required)"));
  const double T = c.problem.end_time;
  const double h = problem.length / c.resolution.cells;
  const double wanted = has_dt ? positive(settings.at("dt"))
                               : positive(settings.at("cfl")) * h / problem.wave_speed(c.problem.parameters);
  const double steps = has_dt ? std::round(T / wanted) : std::ceil(T / wanted - 1e-9);
  if (steps > 1e12) throw UsageError(fmt::format("a time step of {} s needs {} steps (at most 1e12)", wanted, steps));
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

const std::vector<SettingKey>& setting_keys() {
  static const std::vector<SettingKey> keys{
      {"problem", "what is solved"},
      {"basis", "grid basis functions"},
      {"smoothing_length", "of ugimp, in cells"},
      {"integrator", "order of the step"},
      {"start", "first step of cd and uvf"},
      {"velocity_update", "how particle velocities follow the grid"},
      {"mass", "mass matrix"},
      {"boundary", "all faces, or per face as xmin=symmetry,xmax=free"},
      {"wall_acceleration", "acceleration of held nodes"},
      {"deformation", "update of F"},
      {"body_force", "where the body force is evaluated"},
      {"fill", "how particles fill the body"},
      {"material", "constitutive law"},
      {"cells", "cells per length L of the problem"},
      {"ppc", "particles per cell and direction"},
      {"cfl", "wave speed times time step over cell width"},
      {"dt", "time step in s; must divide the end time"},
      {"end_time", "in s"},
      {"steps", "stop after so many steps of the default end time's step"},
      {"every_step", "errors over all steps, too"},
      {"nodal_error", "error of the nodal accelerations at the end, too"},
      {"blowup_error", "unstable beyond this error, in displacement amplitudes"},
      {"blowup_energy", "unstable beyond this energy, in initial energies"},
      {"repeat", "run alone so often (3 or more) and keep the median cost"},
  };
  return keys;
}

std::vector<std::string> words_of_key(const std::string& key) {
  if (key == "boundary") return strings(solver::words<solver::AnyBoundary>());
  for (const WordKey& word_key : word_keys())
    if (word_key.key == key) return word_key.words;
  return {};
}

void require_known_key(const std::string& key, const std::string& where) {
  if (key.starts_with("param.")) return;
  std::vector<std::string> known;
  for (const SettingKey& k : setting_keys()) {
    if (k.key == key) return;
    known.push_back(k.key);
  }
  throw UsageError(fmt::format("unknown key '{}' in {} (known: {}, param)", key, where, fmt::join(known, ", ")));
}

double parse_number(const Setting& setting) {
  double value = 0;
  const char* end = setting.value.data() + setting.value.size();
  const auto [stop, error] = std::from_chars(setting.value.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value))
    throw UsageError(fmt::format("{} = '{}' in {} (a finite number)", setting.key, setting.value, setting.where));
  return value;
}

Case make_case(std::span<const Setting> given) {
  Settings settings;
  for (const Setting& setting : given) {
    require_known_key(setting.key, setting.where);
    settings[setting.key] = setting;
  }
  const Setting& name = required(settings, "problem");
  const Problem& problem = find_problem(name.value, name.where);

  Case c;
  c.problem.name = problem.name;
  c.problem.parameters = complete_parameters(problem, given_parameters(settings, problem));
  c.problem.end_time = problem.end_time(c.problem.parameters);
  if (const auto it = settings.find("end_time"); it != settings.end()) c.problem.end_time = positive(it->second);
  c.scheme = make_scheme(settings, problem);
  c.resolution.cells = count<int>(required(settings, "cells"), 1, 1'000'000);
  c.resolution.ppc = count<int>(required(settings, "ppc"), 1, 100);
  set_time_step(settings, problem, c);
  if (const auto it = settings.find("every_step"); it != settings.end()) c.measure.every_step = flag(it->second);
  if (const auto it = settings.find("nodal_error"); it != settings.end()) c.measure.nodal_error = flag(it->second);
  c.measure.blowup_error = number(settings, "blowup_error", c.measure.blowup_error);
  c.measure.blowup_energy = number(settings, "blowup_energy", c.measure.blowup_energy);
  if (const auto it = settings.find("repeat"); it != settings.end()) c.measure.repeat = count<int>(it->second, 3, 99);
  require_sense(c);
  return c;
}

}  // namespace mpmvv
