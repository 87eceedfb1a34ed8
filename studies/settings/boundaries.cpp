#include "studies/settings/boundaries.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "solver/boundary/boundaries.hpp"
#include "solver/words.hpp"
#include "studies/problems/problem.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings {

using support::UsageError;

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
    if (!word.empty()) throw UsageError(fmt::format("face '{}' given twice in boundary of {} (once)", *face, where));
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

std::vector<bool> movable_axes(const std::vector<std::string>& faces) {
  const auto is_movable = [](const std::string& word) {
    return word == solver::Periodic::word || word == solver::Free::word;
  };
  std::vector<bool> movable;
  for (std::size_t k = 0; k < faces.size(); k += 2) movable.push_back(is_movable(faces[k]) && is_movable(faces[k + 1]));
  return movable;
}

}  // namespace mpmvv::settings
