#include "studies/support/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "studies/support/words.hpp"

namespace mpmvv::support {

namespace {

std::string lower_case(std::string word) {
  for (char& letter : word) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return word;
}

/// The items of a list as `listed` writes it.
std::vector<std::string> items_of(const std::string& list) {
  const std::string separator = ", ";
  std::vector<std::string> items;
  for (std::size_t begin = 0; begin < list.size();) {
    const std::string end_mark = list[begin] == '\'' ? "'" + separator : separator;
    const std::size_t quotes = end_mark.size() - separator.size(),
                      end = std::min(list.find(end_mark, begin + quotes), list.size() - quotes);
    items.push_back(list.substr(begin + quotes, end - begin - quotes));
    begin = end + end_mark.size();
  }
  return items;
}

/// " and 9 more; `mpmvv list problems` prints all" behind those that come nearest to the word.
std::string nearest_few(std::vector<std::string> known, const std::string& word, const std::string& kind) {
  constexpr std::size_t few = 8;
  static const std::map<std::string, std::string> printed_by{
      {"command", "--help"},          {"option", "--help"},   {"problem", "mpmvv list problems"},
      {"check", "mpmvv list checks"}, {"list", "mpmvv list"}, {"key", "mpmvv list study-file"},
  };
  const std::size_t more = known.size() - few;
  std::ranges::stable_sort(known, {}, [&word](const std::string& item) { return edit_distance(word, item); });
  known.resize(few);
  const auto command = printed_by.find(kind);
  return fmt::format("{} and {} more{}", listed(known), more,
                     command == printed_by.end() ? "" : fmt::format("; `{}` prints all", command->second));
}

}  // namespace

std::size_t edit_distance(const std::string& first, const std::string& second) {
  const std::string a = lower_case(first), b = lower_case(second);
  std::vector<std::vector<std::size_t>> distance(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& d = distance[i][j];
      d = std::max(i, j);
      if (i == 0 || j == 0) continue;
      const std::size_t replaced = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d = std::min(d, distance[i - 2][j - 2] + 1);
    }
  return distance.back().back();
}

std::optional<std::string> nearest_word(const std::string& word, const std::vector<std::string>& known) {
  if (word.empty() || known.empty()) return std::nullopt;
  const auto distance = [&word](const std::string& other) { return edit_distance(word, other); };
  const std::string& nearest = *std::ranges::min_element(known, {}, distance);
  if (distance(nearest) > std::max<std::size_t>(1, word.size() / 3)) return std::nullopt;
  return nearest;
}

std::string with_suggestion(const std::string& message) {
  constexpr std::size_t most_listed = 12;
  const std::string start = "unknown ", list_mark = " (known: ";
  const std::size_t word = message.find(" '") + 2, list = message.rfind(list_mark);
  if (!message.starts_with(start) || list == std::string::npos || !message.ends_with(')')) return message;
  const std::size_t word_end = message.find('\'', word), list_begin = list + list_mark.size();
  if (word_end > list) return message;
  const std::string unknown = message.substr(word, word_end - word);
  std::string known_text = message.substr(list_begin, message.size() - 1 - list_begin);
  const auto known = items_of(known_text);
  if (known.size() > most_listed)
    known_text = nearest_few(known, unknown, message.substr(start.size(), word - 2 - start.size()));
  const auto meant = nearest_word(unknown, known);
  return fmt::format("{}{}{}{})", message.substr(0, list), meant ? fmt::format("; did you mean '{}'?", *meant) : "",
                     list_mark, known_text);
}

}  // namespace mpmvv::support
