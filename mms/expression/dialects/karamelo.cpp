#include <array>
#include <charconv>

#include "mms/expression/dialect.hpp"

namespace mpmvv::mms::expression {

namespace {

/// Karamelo keeps constants as texts with 15 decimals and reads them in single precision, so they must not be too small
/// or too large.
std::string with_decimals(double value) {
  constexpr double least = 1e-6, most = 1e12;
  if (value != 0 && (value < least || value > most))
    throw NotWritable("karamelo reads no constant below 1e-6 or above 1e12, and this has " + shortest(value));
  std::array<char, 64> digits;
  return {digits.data(),
          std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr};
}

/// At Karamelo's nodes only x0, y0 and z0 are set. In an updated Lagrangian grid they are the current position.
std::string_view initial_variable(Variable variable) {
  constexpr std::array<std::string_view, 7> names{"x0", "y0", "z0", "x0", "y0", "z0", "time"};
  return names[static_cast<std::size_t>(variable)];
}

std::string_view function_it_has(Operation operation) {
  return operation == Operation::abs ? "" : plain_function(operation);
}

/// Karamelo would apply a sign before a function to a later number, too.
std::string from_zero(const std::string& term) {
  return "0 - " + term;
}

}  // namespace

Dialect karamelo_dialect() {
  return {.name = "karamelo",
          .what = "formulas in the input of Karamelo, of x0, y0, z0 and time; it keeps seven digits of constants",
          .number = with_decimals,
          .variable = initial_variable,
          .function = function_it_has,
          .negative = from_zero};
}

}  // namespace mpmvv::mms::expression
