#include "studies/codes/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/boundary/boundaries.hpp"
#include "solver/words.hpp"
#include "studies/codes/conditions.hpp"
#include "studies/codes/expressions.hpp"
#include "studies/codes/start_state.hpp"

namespace mpmvv::codes {

using cases::Case;

namespace {

constexpr const char* axes = "xyz";

/// Returns the number with 17 digits, -0 as 0.
std::string text(double value) {
  return fmt::format("{:.17g}", value + 0.0);
}

void set(TemplateFields& fields, const std::string& name, double value) {
  fields.set(name, text(value));
}

/// Sets the values of an adapter: `true` and `false` are conditions, all others are texts.
void set_values(TemplateFields& fields, const FieldValues& values) {
  for (const auto& [name, value] : values) {
    if (value == "true" || value == "false")
      fields.set(name, value == "true");
    else
      fields.set(name, value);
  }
}

/// Sets a condition `is_WORD` for each of the words, true only for `word`: is_line, is_plane, is_solid.
void set_words(TemplateFields& fields, const std::vector<std::string>& words, const std::string& word) {
  for (std::string each : words) {
    const bool is_it = each == word;
    std::ranges::replace(each, '-', '_');
    fields.set("is_" + each, is_it);
  }
}

void add_scheme(const Case& c, TemplateFields& fields) {
  for (const auto& [name, value] : c.problem.parameters) set(fields, "param_" + name, value);
  set(fields, "cells", c.resolution.cells);
  set(fields, "ppc", c.resolution.ppc);
  fields.set("steps", fmt::format("{}", c.resolution.steps));
  fields.set("problem", c.problem.name);
  fields.set("boundary", c.scheme.boundary);
  constexpr auto boundaries = solver::words<solver::AnyBoundary>();
  set_words(fields, {boundaries.begin(), boundaries.end()}, c.scheme.boundary);
  fields.set("is_quarter", c.problem.quarter);
  fields.set("variant", c.scheme.variant);
  fields.set("force_form", to_string(c.scheme.force_form));
  const auto forms = cases::words_of(c.scheme.force_form);
  set_words(fields, {forms.begin(), forms.end()}, to_string(c.scheme.force_form));
}

void add_conditions(const Case& c, TemplateFields& fields) {
  const Conditions known = conditions(c);
  set(fields, "h", known.h);
  set(fields, "particle_width", known.h / c.resolution.ppc);
  set(fields, "dt", known.dt);
  set(fields, "end_time", known.end_time);
  set(fields, "before_end", known.end_time - known.dt / 2);
  set(fields, "cfl", known.cfl);
  set(fields, "wave_speed", known.wave_speed);
  set(fields, "density", known.density);
  fields.set("material", known.material);
  fields.set("dimension", fmt::format("{}", known.dimension));
  set(fields, "particles_per_cell", std::pow(c.resolution.ppc, known.dimension));
  static const std::vector<std::string> shapes{"line", "plane", "solid"};
  set_words(fields, shapes, shapes[static_cast<std::size_t>(known.dimension - 1)]);
  if (known.elasticity) {
    set(fields, "youngs_modulus", known.elasticity->youngs_modulus);
    set(fields, "poissons_ratio", known.elasticity->poissons_ratio);
    set(fields, "lambda", known.elasticity->lambda());
    set(fields, "mu", known.elasticity->mu());
    set(fields, "bulk_modulus", bulk_modulus(*known.elasticity));
  }
  for (std::size_t d = 0; d < known.lower.size(); ++d) {
    set(fields, fmt::format("lower_{}", axes[d]), known.lower[d]);
    set(fields, fmt::format("upper_{}", axes[d]), known.upper[d]);
    set(fields, fmt::format("cells_{}", axes[d]), known.cells[d]);
  }
}

void set_components(TemplateFields& fields, const std::string& name, const std::vector<std::string>& texts) {
  for (std::size_t d = 0; d < texts.size(); ++d) fields.set(fmt::format("{}_{}", name, axes[d]), texts[d]);
}

/// Sets body force, initial velocity and deformation, and displacement as expressions in the adapter's dialect.
void add_expressions(const Case& c, const Dialect& dialect, TemplateFields& fields) {
  const Expressions all = expressions(c.problem, c.scheme.force_form, dialect);
  set_components(fields, "b", all.b);
  set_components(fields, "v0", all.v0);
  set_components(fields, "u", all.u);
  for (std::size_t d = 0; d < all.F0.size(); ++d) set_components(fields, fmt::format("F0_{}", axes[d]), all.F0[d]);
}

/// Returns the fields of one particle. `width` is the width of a particle in the reference configuration. The boxes
/// from `x_below` to `x_above`, half as wide, hold one particle each where the start is compressed by less than a half.
TemplateFields particle_of(const StartState& state, std::size_t p, double width) {
  TemplateFields one;
  one.set("id", fmt::format("{}", state.id[p]));
  set(one, "m", state.m[p]);
  set(one, "V", state.V[p]);
  for (std::size_t d = 0; d < static_cast<std::size_t>(state.dimension); ++d) {
    set(one, std::string(1, "XYZ"[d]), state.X[p][d]);
    set(one, std::string(1, axes[d]), state.x[p][d]);
    set(one, fmt::format("{}_below", axes[d]), state.x[p][d] - width / 4);
    set(one, fmt::format("{}_above", axes[d]), state.x[p][d] + width / 4);
    set(one, fmt::format("v_{}", axes[d]), state.v[p][d]);
    for (std::size_t k = 0; k < static_cast<std::size_t>(state.dimension); ++k)
      set(one, fmt::format("F_{}{}", axes[d], axes[k]), state.F[p][3 * d + k]);
  }
  return one;
}

}  // namespace

TemplateFields fields_of(const Case& c, const Code& code) {
  TemplateFields fields;
  fields.set("program", code.program.string());
  fields.set("adapter", std::filesystem::absolute(code.adapter.folder).string());
  add_scheme(c, fields);
  add_conditions(c, fields);
  set_values(fields, code.adapter.fields);
  if (const auto variant = code.adapter.variants.find(c.scheme.variant); variant != code.adapter.variants.end())
    set_values(fields, variant->second);
  return fields;
}

TemplateFields input_fields_of(const Case& c, const Code& code) {
  TemplateFields fields = fields_of(c, code);
  const StartState state = start_state(c);
  const Conditions known = conditions(c);
  fields.set("has_initial_velocity", !is_at_rest(state, known.wave_speed));
  fields.set("has_initial_deformation", !is_undeformed(state));
  std::vector<std::vector<std::string>> forces;
  if (const std::string& dialect = code.adapter.dialect; !dialect.empty()) {
    const Dialect& language = dialect_named(dialect, (code.adapter.folder / "adapter.toml").string());
    add_expressions(c, language, fields);
    if (c.scheme.force_form == cases::ForceForm::per_particle) forces = particle_forces(c, language);
  }
  TemplateFields particles(TemplateFields::type::list);
  for (std::size_t p = 0; p < state.size(); ++p) {
    TemplateFields particle = particle_of(state, p, known.h / c.resolution.ppc);
    if (!forces.empty()) set_components(particle, "b", forces[p]);
    particles.push_back(particle);
  }
  fields.set("particles", particles);
  fields.set("particle_count", fmt::format("{}", state.size()));
  return fields;
}

std::string filled_word(const std::string& word, const TemplateFields& fields, const Code& code) {
  return filled(word, fields, (code.adapter.folder / "adapter.toml").string());
}

std::string filled_input(const InputFile& input, const TemplateFields& fields) {
  return filled(input.text, fields, input.source.string());
}

void require_sound_templates(const Case& c, const Code& code) {
  const TemplateFields fields = fields_of(c, code), input_fields = input_fields_of(c, code);
  for (const InputFile& input : code.adapter.inputs) filled_input(input, input_fields);
  for (const std::string& word : code.adapter.command) filled_word(word, fields, code);
  for (const auto& command : code.adapter.output.convert)
    for (const std::string& word : command) filled_word(word, fields, code);
  for (const std::string& file : {code.adapter.output.end, code.adapter.output.start}) filled_word(file, fields, code);
}

}  // namespace mpmvv::codes
