#pragma once
#include <string>
#include <variant>
#include <vector>

#include "mms/parameter.hpp"
#include "solver/boundary/images.hpp"
#include "studies/cases/case.hpp"

namespace mpmvv::problems {

using Parameters =
    decltype(cases::ProblemChoice::parameters);  ///< by name; functions of a problem need all of its parameters

using mms::Parameter;

template <int D>
struct Setup;  // setup.hpp

template <int D>
using SetupFunction = Setup<D> (*)(const Parameters&);

/// On which faces of a quarter of a body the planes of symmetry lie.
enum class SymmetryPlanes { none, at_lower_faces, at_upper_faces };

/// A problem: domain, solution, material, end time, boundary kinds. Each has a file in studies/problems/ and a line in
/// `problems()`.
struct Problem {
  std::string name;
  std::string source;  ///< where it is defined: paper and section
  std::string length_formula;
  double (*length)(const Parameters&);  ///< L, m; h = L/cells
  std::vector<Parameter> parameters;
  /// Returns why the parameters do not go together, though each is allowed; empty when they do. Null: they always do.
  std::string (*objection)(const Parameters&) = nullptr;
  std::string wave_speed_formula;
  double (*wave_speed)(const Parameters&);  ///< the speed in the CFL number, m/s
  std::string end_time_formula;
  double (*end_time)(const Parameters&);  ///< the default, s
  /// Returns the time, s, until the event of interest begins, in problems where it depends on h. It is added to the
  /// default end time.
  double (*lead_time)(const Parameters&, double h) = nullptr;
  std::string boundary;                      ///< the default
  std::string material = "neo-hookean-log";  ///< the word of its law
  std::string other_material = {};           ///< word of `Setup::other_law`, which its body may have; empty: none
  bool is_one_particle = false;              ///< whether it is one particle in one cell, with no other resolution
  /// The planes of symmetry of its quarter, which is the part on one side of such a plane across each axis. With `none`
  /// the setting `quarter` has no meaning.
  SymmetryPlanes symmetry_planes = SymmetryPlanes::none;
  /// The further images that map its body, or its quarter, and the motion onto themselves.
  solver::Images images = solver::Images::none;
  /// Whether the solution needs a traction on the body's surface.
  bool (*is_loaded)(const Parameters&) = nullptr;
  std::variant<SetupFunction<1>, SetupFunction<2>, SetupFunction<3>> setup;

  int dimension() const { return static_cast<int>(setup.index()) + 1; }
  bool has_quarter() const { return symmetry_planes != SymmetryPlanes::none; }
  std::string default_boundary(bool quarter) const;
  /// Returns the boundary with which a quarter moves as the whole body does with this word on all faces: `mirror` at
  /// the planes of symmetry, and on the other faces the word, or `mirror` if the word is `periodic`.
  std::string quarter_boundary(const std::string& word) const;
  bool has_solution(const Parameters& values) const;
  bool has_speed(const Parameters& values) const;
  bool has_wall(const Parameters& values, std::size_t face) const;
  bool is_curved(const Parameters& values) const;  ///< whether `fill` may be `conforming`
};

/// All problems, in the order in which `list` shows them.
const std::vector<Problem>& problems();

/// Returns the problem with this name. Throws UsageError, with the known names, where there is none; `where` goes into
/// the message.
const Problem& find_problem(const std::string& name, const std::string& where);

/// Throws the UsageError for a problem without an exact solution, with the names of the problems that have one.
[[noreturn]] void refuse_without_solution(const Problem& problem);

/// Returns all parameters of the problem: the given ones, and defaults for the rest.
Parameters complete_parameters(const Problem& problem, const Parameters& given);

/// The size of a case: the volume of its body over that of a cell, and the number of cells of its domain.
struct Extent {
  double cells_of_body, cells_of_domain;
};
Extent extent(const cases::Case& c);

std::vector<int> domain_cells(const cases::Case& c);  ///< their number along each axis

/// Returns the least distance during the case, in cells, between the problem's walls at the two faces of an axis;
/// infinity where it does not have both.
double least_cells_between_walls(const cases::Case& c, std::size_t axis);

double cfl_number(const cases::Case& c);  ///< wave speed × time step / cell width

/// Returns the CFL number with which the P wave of the problem's own material would go as far in a step as that of the
/// case's: another Poisson's ratio changes its speed, but not that of most CFL numbers.
double p_wave_cfl_number(const cases::Case& c);

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
