#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "solver/words.hpp"

/// Converts words into the solver's types and back, so that a rule can ask for a property of a type and need not list
/// words.
namespace mpmvv::settings {

/// Returns the alternative with this word. There must be one.
template <class Any>
Any named(std::string_view word) {
  Any any;
  solver::from_word(word, any);
  return any;
}

/// Returns the words of the alternatives that have a property, which a message offers to the user.
template <class Any, class Property>
std::vector<std::string> words_with(const Property& property) {
  std::vector<std::string> words;
  for (const std::string_view word : solver::words<Any>())
    if (property(named<Any>(word))) words.emplace_back(word);
  return words;
}

}  // namespace mpmvv::settings
