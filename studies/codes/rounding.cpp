#include "studies/codes/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace mpmvv::codes {

namespace {

/// Returns the unit in the last place of a number: from the bits of its mantissa if it is binary (`bits` > 0), else
/// from the decimals of its text if they count (`decimals` >= 0), else from its significant digits.
double unit_of(double value, int digits, int decimals, int bits) {
  if (bits > 0) return value == 0 ? 0 : std::ldexp(1.0, std::ilogb(value) - bits + 1);
  if (decimals >= 0) return std::pow(10.0, -decimals);
  return value == 0 ? 0 : std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1 - digits);
}

/// Returns the number of decimals that all columns show; -1 if they differ.
int common_decimals(const std::vector<const TableColumn*>& columns) {
  const int first = columns.front()->decimals;
  const auto other = [first](const TableColumn* column) { return column->decimals != first; };
  return std::any_of(columns.begin(), columns.end(), other) ? -1 : first;
}

/// Whether there are so many different coordinates that all being short shows how they were rounded, and not that they
/// lie on a lattice.
bool are_many(const std::vector<const TableColumn*>& coordinates) {
  constexpr std::size_t many = 200;
  std::set<double> different;
  for (const TableColumn* column : coordinates)
    for (const double value : column->values)
      if (different.insert(value); different.size() >= many) return true;
  return false;
}

/// Returns the rounding of points in a text whose numbers may have so many digits.
Rounding rounding_to(int digits_of_text, const std::vector<const TableColumn*>& coordinates) {
  Rounding rounding;
  int decimals = common_decimals(coordinates), shown = 0;
  for (const TableColumn* column : coordinates) shown = std::max(shown, column->digits);
  // On a lattice coordinates need few digits; but where one is padded with zeros, the decimals are fixed.
  const bool is_padded = std::ranges::any_of(coordinates, [](const TableColumn* column) { return column->is_padded; });
  if (digits_of_text > shown + 2) {
    if (!is_padded) decimals = -1;
    if (is_padded || are_many(coordinates)) digits_of_text = shown;
  }
  for (const TableColumn* column : coordinates) {
    const int digits = column->bits == 24   ? 7
                       : column->bits == 53 ? 16
                       : decimals >= 0      ? column->digits
                                            : digits_of_text;
    rounding.digits = std::min(rounding.digits, digits);
    double squares = 0;
    for (const double value : column->values)
      if (std::isfinite(value)) squares += std::pow(unit_of(value, digits_of_text, decimals, column->bits), 2);
    rounding.unit = std::hypot(rounding.unit, std::sqrt(squares / static_cast<double>(column->values.size())));
  }
  return rounding;
}

}  // namespace

Rounding rounding_of(const ParticleTable& table, const std::vector<const TableColumn*>& coordinates) {
  int digits = 1;
  for (const TableColumn& column : table.columns) digits = std::max(digits, column.digits);
  return rounding_to(digits, coordinates);
}

double unit_shown_by(const std::vector<const TableColumn*>& coordinates) {
  int digits = 1;
  for (const TableColumn* column : coordinates) digits = std::max(digits, column->digits);
  return rounding_to(digits, coordinates).unit;
}

double rounding_error(double unit) {
  return unit / std::sqrt(12.0);
}

}  // namespace mpmvv::codes
