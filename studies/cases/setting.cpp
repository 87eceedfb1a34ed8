#include "studies/cases/setting.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "studies/support/error.hpp"

namespace mpmvv::cases {

bool has_size(double value) {
  return std::abs(value) >= least_size && std::abs(value) <= largest_size;
}

namespace {

[[noreturn]] void refuse(const Setting& setting, const std::string& allowed) {
  throw support::UsageError(fmt::format("{} = {} in {} ({})", setting.key, setting.value, setting.where, allowed));
}

/// Reads a number. Returns whether the whole text is one that the type can hold. Throws UsageError for a text that is
/// too long for a message.
template <class Number>
bool reads(const Setting& setting, Number& value) {
  constexpr std::size_t longest = 100;
  const std::string& text = setting.value;
  if (text.size() > longest)
    throw support::UsageError(fmt::format("{} = {}... in {}, {} characters (a number of at most {})", setting.key,
                                          text.substr(0, 20), setting.where, text.size(), longest));
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end;
}

/// Reads a finite number that is 0 or has a size. `beside` is what the message offers in addition to numbers with a
/// size: 0 or nothing.
double number(const Setting& setting, const char* beside) {
  double value = 0;
  if (!reads(setting, value) || !std::isfinite(value))
    throw support::UsageError(
        fmt::format("{} = '{}' in {} (a finite number)", setting.key, setting.value, setting.where));
  if (value != 0 && !has_size(value))
    refuse(setting, fmt::format("{}a number from {} to {} in size", beside, least_size, largest_size));
  return value;
}

}  // namespace

double parse_number(const Setting& setting) {
  return number(setting, "0, or ");
}

double parse_number_in_size(const Setting& setting) {
  return number(setting, "");
}

double positive(const Setting& setting) {
  const double value = parse_number_in_size(setting);
  if (!(value > 0)) refuse(setting, "a number > 0");
  return value;
}

double not_negative(const Setting& setting) {
  const double value = parse_number(setting);
  if (value < 0) refuse(setting, "a number >= 0");
  return value;
}

std::int64_t whole(const Setting& setting, std::int64_t least, std::int64_t most) {
  std::int64_t value = 0;
  if (!reads(setting, value) || value < least || value > most)
    refuse(setting, fmt::format("a whole number from {} to {}", least, most));
  return value;
}

bool parse_flag(const Setting& setting) {
  if (setting.value != "true" && setting.value != "false") refuse(setting, "true or false");
  return setting.value == "true";
}

void require_word(const Setting& setting, const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), setting.value) == words.end())
    throw support::UsageError(fmt::format("unknown {} '{}' in {} (known: {})", setting.key, setting.value,
                                          setting.where, fmt::join(words, ", ")));
}

}  // namespace mpmvv::cases
