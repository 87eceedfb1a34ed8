#include <fmt/format.h>
#include <fmt/ranges.h>

#include "studies/error.hpp"
#include "studies/problem.hpp"

namespace mpmvv {

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all{
      bar_problem(),
      square_problem(),
      cube_problem(),
      one_particle_problem(),
  };
  return all;
}

const Problem& find_problem(const std::string& name, const std::string& where) {
  std::vector<std::string> known;
  for (const Problem& problem : problems()) {
    if (problem.name == name) return problem;
    known.push_back(problem.name);
  }
  throw UsageError(fmt::format("unknown problem '{}' in {} (known: {})", name, where, fmt::join(known, ", ")));
}

Parameters complete_parameters(const Problem& problem, const Parameters& given) {
  Parameters all = given;
  for (const Parameter& parameter : problem.parameters) all.emplace(parameter.name, parameter.value);
  return all;
}

}  // namespace mpmvv
