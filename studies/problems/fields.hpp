#pragma once
#include <string>
#include <vector>

#include "studies/cases/case.hpp"

namespace mpmvv::problems {

struct Problem;

/// The fields of an exact solution at a reference point and a time, by components; of F and P the rows.
struct Fields {
  std::vector<double> u, v, a, b;
  std::vector<std::vector<double>> F, P;
};

/// UsageError where the problem has no solution or X, which has its dimension, is outside the body; `where` goes into
/// the message.
Fields fields_at(const Problem& problem, const cases::ProblemChoice& choice, const std::vector<double>& X, double t,
                 const std::string& where);

}  // namespace mpmvv::problems
