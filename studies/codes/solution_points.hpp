#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/codes/readers.hpp"

namespace mpmvv::codes {

/// What is asked of a solution at many points: the columns X, Y and Z as far as the problem has them, t, and NX, NY and
/// NZ, a surface's normal, of any length. Other columns are left alone.
struct PointQuery {
  Source points;                                   ///< CSV
  std::optional<double> time = {};                 ///< s, of all points; where it is not given there is a column t
  std::optional<std::vector<double>> normal = {};  ///< of all points; where it is not given there may be columns of it
  std::vector<std::string> fields = {};  ///< of `solution_fields`; none: all, and tractions where there are normals
};

/// u, v, a, b, F, P and traction, which is P N.
std::vector<std::string> solution_fields();

/// Hands a CSV on in parts: a header, and for each point its coordinates, t and the fields, 17 digits. UsageError with
/// file and line of a bad point.
void solution_at(const cases::ProblemChoice& choice, const PointQuery& query,
                 const std::function<void(const std::string&)>& write);

}  // namespace mpmvv::codes
