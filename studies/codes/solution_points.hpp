#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/codes/readers.hpp"

namespace mpmvv::codes {

/// What is asked of a solution at many points. The points have the columns X, Y and Z as far as the problem has these
/// axes, and may have t, and NX, NY and NZ for a surface's normal of any length. Other columns are ignored.
struct PointQuery {
  Source points;                                   ///< CSV
  std::optional<double> time = {};                 ///< the time of all points, s; without it there must be a column t
  std::optional<std::vector<double>> normal = {};  ///< the normal at all points; without it there may be columns
  std::vector<std::string> fields = {};  ///< words of `solution_fields`; empty: all, the traction only with normals
};

/// Returns the names of all fields: u, v, a, b, F, P and traction, which is P N.
std::vector<std::string> solution_fields();

/// Makes a CSV and hands it to `write` in parts: a header, and for each point its coordinates, t and the fields with 17
/// digits. Throws UsageError for a bad point, with its file and line.
void solution_at(const cases::ProblemChoice& choice, const PointQuery& query,
                 const std::function<void(const std::string&)>& write);

}  // namespace mpmvv::codes
