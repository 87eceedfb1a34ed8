#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "solver/boundary/boundaries.hpp"
#include "solver/words.hpp"
#include "studies/codes/code.hpp"
#include "studies/codes/field_names.hpp"
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

/// Whether a text has a name that is not a part of a longer one, as is_wall is of xmin_is_wall.
bool has_name(const std::string& text, const std::string& name) {
  const auto is_of_name = [&text](std::size_t at) {
    return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
  };
  for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
    if ((at == 0 || !is_of_name(at - 1)) && !is_of_name(at + name.size())) return true;
  return false;
}

/// Returns the condition on the boundary as a whole, such as is_wall, by which the templates tell boundaries; empty if
/// they have none, or also fields of faces.
std::string whole_condition(const Adapter& adapter) {
  std::string text;
  for (const InputFile& input : adapter.inputs) text += input.text + "\n";
  for (const std::string& word : adapter.command) text += word + "\n";
  for (std::size_t face = 0; face < 6; ++face)
    for (const std::string& field : {"boundary_" + face_name(face), face_name(face) + "_is_"})
      if (text.find(field) != std::string::npos) return "";
  for (const auto word : solver::words<solver::AnyBoundary>())
    if (std::string name = condition_name("is_", std::string(word)); has_name(text, name)) return name;
  return "";
}

/// Returns the start of the case on as few cells as hold some particles, for questions whose answer does not depend on
/// their number: a thin body may have none on four.
StartState some_start(const Case& c) {
  constexpr std::size_t some = 8;
  Case few = c;
  few.resolution.ppc = 2;
  for (few.resolution.cells = 4; few.resolution.cells < c.resolution.cells; few.resolution.cells *= 2)
    if (StartState start = start_state(few); start.size() >= some) return start;
  return start_state(c);
}

}  // namespace

Case as_given_to(const Adapter& adapter, Case c) {
  const std::string periodic(solver::Periodic::word), symmetry(solver::Symmetry::word);
  const std::vector<std::string>& known = adapter.capabilities.boundaries;
  const bool has_planes = problems::find_problem(c.problem.name, "the case").has_quarter();
  if (c.scheme.boundary == periodic && has_planes && !has(known, periodic) && has(known, symmetry))
    c.scheme.boundary = symmetry;
  return c;
}

void require_able(const Adapter& adapter, const Case& asked) {
  const Case c = as_given_to(adapter, asked);
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
    if (!has(able.boundaries, word))
      refuse(fmt::format("boundary '{}' (it can: {})", word, fmt::join(able.boundaries, ", ")));
  if (const std::string whole = whole_condition(adapter); boundaries_of(c, problem).size() > 1 && !whole.empty())
    throw support::UsageError(fmt::format(
        "code '{}' cannot run problem '{}': its faces differ, {}, and the templates of {} ask {} but nothing "
        "of a face (such as xmin_is_wall or boundary_xmin, docs/adapters.md)",
        adapter.name, problem.name, c.scheme.boundary, adapter.folder.string(), whole));
  const StartState start = some_start(c);
  if (!able.initial_velocity && !is_at_rest(start, problem.wave_speed(c.problem.parameters)))
    refuse("it starts with a velocity (problems at rest: `mpmvv list problems`)");
  if (!able.initial_deformation && !is_undeformed(start))
    refuse("it starts deformed (problems at rest: `mpmvv list problems`)");
}

}  // namespace mpmvv::codes
