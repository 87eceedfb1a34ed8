#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <memory>

#include "cli/case_options.hpp"
#include "cli/checks.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/setting_words.hpp"
#include "studies/codes/expressions.hpp"
#include "studies/codes/start_state.hpp"
#include "studies/support/error.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::cli {

namespace {

struct ExpressionOptions {
  CaseOptions of_case;
  std::string form, dialect;
  bool json = false;
};

using Components = std::vector<std::string>;

/// `b_x = ...`, a line for each component.
void print_components(const std::string& name, const Components& components) {
  for (std::size_t d = 0; d < components.size(); ++d) print("{}{} = {}\n", name, "xyz"[d], components[d]);
}

/// Prints the expressions. What the dialect cannot write is left out, with a note.
void print_expressions(const codes::Expressions& all, const codes::Dialect& dialect) {
  print_components("b_", all.b);
  print_components("v0_", all.v0);
  print_components("u_", all.u);
  for (std::size_t row = 0; row < all.F0.size(); ++row) print_components(fmt::format("F0_{}", "xyz"[row]), all.F0[row]);
  for (const auto& [name, components] : {std::pair("v0", &all.v0), {"u", &all.u}, {"F0", &all.F0.front()}})
    if (components->empty()) note("mpmvv: {} is left out: the dialect {} cannot write it\n", name, dialect.name);
}

/// A line for each particle, the expressions in quotes, as they may have commas.
void print_particle_forces(const std::vector<std::int64_t>& ids, const std::vector<Components>& forces) {
  std::string text = "id";
  for (std::size_t d = 0; d < forces.front().size(); ++d) text += fmt::format(",b_{}", "xyz"[d]);
  text += '\n';
  for (std::size_t p = 0; p < forces.size(); ++p)
    text += fmt::format("{},\"{}\"\n", ids[p], fmt::join(forces[p], "\",\""));
  print_text(text);
}

void print_force_of_particles(const ExpressionOptions& options, const codes::Dialect& dialect) {
  const cases::Case c = options.of_case.the_case();
  const auto forces = codes::particle_forces(c, dialect);
  const auto ids = codes::start_state(c).id;
  if (options.json)
    print_json({{"form", options.form}, {"dialect", dialect.name}, {"id", ids}, {"b", forces}});
  else
    print_particle_forces(ids, forces);
}

/// Throws where an option is given that only a whole case has.
void require_problem_alone(const ExpressionOptions& options) {
  for (const settings::Setting& setting : options.of_case.settings())
    if (setting.key != "problem" && setting.key != "quarter" && !setting.key.starts_with("param."))
      throw support::UsageError(fmt::format(
          "{} in {} has no meaning for form '{}', which is of the problem alone (--form per-particle takes a case)",
          setting.key, setting.where, options.form));
}

int expression(const ExpressionOptions& options) {
  const auto form = support::from_word<cases::ForceForm>(options.form, "form", "--form");
  const codes::Dialect& dialect = codes::dialect_named(options.dialect, "--dialect");
  if (form == cases::ForceForm::per_particle) {
    print_force_of_particles(options, dialect);
    return 0;
  }
  require_problem_alone(options);
  const cases::ProblemChoice choice = options.of_case.the_choice();
  const codes::Expressions all = codes::expressions(choice, form, dialect);
  if (options.json)
    print_json({{"problem", choice.name},
                {"parameters", choice.parameters},
                {"form", options.form},
                {"dialect", dialect.name},
                {"b", all.b},
                {"v0", all.v0},
                {"u", all.u},
                {"F0", all.F0}});
  else
    print_expressions(all, dialect);
  return 0;
}

std::vector<std::string> dialect_words() {
  std::vector<std::string> words;
  for (const codes::Dialect& dialect : mms::expression::dialects()) words.emplace_back(dialect.name);
  return words;
}

std::string dialect_texts() {
  std::string names;
  for (const codes::Dialect& dialect : mms::expression::dialects())
    names += fmt::format("{}{} ({})", names.empty() ? "" : "; ", dialect.name, dialect.what);
  return names;
}

}  // namespace

void add_expression(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ExpressionOptions>();
  CLI::App* command = app.add_subcommand(
      "expression", "Print body force, initial velocity, displacement and initial F as expressions, for other codes");
  options->of_case.add_to(*command, " with --form per-particle");
  command
      ->add_option(
          "--form", options->form,
          "of the body force: reference, b(X, t); inverse, b(x, t); current, b(t) where it is the same everywhere; "
          "per-particle, b(t) of each particle, as CSV, which alone takes the options of a whole case, all but "
          "--problem, --quarter and --param; misplaced, b(X, t) with x for X, a planted mistake; none, 0")
      ->type_name(word_of(setting_words("force_form")))
      ->default_val("reference");
  command->add_option("--dialect", options->dialect, dialect_texts())->type_name(word_of(dialect_words()))->required();
  command->add_flag("--json", options->json, "print one JSON object");
  add_examples(*command,
               {"mpmvv expression --problem square-rest --dialect c",
                "mpmvv expression --problem square-inverse --form inverse --dialect nairn",
                "mpmvv expression --problem bar-rest --cells 4 --ppc 2 --cfl 0.2 --form per-particle --dialect c"});
  command->callback([options, &exit_code] { exit_code = expression(*options); });
}

}  // namespace mpmvv::cli
