#include "studies/codes/stated_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <span>
#include <vector>

#include "studies/codes/text_column.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

namespace {

using WordSpan = std::span<const std::string_view>;

std::string lower_case(std::string_view word) {
  std::string all(word);
  for (char& c : all) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return all;
}

/// Whether commas, semicolons or bars end a part of the text here. A comma before a digit may be a decimal one.
bool ends_part(std::string_view text, std::size_t at) {
  if (text[at] == ';' || text[at] == '|') return true;
  return text[at] == ',' && (at + 1 == text.size() || std::isdigit(static_cast<unsigned char>(text[at + 1])) == 0);
}

/// Returns the words of each part of the text. `=` and `:` are words of their own, brackets are blanks.
std::vector<std::vector<std::string_view>> parts_of(std::string_view text) {
  constexpr std::string_view blanks = " \t\r()[]", signs = "=:";
  std::vector<std::vector<std::string_view>> parts(1);
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    const bool is_end = at == text.size(), is_part = !is_end && ends_part(text, at);
    const bool is_sign = !is_end && signs.find(text[at]) != std::string_view::npos;
    if (!is_end && !is_part && !is_sign && blanks.find(text[at]) == std::string_view::npos) continue;
    if (at > begin) parts.back().push_back(text.substr(begin, at - begin));
    if (is_sign) parts.back().push_back(text.substr(at, 1));
    if (is_part) parts.emplace_back();
    begin = at + 1;
  }
  return parts;
}

bool is_second(const std::string& unit) {
  return unit == "s" || unit == "sec" || unit == "secs" || unit == "second" || unit == "seconds";
}

bool is_unit_of_time(const std::string& word) {
  static const std::vector<std::string> others{
      "ms",      "us",    "µs",          "μs",           "ns",          "ps",           "fs",         "msec",
      "usec",    "nsec",  "msecs",       "usecs",        "nsecs",       "min",          "mins",       "minute",
      "minutes", "h",     "hr",          "hrs",          "hour",        "hours",        "day",        "days",
      "year",    "years", "millisecond", "milliseconds", "microsecond", "microseconds", "nanosecond", "nanoseconds"};
  return is_second(word) || std::ranges::find(others, word) != others.end();
}

/// What stands behind a key.
struct Statement {
  std::string_view number, unit;
  bool has_sign = false;  ///< = or : before the number
  bool is_whole = false;  ///< whether nothing follows
};

/// Reads a number, with a sign before it and a unit before the sign or behind the number if there is one; nullopt if
/// there is no number.
std::optional<Statement> statement(WordSpan words) {
  Statement all;
  const auto take = [&words](auto is_it) {
    const bool is_next = !words.empty() && is_it(words.front());
    const std::string_view word = is_next ? words.front() : "";
    if (is_next) words = words.subspan(1);
    return word;
  };
  const auto is_unit = [](std::string_view word) { return is_unit_of_time(lower_case(word)); };
  all.unit = take(is_unit);
  all.has_sign = !take([](std::string_view word) { return word == "=" || word == ":"; }).empty();
  TableColumn number;
  all.number = take([&number](std::string_view word) { return add_text(number, word); });
  if (all.number.empty()) return std::nullopt;
  const bool is_next_key = words.size() > 1 && (words[1] == "=" || words[1] == ":");  // t = 0.5 h = 0.1
  if (const std::string_view unit = is_next_key ? "" : take(is_unit); !unit.empty()) all.unit = unit;
  all.is_whole = words.empty();
  return all;
}

void set_time(ParticleTable& table, std::string_view key, const Statement& stated, const std::string& place) {
  if (!stated.unit.empty() && !is_second(lower_case(stated.unit)))
    throw support::UsageError(fmt::format(
        "'{} = {} {}' in {} (in s, or the number alone, whose unit --time-unit or units of the adapter say)", key,
        stated.number, stated.unit, place));
  TableColumn number;
  add_text(number, stated.number);
  table.time = number.values.front();
  table.is_time_in_seconds = !stated.unit.empty();
}

void set_step(ParticleTable& table, std::string_view number) {
  std::int64_t step = 0;
  const char* end = number.data() + number.size();
  const auto [stop, error] = std::from_chars(number.data(), end, step);
  if (stop == end && error == std::errc()) table.step = step;
}

}  // namespace

void note_time(ParticleTable& table, std::string_view comment, const std::string& place) {
  bool has_time = table.time.has_value();
  for (const auto& words : parts_of(comment)) {
    const auto stated = words.empty() ? std::nullopt : statement(WordSpan(words).subspan(1));
    if (!stated || !stated->is_whole) continue;
    const std::string key = lower_case(words.front());
    if (key == "time" || (key == "t" && stated->has_sign && !has_time)) {
      set_time(table, words.front(), *stated, place);
      has_time = true;
    }
    if (key == "step" && stated->unit.empty()) set_step(table, stated->number);
  }
}

void note_time_of_title(ParticleTable& table, std::string_view title, const std::string& place) {
  for (const char* key : {"time", "t"})
    for (const auto& words : parts_of(title))
      for (std::size_t k = 0; k < words.size(); ++k) {
        const auto stated = lower_case(words[k]) == key ? statement(WordSpan(words).subspan(k + 1)) : std::nullopt;
        if (stated && stated->has_sign) return set_time(table, words[k], *stated, place);
      }
}

}  // namespace mpmvv::codes
