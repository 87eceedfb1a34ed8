#include "studies/codes/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/runs/scene.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using cases::Case;
using problems::Problem;

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

void add_case(const Case& c, const Problem& problem, Fields& fields) {
  const double h = problem.length(c.problem.parameters) / c.resolution.cells,
               speed = problem.wave_speed(c.problem.parameters);
  for (const auto& [name, value] : c.problem.parameters) set(fields, "param_" + name, value);
  set(fields, "cells", c.resolution.cells);
  set(fields, "ppc", c.resolution.ppc);
  set(fields, "h", h);
  set(fields, "particle_width", h / c.resolution.ppc);
  set(fields, "dt", c.resolution.dt);
  fields.set("steps", fmt::format("{}", c.resolution.steps));
  set(fields, "end_time", static_cast<double>(c.resolution.steps) * c.resolution.dt);
  set(fields, "cfl", speed * c.resolution.dt / h);
  set(fields, "wave_speed", speed);
  set(fields, "dimension", problem.dimension());
  static const std::vector<std::string> shapes{"line", "plane", "solid"};
  set_words(fields, shapes, shapes[static_cast<std::size_t>(problem.dimension() - 1)]);
  fields.set("problem", c.problem.name);
  fields.set("material", c.scheme.material);
  fields.set("boundary", c.scheme.boundary);
  set_words(fields, {"periodic", "symmetry", "dirichlet", "free"}, c.scheme.boundary);
  fields.set("is_quarter", c.problem.quarter);
  fields.set("variant", c.scheme.variant);
  fields.set("force_form", to_string(c.scheme.force_form));
  const auto forms = cases::words_of(c.scheme.force_form);
  set_words(fields, {forms.begin(), forms.end()}, to_string(c.scheme.force_form));
}

void add_material(const solver::AnyMaterial& material, Fields& fields) {
  std::visit(
      [&](const auto& law) {
        if constexpr (requires { law.lambda; }) {
          const double lambda = law.lambda, mu = law.mu;
          set(fields, "lambda", lambda);
          set(fields, "mu", mu);
          set(fields, "bulk_modulus", lambda + 2 * mu / 3);
          set(fields, "youngs_modulus", mu * (3 * lambda + 2 * mu) / (lambda + mu));
          set(fields, "poissons_ratio", lambda / (2 * (lambda + mu)));
        }
      },
      material);
}

template <int D>
void add_domain(const Case& c, const Problem& problem, Fields& fields) {
  const double h = problem.length(c.problem.parameters) / c.resolution.cells;
  const problems::Setup<D> setup = problems::make_setup<D>(problem, c.problem, h);
  const auto domain = std::visit([h](const auto& body) { return problems::domain(body, h); }, setup.body);
  for (int d = 0; d < D; ++d) {
    const int cells = domain.cells[static_cast<std::size_t>(d)];
    set(fields, fmt::format("lower_{}", axes[d]), domain.lower[d]);
    set(fields, fmt::format("upper_{}", axes[d]), domain.lower[d] + h * cells);
    set(fields, fmt::format("cells_{}", axes[d]), cells);
  }
  set(fields, "density", setup.density);
  add_material(setup.material, fields);
}

template <int D>
Fields particles_of(const Case& c, const Problem& problem) {
  const runs::PreparedCase<D> prepared = runs::prepare_case<D>(c, problem, 1);
  const solver::Particles<D>& particles = prepared.scene.particles;
  Fields list(Fields::type::list);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    Fields one;
    one.set("id", fmt::format("{}", particles.id[p] + 1));
    for (int d = 0; d < D; ++d) {
      set(one, std::string(1, "XYZ"[d]), prepared.X[particles.id[p]][d]);
      set(one, std::string(1, axes[d]), particles.x[p][d]);
      set(one, fmt::format("v_{}", axes[d]), particles.v[p][d]);
      for (int k = 0; k < D; ++k) set(one, fmt::format("F_{}{}", axes[d], axes[k]), particles.F[p](d, k));
    }
    set(one, "m", particles.m[p]);
    set(one, "V", particles.V0[p]);
    list.push_back(one);
  }
  return list;
}

}  // namespace

Fields fields_of(const Case& c, const Code& code) {
  const Problem& problem = problems::find_problem(c.problem.name, "the case");
  Fields fields;
  fields.set("program", code.program.string());
  fields.set("adapter", std::filesystem::absolute(code.adapter.folder).string());
  add_case(c, problem, fields);
  std::visit([&]<int D>(problems::SetupFunction<D>) { add_domain<D>(c, problem, fields); }, problem.setup);
  for (const auto& [name, value] : code.adapter.fields) fields.set(name, value);
  if (const auto variant = code.adapter.variants.find(c.scheme.variant); variant != code.adapter.variants.end())
    for (const auto& [name, value] : variant->second) fields.set(name, value);
  return fields;
}

Fields input_fields_of(const Case& c, const Code& code) {
  const Problem& problem = problems::find_problem(c.problem.name, "the case");
  Fields fields = fields_of(c, code);
  Fields particles =
      std::visit([&]<int D>(problems::SetupFunction<D>) { return particles_of<D>(c, problem); }, problem.setup);
  fields.set("particle_count", fmt::format("{}", particles.list_value().size()));
  fields.set("particles", particles);
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
