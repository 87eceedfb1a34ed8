#include "studies/codes/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/codes/conditions.hpp"
#include "studies/codes/start_state.hpp"

namespace mpmvv::codes {

using cases::Case;

namespace {

constexpr const char* axes = "xyz";

/// With all digits.
std::string text(double value) {
  return fmt::format("{:.17g}", value + 0.0);
}

void set(Fields& fields, const std::string& name, double value) {
  fields.set(name, text(value));
}

/// `word` is true of these words: is_plane of line, plane, solid.
void set_words(Fields& fields, const std::vector<std::string>& words, const std::string& word) {
  for (std::string each : words) {
    const bool is_it = each == word;
    std::ranges::replace(each, '-', '_');
    fields.set("is_" + each, is_it);
  }
}

void add_scheme(const Case& c, Fields& fields) {
  for (const auto& [name, value] : c.problem.parameters) set(fields, "param_" + name, value);
  set(fields, "cells", c.resolution.cells);
  set(fields, "ppc", c.resolution.ppc);
  fields.set("steps", fmt::format("{}", c.resolution.steps));
  fields.set("problem", c.problem.name);
  fields.set("boundary", c.scheme.boundary);
  set_words(fields, {"periodic", "symmetry", "dirichlet", "free"}, c.scheme.boundary);
  fields.set("is_quarter", c.problem.quarter);
  fields.set("variant", c.scheme.variant);
  fields.set("force_form", to_string(c.scheme.force_form));
  const auto forms = cases::words_of(c.scheme.force_form);
  set_words(fields, {forms.begin(), forms.end()}, to_string(c.scheme.force_form));
}

void add_conditions(const Case& c, Fields& fields) {
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

Fields particle_of(const StartState& state, std::size_t p) {
  Fields one;
  one.set("id", fmt::format("{}", state.id[p]));
  set(one, "m", state.m[p]);
  set(one, "V", state.V[p]);
  for (std::size_t d = 0; d < static_cast<std::size_t>(state.dimension); ++d) {
    set(one, std::string(1, "XYZ"[d]), state.X[p][d]);
    set(one, std::string(1, axes[d]), state.x[p][d]);
    set(one, fmt::format("v_{}", axes[d]), state.v[p][d]);
    for (std::size_t k = 0; k < static_cast<std::size_t>(state.dimension); ++k)
      set(one, fmt::format("F_{}{}", axes[d], axes[k]), state.F[p][3 * d + k]);
  }
  return one;
}

}  // namespace

Fields fields_of(const Case& c, const Code& code) {
  Fields fields;
  fields.set("program", code.program.string());
  fields.set("adapter", std::filesystem::absolute(code.adapter.folder).string());
  add_scheme(c, fields);
  add_conditions(c, fields);
  for (const auto& [name, value] : code.adapter.fields) fields.set(name, value);
  if (const auto variant = code.adapter.variants.find(c.scheme.variant); variant != code.adapter.variants.end())
    for (const auto& [name, value] : variant->second) fields.set(name, value);
  return fields;
}

Fields input_fields_of(const Case& c, const Code& code) {
  Fields fields = fields_of(c, code);
  const StartState state = start_state(c);
  Fields particles(Fields::type::list);
  for (std::size_t p = 0; p < state.size(); ++p) particles.push_back(particle_of(state, p));
  fields.set("particles", particles);
  fields.set("particle_count", fmt::format("{}", state.size()));
  return fields;
}

std::string filled_word(const std::string& word, const Fields& fields, const Code& code) {
  return filled(word, fields, (code.adapter.folder / "adapter.toml").string());
}

std::string filled_input(const InputFile& input, const Fields& fields) {
  return filled(input.text, fields, fmt::format("the template of {}", input.file));
}

void require_sound_templates(const Case& c, const Code& code) {
  const Fields fields = fields_of(c, code), input_fields = input_fields_of(c, code);
  for (const InputFile& input : code.adapter.inputs) filled_input(input, input_fields);
  for (const std::string& word : code.adapter.command) filled_word(word, fields, code);
  for (const auto& command : code.adapter.output.convert)
    for (const std::string& word : command) filled_word(word, fields, code);
  for (const std::string& file : {code.adapter.output.end, code.adapter.output.start}) filled_word(file, fields, code);
}

}  // namespace mpmvv::codes
