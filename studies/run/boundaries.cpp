#include "studies/boundaries.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "solver/words.hpp"
#include "studies/error.hpp"
#include "studies/problem.hpp"

namespace mpmvv {

namespace {

std::vector<std::string> face_names(int dimension) {
  std::vector<std::string> names;
  for (int d = 0; d < dimension; ++d)
    for (const char* side : {"min", "max"}) names.push_back(fmt::format("{}{}", "xyz"[d], side));
  return names;
}

void require_boundary_word(const std::string& word, const std::string& where) {
  constexpr auto known = solver::words<solver::AnyBoundary>();
  if (std::find(known.begin(), known.end(), word) == known.end())
    throw UsageError(fmt::format("unknown boundary '{}' in {} (known: {})", word, where, fmt::join(known, ", ")));
}

int ghosts_of(const std::string& basis) {
  solver::AnyBasis any;
  solver::from_word(basis, any);
  return std::visit([]<class B>(const B&) { return B::ghost; }, any);
}

}  // namespace

std::vector<std::string> boundary_faces(const std::string& text, int dimension, const std::string& where) {
  const auto names = face_names(dimension);
  if (text.find('=') == std::string::npos) {
    require_boundary_word(text, where);
    return std::vector<std::string>(names.size(), text);
  }
  std::vector<std::string> words(names.size());
  std::istringstream parts(text.ends_with(',') ? text + ',' : text);  // so that a trailing comma is an empty part
  for (std::string part; std::getline(parts, part, ',');) {
    const auto equals = std::min(part.find('='), part.size());
    const auto face = std::find(names.begin(), names.end(), part.substr(0, equals));
    if (face == names.end())
      throw UsageError(
          fmt::format("unknown face in boundary '{}' in {} (faces: {})", part, where, fmt::join(names, ", ")));
    std::string& word = words[static_cast<std::size_t>(face - names.begin())];
    if (!word.empty()) throw UsageError(fmt::format("face '{}' given twice in boundary of {}", *face, where));
    word = part.substr(std::min(equals + 1, part.size()));
    require_boundary_word(word, where);
  }
  for (std::size_t k = 0; k < words.size(); ++k)
    if (words[k].empty())
      throw UsageError(
          fmt::format("boundary of {} does not name face '{}' (all of: {})", where, names[k], fmt::join(names, ", ")));
  return words;
}

std::string canonical_boundary(const std::string& text, int dimension, const std::string& where) {
  const auto words = boundary_faces(text, dimension, where);
  if (std::all_of(words.begin(), words.end(), [&](const auto& word) { return word == words[0]; })) return words[0];
  const auto names = face_names(dimension);
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < words.size(); ++k) parts.push_back(names[k] + "=" + words[k]);
  return fmt::format("{}", fmt::join(parts, ","));
}

void require_sense(const Case& c) {
  const Scheme& s = c.scheme;
  const int dimension = find_problem(c.problem.name, "the case").dimension();
  const auto faces = boundary_faces(s.boundary, dimension, "the case");
  const auto has = [&faces](const char* word) { return std::find(faces.begin(), faces.end(), word) != faces.end(); };

  if (ghosts_of(s.basis) == 0 && (has("periodic") || has("mirror")))
    throw UsageError(
        fmt::format("basis '{}' has no ghost nodes, so boundary '{}' has nothing to act on (use dirichlet, "
                    "symmetry or free, or a basis without '-open')",
                    s.basis, s.boundary));
  for (std::size_t k = 0; k < faces.size(); k += 2)
    if ((faces[k] == "periodic") != (faces[k + 1] == "periodic"))
      throw UsageError(
          fmt::format("boundary '{}' is periodic on one face only (both faces of an axis, or neither)", s.boundary));
  if (s.wall_acceleration == "difference" && !has("dirichlet") && !has("symmetry"))
    throw UsageError(
        fmt::format("wall_acceleration 'difference' with boundary '{}' that holds no node (use it with "
                    "dirichlet or symmetry)",
                    s.boundary));
  if (s.wall_acceleration == "difference" && s.integrator == "uvf")
    throw UsageError(
        "wall_acceleration 'difference' with integrator 'uvf', which maps the velocity after the acceleration (use "
        "zero, or another integrator)");
  if (s.wall_acceleration == "difference" && s.integrator == "rk4")
    throw UsageError(
        "wall_acceleration 'difference' with integrator 'rk4', whose stages have rates and no step to take a "
        "difference "
        "over (use zero, or another integrator)");
  if ((has("symmetry") || has("mirror")) && c.resolution.cells < 4)
    throw UsageError(
        fmt::format("{} cells are too few for boundary '{}' (at least 4: ghosts and their images must differ)",
                    c.resolution.cells, s.boundary));
  if ((s.basis == "gimp" || s.basis == "cpgimp") && c.resolution.ppc < 2)
    throw UsageError(
        fmt::format("basis '{}' with ppc = 1 (at least 2: a particle's width must stay below the cell's)", s.basis));
  if (c.problem.name == "one-particle" && (c.resolution.cells != 1 || c.resolution.ppc != 1))
    throw UsageError("problem 'one-particle' with other cells or ppc (cells = 1 and ppc = 1)");
  if (c.problem.name == "one-particle" && s.start == "exact")
    throw UsageError("problem 'one-particle' has no exact velocity for start 'exact' (use start 'half')");
  if (c.measure.nodal_error && c.problem.name == "one-particle")
    throw UsageError("problem 'one-particle' has no exact acceleration for nodal_error (leave it out)");
  if (c.measure.nodal_error && s.wall_acceleration == "difference")
    throw UsageError(
        "nodal_error with wall_acceleration 'difference', which belongs to a step and not to the end time (use zero)");
  if (!(c.measure.blowup_error > 0) || !(c.measure.blowup_energy > 0))
    throw UsageError("blowup_error and blowup_energy must be > 0");
}

}  // namespace mpmvv
