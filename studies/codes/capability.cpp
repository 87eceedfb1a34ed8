#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "solver/boundary/boundaries.hpp"
#include "studies/codes/code.hpp"
#include "studies/codes/start_state.hpp"
#include "studies/problems/problem.hpp"
#include "studies/settings/boundaries.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using cases::Case;
using problems::Problem;

namespace {

template <class List, class Value>
bool has(const List& list, const Value& value) {
  return std::ranges::find(list, value) != list.end();
}

/// Returns the boundary words of the case's faces, each once.
std::vector<std::string> boundaries_of(const Case& c, const Problem& problem) {
  std::vector<std::string> words;
  for (const std::string& face : settings::boundary_faces(c.scheme.boundary, problem.dimension(), "the case"))
    if (!has(words, face)) words.push_back(face);
  return words;
}

/// Whether the code has this boundary, or one with which the case moves in the same way: `symmetry` for `periodic`
/// where the problem has planes of symmetry on its faces.
bool is_met(const std::string& word, const Problem& problem, const Capabilities& able) {
  const bool has_planes = word == solver::Periodic::word && problem.has_quarter();
  return has(able.boundaries, word) || (has_planes && has(able.boundaries, std::string(solver::Symmetry::word)));
}

/// Returns the case on few cells, for questions whose answer does not depend on their number.
Case on_few_cells(Case c) {
  c.resolution.cells = std::min(c.resolution.cells, 4);
  c.resolution.ppc = 2;
  return c;
}

}  // namespace

void require_able(const Adapter& adapter, const Case& c) {
  const Problem& problem = problems::find_problem(c.problem.name, "the case");
  const Capabilities& able = adapter.capabilities;
  const auto refuse = [&](const std::string& why) {
    throw support::UsageError(fmt::format("code '{}' cannot run problem '{}': {} ([capabilities] of {})", adapter.name,
                                          problem.name, why, (adapter.folder / "adapter.toml").string()));
  };
  if (!has(able.dimensions, problem.dimension()))
    refuse(fmt::format("it has {} dimensions (it can: {})", problem.dimension(), fmt::join(able.dimensions, ", ")));
  if (!has(able.force_forms, to_string(c.scheme.force_form)))
    refuse(
        fmt::format("force_form '{}' (it can: {})", to_string(c.scheme.force_form), fmt::join(able.force_forms, ", ")));
  if (!has(able.materials, c.scheme.material)) {
    const std::string other = has(able.materials, problem.other_material)
                                  ? fmt::format("; the problem takes material = {}, too", problem.other_material)
                                  : "";
    refuse(fmt::format("material '{}' (it can: {}{})", c.scheme.material, fmt::join(able.materials, ", "), other));
  }
  for (const std::string& word : boundaries_of(c, problem))
    if (!is_met(word, problem, able))
      refuse(fmt::format("boundary '{}' (it can: {})", word, fmt::join(able.boundaries, ", ")));
  const StartState start = start_state(on_few_cells(c));
  if (!able.initial_velocity && !is_at_rest(start, problem.wave_speed(c.problem.parameters)))
    refuse("it starts with a velocity (problems at rest: `mpmvv list problems`)");
  if (!able.initial_deformation && !is_undeformed(start))
    refuse("it starts deformed (problems at rest: `mpmvv list problems`)");
}

}  // namespace mpmvv::codes
