#pragma once
#include <string>
#include <vector>

#include "studies/cases/case.hpp"

namespace mpmvv::problems {

struct Problem;

/// The fields of an exact solution at a reference point and a time: components of vectors, and rows of F and P.
struct Fields {
  std::vector<double> u, v, a, b;
  std::vector<std::vector<double>> F, P;
};

/// Returns the fields at X, which has the problem's dimension. Throws UsageError where the problem has no solution or X
/// is outside the body; `where` goes into the message.
Fields fields_at(const Problem& problem, const cases::ProblemChoice& choice, const std::vector<double>& X, double t,
                 const std::string& where);

}  // namespace mpmvv::problems
