#include "studies/codes/fields.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "solver/boundary/boundaries.hpp"
#include "solver/words.hpp"
#include "studies/codes/conditions.hpp"
#include "studies/codes/expressions.hpp"
#include "studies/codes/field_names.hpp"
#include "studies/codes/input_units.hpp"
#include "studies/codes/start_state.hpp"
#include "studies/codes/wall_expressions.hpp"

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

/// Sets a condition for each of the words, true only for `word`: is_line, is_plane, is_solid for the prefix `is_`.
void set_words(TemplateFields& fields, const std::string& prefix, const auto& words, const std::string& word) {
  for (const auto& each : words) fields.set(condition_name(prefix, std::string(each)), each == word);
}

void add_scheme(const Case& c, TemplateFields& fields) {
  set(fields, "cells", c.resolution.cells);
  set(fields, "ppc", c.resolution.ppc);
  fields.set("steps", fmt::format("{}", c.resolution.steps));
  fields.set("problem", c.problem.name);
  fields.set("boundary", c.scheme.boundary);
  set_words(fields, "is_", solver::words<solver::AnyBoundary>(), c.scheme.boundary);
  fields.set("is_quarter", c.problem.quarter);
  fields.set("variant", c.scheme.variant);
  fields.set("force_form", to_string(c.scheme.force_form));
  set_words(fields, "is_", cases::words_of(c.scheme.force_form), to_string(c.scheme.force_form));
}

/// Sets what there is to know of the faces: `boundary_xmin` and, one for each word, `xmin_is_wall`.
void add_faces(const std::vector<std::string>& words, TemplateFields& fields) {
  for (std::size_t face = 0; face < words.size(); ++face) {
    fields.set("boundary_" + face_name(face), words[face]);
    set_words(fields, face_name(face) + "_is_", solver::words<solver::AnyBoundary>(), words[face]);
  }
}

void add_conditions(const Case& c, const Conditions& known, const InputUnits& unit, TemplateFields& fields) {
  set(fields, "h", known.h / unit.length);
  set(fields, "particle_width", known.h / c.resolution.ppc / unit.length);
  set(fields, "dt", known.dt / unit.time);
  set(fields, "end_time", known.end_time / unit.time);
  set(fields, "before_end", (known.end_time - known.dt / 2) / unit.time);
  set(fields, "cfl", known.cfl);
  set(fields, "wave_speed", known.wave_speed / unit.velocity());
  set(fields, "density", known.density / unit.density());
  fields.set("material", known.material);
  fields.set("dimension", fmt::format("{}", known.dimension));
  set(fields, "particles_per_cell", std::pow(c.resolution.ppc, known.dimension));
  static const std::vector<std::string> shapes{"line", "plane", "solid"};
  set_words(fields, "is_", shapes, shapes[static_cast<std::size_t>(known.dimension - 1)]);
  if (known.elasticity) {
    set(fields, "youngs_modulus", known.elasticity->youngs_modulus / unit.pressure());
    set(fields, "poissons_ratio", known.elasticity->poissons_ratio);
    set(fields, "lambda", known.elasticity->lambda() / unit.pressure());
    set(fields, "mu", known.elasticity->mu() / unit.pressure());
    set(fields, "bulk_modulus", bulk_modulus(*known.elasticity) / unit.pressure());
  }
  for (std::size_t d = 0; d < known.lower.size(); ++d) {
    set(fields, fmt::format("lower_{}", axes[d]), known.lower[d] / unit.length);
    set(fields, fmt::format("upper_{}", axes[d]), known.upper[d] / unit.length);
    set(fields, fmt::format("cells_{}", axes[d]), known.cells[d]);
  }
  add_faces(known.boundary, fields);
}

void add_adapter(const Code& code, const std::string& variant, TemplateFields& fields) {
  fields.set("program", code.program.string());
  fields.set("adapter", std::filesystem::absolute(code.adapter.folder).string());
  set_values(fields, code.adapter.fields);
  const auto& variants = code.adapter.variants;
  if (const auto found = variants.find(variant); found != variants.end()) set_values(fields, found->second);
}

void set_components(TemplateFields& fields, const std::string& name, const std::vector<std::string>& texts) {
  for (std::size_t d = 0; d < texts.size(); ++d) fields.set(fmt::format("{}_{}", name, axes[d]), texts[d]);
}

void set_some(TemplateFields& fields, const std::string& name, const std::string& text) {
  if (!text.empty()) fields.set(name, text);
}

/// Sets body force, initial velocity and deformation, displacement, and motions of walls as expressions in the
/// adapter's dialect.
void add_expressions(const Case& c, const Dialect& dialect, TemplateFields& fields) {
  const Expressions all = expressions(c.problem, c.scheme.force_form, dialect);
  set_components(fields, "b", all.b);
  set_components(fields, "v0", all.v0);
  set_components(fields, "u", all.u);
  for (std::size_t d = 0; d < all.F0.size(); ++d)
    for (std::size_t k = 0; k < all.F0[d].size(); ++k)
      fields.set(fmt::format("F0_{}{}", axes[d], axes[k]), all.F0[d][k]);
  const auto walls = wall_expressions(c, dialect);
  for (std::size_t face = 0; face < walls.size(); ++face) {
    set_some(fields, face_name(face) + "_position", walls[face].position);
    set_some(fields, face_name(face) + "_velocity", walls[face].velocity);
  }
}

