#include "mms/expression/dialect.hpp"

namespace mpmvv::mms::expression {

namespace {

std::string number(double value) {
  const std::string digits = shortest(value);
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

std::string power(const std::string& base, int exponent) {
  const bool is_word = base.front() != '(';
  return "pow(" + (is_word ? base : base.substr(1, base.size() - 2)) + ", " + std::to_string(exponent) + ")";
}

std::string_view function(Operation operation) {
  return operation == Operation::abs ? "fabs" : plain_function(operation);
}

}  // namespace

Dialect c_dialect() {
  return {.name = "c",
          .what = "C and C++, with math.h; X, Y, Z, x, y, z and t are doubles",
          .number = number,
          .power = power,
          .function = function};
}

}  // namespace mpmvv::mms::expression
