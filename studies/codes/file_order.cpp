#include "studies/codes/file_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <utility>

#include "studies/codes/text_column.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

namespace fs = std::filesystem;

namespace {

/// A number in a name, if a point may be that of a decimal number. It captures the decimals and the exponent.
const std::regex& decimal_number() {
  static const std::regex pattern(R"(\d+(?:\.(\d+))?([eE][-+]\d+(?![A-Za-z0-9]))?)");
  return pattern;
}

const std::regex& whole_number() {
  static const std::regex pattern(R"(\d+)");
  return pattern;
}

/// Returns the name of a file without its ending, which is no number: that of state.10 is a part of the name.
std::string bare_name(const fs::path& file) {
  const std::string ending = file.extension().string();
  const bool is_number = ending.size() > 1 && std::isdigit(static_cast<unsigned char>(ending[1])) != 0;
  return (is_number ? file.filename() : file.stem()).string();
}

/// The parts of a bare name: texts, each with the number behind it, and the text behind the last number.
using NameParts = std::vector<std::pair<std::string, double>>;

NameParts name_parts(const fs::path& file, const std::regex& number) {
  const std::string name = bare_name(file);
  NameParts parts;
  std::string rest = name;
  for (std::sregex_iterator it(name.begin(), name.end(), number), end; it != end; ++it) {
    TableColumn value;
    add_text(value, it->str());
    parts.emplace_back(it->prefix(), value.values.front());
    rest = it->suffix();
  }
  parts.emplace_back(rest, 0);
  return parts;
}

auto by_parts(const std::regex& number) {
  return [&number](const fs::path& a, const fs::path& b) {
    return std::pair(name_parts(a, number), a) < std::pair(name_parts(b, number), b);
  };
}

/// Whether the numbers behind points can only be decimals: a name has an exponent, or digits behind the point of the
/// k-th number begin with a zero and are more than those of another name.
bool are_decimals(const std::vector<fs::path>& files) {
  std::map<std::size_t, std::size_t> longest_padded, shortest;  // for each k
  for (const fs::path& file : files) {
    const std::string name = bare_name(file);
    std::size_t k = 0;
    for (std::sregex_iterator it(name.begin(), name.end(), decimal_number()), end; it != end; ++it, ++k) {
      if ((*it)[2].matched) return true;
      if (!(*it)[1].matched) continue;
      const std::string digits = (*it)[1];
      std::size_t& least = shortest.try_emplace(k, digits.size()).first->second;
      least = std::min(least, digits.size());
      if (digits.front() == '0') longest_padded[k] = std::max(longest_padded[k], digits.size());
    }
  }
  return std::ranges::any_of(longest_padded, [&](const auto& each) { return each.second > shortest.at(each.first); });
}

}  // namespace

void sort_by_name(std::vector<fs::path>& files) {
  std::ranges::sort(files, by_parts(decimal_number()));
}

fs::path last_by_name(const std::vector<fs::path>& files, const std::string& pattern) {
  const fs::path by_decimals = *std::ranges::max_element(files, by_parts(decimal_number()));
  const fs::path by_whole_numbers = *std::ranges::max_element(files, by_parts(whole_number()));
  if (by_decimals == by_whole_numbers || are_decimals(files)) return by_decimals;
  throw support::UsageError(fmt::format(
      "'{}' is {} and {}, and the last may be either, as numbers with a point are decimals or not (the exact "
      "name, which may hold fields, as in state_{{{{steps}}}}.csv)",
      pattern, by_decimals.filename().string(), by_whole_numbers.filename().string()));
}

}  // namespace mpmvv::codes