/// Returns the fields of one particle. `width` is the width of a particle in the reference configuration. The boxes
/// from `x_below` to `x_above`, half as wide, hold one particle each where the start is compressed by less than a half.
TemplateFields particle_of(const StartState& state, std::size_t p, double width, const InputUnits& unit) {
  TemplateFields one;
  one.set("id", fmt::format("{}", state.id[p]));
  one.set("is_first", p == 0);
  one.set("is_last", p + 1 == state.size());
  set(one, "m", state.m[p] * unit.thickness / unit.mass);
  set(one, "V", state.V[p] * unit.thickness / unit.volume());
  for (std::size_t d = 0; d < static_cast<std::size_t>(state.dimension); ++d) {
    set(one, std::string(1, "XYZ"[d]), state.X[p][d] / unit.length);
    set(one, std::string(1, axes[d]), state.x[p][d] / unit.length);
    set(one, fmt::format("{}_below", axes[d]), (state.x[p][d] - width / 4) / unit.length);
    set(one, fmt::format("{}_above", axes[d]), (state.x[p][d] + width / 4) / unit.length);
    set(one, fmt::format("v_{}", axes[d]), state.v[p][d] / unit.velocity());
    for (std::size_t k = 0; k < static_cast<std::size_t>(state.dimension); ++k)
      set(one, fmt::format("F_{}{}", axes[d], axes[k]), state.F[p][3 * d + k]);
  }
  return one;
}

/// Sets the particles, each with the expressions of its body force, if there are any.
void add_particles(const StartState& state, double width, const std::vector<std::vector<std::string>>& forces,
                   const InputUnits& unit, TemplateFields& fields) {
  TemplateFields particles(TemplateFields::type::list);
  for (std::size_t p = 0; p < state.size(); ++p) {
    TemplateFields particle = particle_of(state, p, width, unit);
    if (!forces.empty()) set_components(particle, "b", forces[p]);
    particles.push_back(particle);
  }
  fields.set("particles", particles);
  fields.set("particle_count", fmt::format("{}", state.size()));
}

void add_parameters(const Case& c, TemplateFields& fields) {
  for (const auto& [name, value] : c.problem.parameters) set(fields, "param_" + name, value);
}

InputUnits units_of(const Columns& file, int dimension) {
  return {file.length, file.time, file.mass, dimension == 2 ? file.thickness : 1};
}

/// Returns the fields for templates of input files, with numbers in the adapter's units or in m, s, kg.
TemplateFields input_fields_of(const Case& asked, const Code& code, bool in_units) {
  const Case c = as_given_to(code.adapter, asked);
  const StartState state = start_state(c);
  const Conditions known = conditions(c);
  const InputUnits unit = in_units ? units_of(code.adapter.output.columns, known.dimension) : InputUnits{};
  TemplateFields fields;
  add_adapter(code, c.scheme.variant, fields);
  add_scheme(c, fields);
  add_conditions(c, known, unit, fields);
  fields.set("has_initial_velocity", !is_at_rest(state, known.wave_speed));
  fields.set("has_initial_deformation", !is_undeformed(state));
  if (!in_units) add_parameters(c, fields);
  std::vector<std::vector<std::string>> forces;
  if (const std::string& dialect = code.adapter.dialect; !dialect.empty() && !in_units) {
    const Dialect& language = dialect_named(dialect, (code.adapter.folder / "adapter.toml").string());
    add_expressions(c, language, fields);
    if (c.scheme.force_form == cases::ForceForm::per_particle) forces = particle_forces(c, language);
  }
  add_particles(state, known.h / c.resolution.ppc, forces, unit, fields);
  return fields;
}

}  // namespace

TemplateFields fields_of(const Case& asked, const Code& code) {
  const Case c = as_given_to(code.adapter, asked);
  TemplateFields fields;
  add_adapter(code, c.scheme.variant, fields);
  add_scheme(c, fields);
  add_conditions(c, conditions(c), {}, fields);
  add_parameters(c, fields);
  return fields;
}

std::string filled_word(const std::string& word, const TemplateFields& fields, const Code& code) {
  return filled(word, fields, (code.adapter.folder / "adapter.toml").string());
}

std::vector<std::string> input_texts(const Case& c, const Code& code) {
  std::optional<TemplateFields> plain, in_units;
  std::vector<std::string> texts;
  for (const InputFile& input : code.adapter.inputs) {
    std::optional<TemplateFields>& fields = input.in_units ? in_units : plain;
    if (!fields) fields = input_fields_of(c, code, input.in_units);
    texts.push_back(filled(input.text, *fields, input.source.string()));
  }
  return texts;
}

void require_sound_templates(const Case& c, const Code& code) {
  input_texts(c, code);
  const TemplateFields fields = fields_of(c, code);
  for (const std::string& word : code.adapter.command) filled_word(word, fields, code);
  for (const auto& command : code.adapter.output.convert)
    for (const std::string& word : command) filled_word(word, fields, code);
  for (const std::string& file : {code.adapter.output.end, code.adapter.output.start}) filled_word(file, fields, code);
}

}  // namespace mpmvv::codes
