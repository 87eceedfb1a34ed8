#pragma once
#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

/// Words for enumerators. Each enum has one table beside it, `words_of(Enum)`, with a word for each enumerator in their
/// order. The enum's namespace says `using support::to_string;` so that `to_string(enumerator)` finds the template
/// here.
namespace mpmvv::support {

template <class Enum>
concept HasWords = std::is_enum_v<Enum> && requires(Enum e) {
  { *words_of(e).begin() } -> std::convertible_to<const char*>;
};

template <HasWords Enum>
std::string to_string(Enum e) {
  return words_of(e).at(static_cast<std::size_t>(e));
}

/// "a, b, 'c, d'", or "none" for an empty list: for messages that list what is known.
std::string listed(const std::vector<std::string>& names);

/// The index of the word in `words`; words.size() when it is not there.
std::size_t place_of(const std::string& word, std::span<const char* const> words);

/// Throws the UsageError for a word that is not among `words`.
[[noreturn]] void fail_unknown(const std::string& word, std::span<const char* const> words, const char* what,
                               const std::string& where);

/// The enumerator with this word. Without one throws a UsageError about an unknown `what` and, unless `where` is empty,
/// the place.
template <HasWords Enum>
Enum from_word(const std::string& word, const char* what, const std::string& where = "") {
  static constexpr auto words = words_of(Enum{});
  const std::size_t place = place_of(word, words);
  if (place == words.size()) fail_unknown(word, words, what, where);
  return static_cast<Enum>(place);
}

/// The element with this name. Without one throws a UsageError about an unknown `what` and the place.
template <class Named>
const Named& find_named(const std::vector<Named>& all, const std::string& name, const char* what,
                        const std::string& where) {
  const auto found = std::ranges::find(all, name, &Named::name);
  if (found != all.end()) return *found;
  std::vector<const char*> known;
  for (const Named& each : all) known.push_back(each.name.c_str());
  fail_unknown(name, known, what, where);
}

}  // namespace mpmvv::support
