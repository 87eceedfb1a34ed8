#pragma once
#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

/// Words of enums. Beside an enum stands its one table, `words_of(Enum)`: a word for each enumerator, in their order.
/// With `using support::to_string;` its namespace lets `to_string(enumerator)` find this.
namespace mpmvv::support {

template <class Enum>
concept HasWords = std::is_enum_v<Enum> && requires(Enum e) {
  { *words_of(e).begin() } -> std::convertible_to<const char*>;
};

template <HasWords Enum>
std::string to_string(Enum e) {
  return words_of(e).at(static_cast<std::size_t>(e));
}

/// "a, b", or "none" where there are none: what a message says is known.
std::string listed(const std::vector<std::string>& names);

/// The place of the word among these, or their number when it is none of them.
std::size_t place_of(const std::string& word, std::span<const char* const> words);

/// UsageError of a word that is none of these.
[[noreturn]] void fail_unknown(const std::string& word, std::span<const char* const> words, const char* what,
                               const std::string& where);

/// The enumerator with this word; a UsageError speaks of an unknown `what` and, where it is known, the place.
template <HasWords Enum>
Enum from_word(const std::string& word, const char* what, const std::string& where = "") {
  static constexpr auto words = words_of(Enum{});
  const std::size_t place = place_of(word, words);
  if (place == words.size()) fail_unknown(word, words, what, where);
  return static_cast<Enum>(place);
}

/// The one of this name; a UsageError speaks of an unknown `what` and the place.
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
