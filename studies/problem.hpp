#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mms/solution.hpp"
#include "solver/mpm.hpp"

namespace mpmvv {

using Parameters = std::map<std::string, double>;  ///< by name, all of a problem's parameters present

struct Parameter {
  std::string name;
  double value;  ///< default
  std::string unit;
  std::function<bool(double)> allowed;
  std::string range;  ///< `allowed` for people: "> 0"
};

/// What a problem hands to the runner: the body at rest in its domain and how it starts.
template <int D>
struct Setup {
  solver::Vec<D> lower = solver::Vec<D>::Zero();  ///< lower corner of the domain
  double density = 0;                             ///< kg/m³
  solver::AnyMaterial material;
  std::shared_ptr<mms::ManufacturedSolution<D>> solution = nullptr;  ///< null where no exact solution is known
  std::function<solver::Vec<D>(const solver::Vec<D>&)> start_velocity = nullptr;  ///< used when there is no solution
};

template <int D>
using SetupFunction = Setup<D> (*)(const Parameters&);

/// A problem: domain, solution, material, end time, boundary kinds. One file in studies/problems/ and one line
/// in `problems()` each.
struct Problem {
  std::string name;
  std::string source;  ///< where it is defined: paper and section
  double length;       ///< L, m: h = L/cells
  std::vector<Parameter> parameters;
  std::string wave_speed_formula;
  double (*wave_speed)(const Parameters&);  ///< m/s, of the CFL number
  std::string end_time_formula;
  double (*end_time)(const Parameters&);  ///< s, the default
  std::string boundary;                   ///< default
  std::variant<SetupFunction<1>, SetupFunction<2>, SetupFunction<3>> setup;

  int dimension() const { return static_cast<int>(setup.index()) + 1; }
};

/// All problems, in the order in which `list` shows them.
const std::vector<Problem>& problems();

/// The problem with this name; UsageError with the known names otherwise. `where` goes into the message.
const Problem& find_problem(const std::string& name, const std::string& where);

/// Defaults overwritten by the given ones.
Parameters complete_parameters(const Problem& problem, const Parameters& given);

// The problems, each defined in its own file.
Problem bar_problem();
Problem square_problem();
Problem cube_problem();
Problem one_particle_problem();

}  // namespace mpmvv
