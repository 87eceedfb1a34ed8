#include "studies/codes/expressions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "mms/expression/formulas.hpp"
#include "studies/codes/start_state.hpp"
#include "studies/problems/setup.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

namespace {

using cases::ForceForm;
using cases::ProblemChoice;
using support::UsageError;
namespace expression = mms::expression;

constexpr std::array reference_axes{expression::Variable::X, expression::Variable::Y, expression::Variable::Z};
constexpr std::array current_axes{expression::Variable::x, expression::Variable::y, expression::Variable::z};

expression::Formulas formulas_of(const problems::Problem& problem, const ProblemChoice& choice) {
  const auto of_setup = [&]<int D>(problems::SetupFunction<D>) {
    const auto setup = problems::make_setup<D>(problem, choice, 0);
    return setup.solution ? setup.solution->formulas() : expression::Formulas{};
  };
  return std::visit(of_setup, problem.setup);
}

bool depends_on_place(const expression::Vector& b) {
  const auto has_place = [](const expression::Traced& component) {
    const auto has = [&component](expression::Variable axis) { return component.contains(axis); };
    return std::ranges::any_of(reference_axes, has) || std::ranges::any_of(current_axes, has);
  };
  return std::ranges::any_of(b, has_place);
}

/// Whether the formulas give the body force in this form. For `none`, b = 0, any formulas do.
bool has_form(const expression::Formulas& formulas, ForceForm form) {
  const auto& [reference, inverse] = formulas;
  const bool is_of_time = reference && !depends_on_place(reference->b);
  if (form == ForceForm::current) return is_of_time;
  if (form == ForceForm::inverse) return is_of_time || inverse;
  return form == ForceForm::none ? reference || inverse : reference.has_value();
}

std::string problems_with(ForceForm form) {
  std::vector<std::string> names;
  for (const problems::Problem& problem : problems::problems()) {
    const ProblemChoice choice{.name = problem.name, .parameters = problems::complete_parameters(problem, {})};
    if (has_form(formulas_of(problem, choice), form)) names.push_back(problem.name);
  }
  return fmt::format("problems with form '{}': {}", to_string(form), fmt::join(names, ", "));
}

[[noreturn]] void refuse_current(const std::string& problem, ForceForm form, const std::string& why) {
  throw UsageError(
      fmt::format("form '{}' of problem '{}': {} ({})", to_string(form), problem, why, problems_with(form)));
}

/// Replaces the variables X, Y, Z by x, y, z, without regard to the motion.
expression::Vector misplaced(expression::Vector b) {
  for (std::size_t d = 0; d < reference_axes.size(); ++d)
    for (expression::Traced& component : b) component = substitute(component, reference_axes[d], current_axes[d]);
  return b;
}

expression::Vector force(const expression::Formulas& formulas, const std::string& problem, ForceForm form) {
  const auto& [reference, inverse] = formulas;
  const std::string to_place = "its body force depends on the position";
  switch (form) {
    case ForceForm::none:
      return expression::nothing((reference ? reference : inverse)->b.size());
    case ForceForm::inverse:
      if (inverse) return inverse->b;
      if (!depends_on_place(reference->b)) return reference->b;
      refuse_current(problem, form, to_place + ", and X(x, t) has no closed form");
    case ForceForm::current:
      if (reference && !depends_on_place(reference->b)) return reference->b;
      refuse_current(problem, form, to_place);
    case ForceForm::reference:
    case ForceForm::misplaced:
    case ForceForm::per_particle:
      break;
  }
  if (!reference)
    throw UsageError(fmt::format("form '{}' of problem '{}': x(X, t) has no closed form (form 'inverse'; {})",
                                 to_string(form), problem, problems_with(form)));
  return form == ForceForm::misplaced ? misplaced(reference->b) : reference->b;
}

expression::Formulas known_formulas(const ProblemChoice& choice) {
  expression::Formulas formulas = formulas_of(problems::find_problem(choice.name, "the case"), choice);
  if (formulas.reference || formulas.inverse) return formulas;
  throw UsageError(
      fmt::format("problem '{}' has no solution in formulas ({})", choice.name, problems_with(ForceForm::reference)));
}

expression::Vector at_start(expression::Vector of_time) {
  for (expression::Traced& component : of_time) component = substitute(component, expression::Variable::t, 0);
  return of_time;
}

std::vector<std::string> written(const expression::Vector& components, const Dialect& dialect) {
  std::vector<std::string> texts;
  for (const expression::Traced& component : components) texts.push_back(text(component, dialect));
  return texts;
}

/// Returns the components in the dialect; empty if it cannot write one of them.
std::vector<std::string> written_if_possible(const expression::Vector& components, const Dialect& dialect) {
  try {
    return written(components, dialect);
  } catch (const expression::NotWritable&) {
    return {};
  }
}

std::vector<std::string> written_force(const expression::Vector& b, const Dialect& dialect, ForceForm form) {
  try {
    return written(b, dialect);
  } catch (const expression::NotWritable& e) {
    throw UsageError(fmt::format("form '{}' in dialect '{}': {} (another form or dialect)", to_string(form),
                                 dialect.name, e.what()));
  }
}

/// Returns the expressions as functions of x if the dialect has no X and nothing is displaced at t = 0; else unchanged.
expression::Vector in_any_place(const expression::Vector& start, const expression::Fields& fields,
                                const Dialect& dialect) {
  const expression::Vector moved = at_start(fields.u);
  const bool is_moved = std::ranges::any_of(moved, [](const expression::Traced& u) { return !u.is(0); });
  return is_moved || !dialect.variable(expression::Variable::X).empty() ? start : misplaced(start);
}

}  // namespace

Expressions expressions(const ProblemChoice& choice, ForceForm form, const Dialect& dialect) {
  const expression::Formulas formulas = known_formulas(choice);
  const expression::Fields& fields = formulas.reference ? *formulas.reference : *formulas.inverse;
  const auto start = [&](const expression::Vector& of_time) {
    return written_if_possible(in_any_place(at_start(of_time), fields, dialect), dialect);
  };
  Expressions all;
  if (form != ForceForm::per_particle) all.b = written_force(force(formulas, choice.name, form), dialect, form);
  all.v0 = start(fields.v);
  all.u = written_if_possible(fields.u, dialect);
  for (const expression::Vector& row : fields.F) all.F0.push_back(start(row));
  return all;
}

std::vector<std::vector<std::string>> particle_forces(const cases::Case& c, const Dialect& dialect) {
  const expression::Vector b = force(known_formulas(c.problem), c.problem.name, ForceForm::per_particle);
  const StartState state = start_state(c);
  std::vector<std::vector<std::string>> all;
  for (const Point& X : state.X) {
    expression::Vector of_time = b;
    for (std::size_t d = 0; d < reference_axes.size(); ++d)
      for (expression::Traced& component : of_time) component = substitute(component, reference_axes[d], X[d]);
    all.push_back(written_force(of_time, dialect, ForceForm::per_particle));
  }
  return all;
}

const Dialect& dialect_named(const std::string& name, const std::string& where) {
  const auto& all = expression::dialects();
  const auto found = std::ranges::find(all, name, &Dialect::name);
  if (found != all.end()) return *found;
  std::vector<std::string_view> known;
  for (const Dialect& dialect : all) known.push_back(dialect.name);
  throw UsageError(fmt::format("unknown dialect '{}' in {} (known: {})", name, where, fmt::join(known, ", ")));
}

}  // namespace mpmvv::codes
