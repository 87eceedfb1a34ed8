#include "cli/length.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>

#include "studies/support/error.hpp"

namespace mpmvv::cli {

namespace {

constexpr double mm_per_inch = 25.4, mm_per_point = mm_per_inch / 72;

/// The length in mm; UsageError unless it is between `least` and `most` mm.
double length_of(const std::string& option, const std::string& text, double least, double most) {
  static const std::map<std::string, double> units{{"mm", 1}, {"cm", 10}, {"in", mm_per_inch}, {"pt", mm_per_point}};
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [unit, error] = std::from_chars(text.data(), end, number);
  const auto known = units.find(std::string(unit, end));
  if (error != std::errc() || known == units.end())
    throw support::UsageError(
        fmt::format("{} '{}' is no length (a number and its unit: 84mm, 8.4cm, 3.3in, 8pt)", option, text));
  const double length = number * known->second;
  if (!(length >= least && length <= most)) {
    constexpr double parts = 100;  // two decimals, rounded to lengths that are taken
    throw support::UsageError(
        fmt::format("{} {} ({:g}{unit} to {:g}{unit})", option, text, std::ceil(least / known->second * parts) / parts,
                    std::floor(most / known->second * parts) / parts, fmt::arg("unit", known->first)));
  }
  return length;
}

}  // namespace

double figure_width(const std::string& text) {
  return length_of("--width", text, least_width, greatest_width);
}

double figure_height(const std::string& text) {
  return length_of("--height", text, least_width, greatest_width);
}

double figure_font_size(const std::string& text) {
  return length_of("--font-size", text, 1.5, 10) / mm_per_point;
}

}  // namespace mpmvv::cli
