#include "studies/support/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace mpmvv::support {

namespace {

std::string lower_case(std::string word) {
  for (char& letter : word) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return word;
}

std::vector<std::string> split(const std::string& list, const std::string& separator) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(separator, begin), list.size());
    words.push_back(list.substr(begin, end - begin));
    begin = end + separator.size();
  }
  return words;
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
  const std::string list_mark = " (known: ";
  const std::size_t word = message.find(" '") + 2, list = message.rfind(list_mark);
  if (!message.starts_with("unknown ") || list == std::string::npos || !message.ends_with(')')) return message;
  const std::size_t word_end = message.find('\'', word), list_begin = list + list_mark.size();
  if (word_end > list) return message;
  const auto known = split(message.substr(list_begin, message.size() - 1 - list_begin), ", ");
  const auto meant = nearest_word(message.substr(word, word_end - word), known);
  return meant ? fmt::format("{}; did you mean '{}'?)", message.substr(0, message.size() - 1), *meant) : message;
}

}  // namespace mpmvv::support
