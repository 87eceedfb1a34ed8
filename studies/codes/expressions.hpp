#pragma once
#include <string>
#include <vector>

#include "mms/expression/dialect.hpp"
#include "studies/cases/case.hpp"

namespace mpmvv::codes {

using mms::expression::Dialect;

/// What a code is given of a problem's solution as expressions, by component; empty where the dialect cannot say it.
struct Expressions {
  std::vector<std::string> b;                ///< body force per mass, in the form asked for; empty with per-particle
  std::vector<std::string> v0;               ///< velocity at t = 0, of X
  std::vector<std::string> u;                ///< displacement, of X and t; of x and t where that alone is closed
  std::vector<std::vector<std::string>> F0;  ///< rows of F at t = 0, of X
};

/// UsageError where the problem has no body force of that form, and where the dialect cannot write it.
Expressions expressions(const cases::ProblemChoice& choice, cases::ForceForm form, const Dialect& dialect);

/// b of each particle, by component, as expressions of time alone: in the order of `start_state`.
std::vector<std::vector<std::string>> particle_forces(const cases::Case& c, const Dialect& dialect);

/// UsageError with the known ones where there is none. `where` goes into the message.
const Dialect& dialect_named(const std::string& name, const std::string& where);

}  // namespace mpmvv::codes
