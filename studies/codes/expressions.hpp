#pragma once
#include <string>
#include <vector>

#include "mms/expression/dialect.hpp"
#include "studies/cases/case.hpp"

namespace mpmvv::codes {

using mms::expression::Dialect;

/// A problem's solution as expressions, by component. v0, u and rows of F0 that the dialect cannot write are empty.
struct Expressions {
  std::vector<std::string> b;                ///< body force per mass, in the form asked for; empty for per-particle
  std::vector<std::string> v0;               ///< velocity at t = 0, a function of X or x
  std::vector<std::string> u;                ///< displacement, a function of X and t; of x and t if only that is closed
  std::vector<std::vector<std::string>> F0;  ///< rows of F at t = 0, a function of X or x
};

/// Returns the expressions of a problem. v0 and F0 are functions of x if only the formulas in x and t are closed, or if
/// the dialect has no X and nothing is displaced at t = 0. Throws UsageError if the problem has no body force of that
/// form, or if the dialect cannot write it.
Expressions expressions(const cases::ProblemChoice& choice, cases::ForceForm form, const Dialect& dialect);

/// Returns b of each particle, by component, as expressions of time alone, in the order of `start_state`. Throws
/// UsageError like `expressions`.
std::vector<std::vector<std::string>> particle_forces(const cases::Case& c, const Dialect& dialect);

/// Returns the dialect with this name; UsageError with the known names otherwise. `where` goes into the message.
const Dialect& dialect_named(const std::string& name, const std::string& where);

}  // namespace mpmvv::codes
