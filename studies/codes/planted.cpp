#include "studies/codes/planted.hpp"

#include "studies/codes/expressions.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using cases::ForceForm;

namespace {

/// Whether the body force is anywhere other than 0. A problem that has it only as a function of x has one.
bool has_body_force(const cases::ProblemChoice& problem) {
  const Dialect& dialect = dialect_named("c", "the solution");
  const auto force = [&](ForceForm form) { return expressions(problem, form, dialect).b; };
  try {
    return force(ForceForm::reference) != force(ForceForm::none);
  } catch (const support::UsageError&) {
    return true;
  }
}

}  // namespace

bool is_planted(const cases::Case& c) {
  const ForceForm form = c.scheme.force_form;
  return (form == ForceForm::misplaced || form == ForceForm::none) && has_body_force(c.problem);
}

}  // namespace mpmvv::codes
