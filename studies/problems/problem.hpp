#pragma once
#include <string>
#include <variant>
#include <vector>

#include "mms/parameter.hpp"
#include "solver/boundary/images.hpp"
#include "studies/cases/case.hpp"

namespace mpmvv::problems {

using Parameters = decltype(cases::ProblemChoice::parameters);  ///< by name, all of a problem's parameters present

using mms::Parameter;

template <int D>
struct Setup;  // setup.hpp

template <int D>
using SetupFunction = Setup<D> (*)(const Parameters&);

/// Where the planes of symmetry lie about a quarter of a body.
enum class SymmetryPlanes { none, at_lower_faces, at_upper_faces };

/// A problem: domain, solution, material, end time, boundary kinds. One file in studies/problems/ and one line
/// in `problems()` each.
struct Problem {
  std::string name;
  std::string source;  ///< where it is defined: paper and section
  std::string length_formula;
  double (*length)(const Parameters&);  ///< L, m: h = L/cells
  std::vector<Parameter> parameters;
  /// Why the parameters do not go together, though each is allowed; empty when they do.
  std::string (*objection)(const Parameters&) = nullptr;
  std::string wave_speed_formula;
  double (*wave_speed)(const Parameters&);  ///< m/s, of the CFL number
  std::string end_time_formula;
  double (*end_time)(const Parameters&);  ///< s, the default
  /// s, until what it is about begins, where that depends on h; the default end time is so much later.
  double (*lead_time)(const Parameters&, double h) = nullptr;
  std::string boundary;                      ///< default
  std::string material = "neo-hookean-log";  ///< its law
  std::string other_material = {};           ///< that its body may be of instead: `Setup::other_law`; empty: none
  bool is_one_particle = false;              ///< whether it is one particle in one cell, at no other resolution
  /// Of its quarter, the part on one side of a plane of symmetry across each axis; `quarter` has no meaning without.
  SymmetryPlanes symmetry_planes = SymmetryPlanes::none;
  /// What besides maps its body, or its quarter, and their motion onto themselves.
  solver::Images images = solver::Images::none;
  /// Whether the solution needs a traction on the body's surface.
  bool (*is_loaded)(const Parameters&) = nullptr;
  std::variant<SetupFunction<1>, SetupFunction<2>, SetupFunction<3>> setup;

  int dimension() const { return static_cast<int>(setup.index()) + 1; }
  bool has_quarter() const { return symmetry_planes != SymmetryPlanes::none; }
  std::string default_boundary(bool quarter) const;
  /// The boundary with which a quarter moves as the whole body does with this word on all faces: continued by its
  /// mirror images at the planes of symmetry, and everywhere where the whole is periodic.
  std::string quarter_boundary(const std::string& word) const;
  bool has_solution(const Parameters& values) const;
  bool has_speed(const Parameters& values) const;
  bool has_wall(const Parameters& values, std::size_t face) const;
  bool is_curved(const Parameters& values) const;  ///< whether `fill` conforming has a meaning
};

/// All problems, in the order in which `list` shows them.
const std::vector<Problem>& problems();

/// The problem with this name; UsageError with the known names otherwise. `where` goes into the message.
const Problem& find_problem(const std::string& name, const std::string& where);

/// UsageError of a problem without an exact solution, with the names of those that have one.
[[noreturn]] void refuse_without_solution(const Problem& problem);

/// Defaults overwritten by the given ones.
Parameters complete_parameters(const Problem& problem, const Parameters& given);

/// Its body's volume over that of a cell, and the cells of its domain.
struct Extent {
  double cells_of_body, cells_of_domain;
};
Extent extent(const cases::Case& c);

std::vector<int> domain_cells(const cases::Case& c);  ///< along each axis

/// Between the problem's walls at the two faces of an axis, at a time; infinite where there are no two.
double cells_between_walls(const cases::Case& c, std::size_t axis, double t);

double cfl_number(const cases::Case& c);  ///< wave speed × time step / cell width

// The problems, each defined in its own file.
Problem bar_problem();
Problem bar_rest_problem();
Problem square_problem();
Problem square_rest_problem();
Problem square_inverse_problem();
Problem cube_problem();
Problem cube_rest_problem();
Problem ring_problem();
Problem vortex_problem();
Problem shell_problem();
Problem impact_problem();
Problem stretch_problem();
Problem stretch_1d_problem();
Problem stretch_3d_problem();
Problem pulse_problem();
Problem shock_problem();
Problem swing_problem();
Problem wave_problem();
Problem translation_problem();
Problem one_particle_problem();

}  // namespace mpmvv::problems
