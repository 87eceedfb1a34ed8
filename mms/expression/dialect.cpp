#include "mms/expression/dialect.hpp"

#include <array>
#include <charconv>

namespace mpmvv::mms::expression {

const std::vector<Dialect>& dialects() {
  static const std::vector<Dialect> all{
      c_dialect(),         //
      fortran_dialect(),   //
      python_dialect(),    //
      muparser_dialect(),  //
      nairn_dialect(),     //
      karamelo_dialect(),  //
  };
  return all;
}

std::string shortest(double number) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

std::string_view plain_variable(Variable variable) {
  constexpr std::string_view names = "XYZxyzt";
  return names.substr(static_cast<std::size_t>(variable), 1);
}

std::string_view plain_function(Operation function) {
  switch (function) {
    case Operation::sin:
      return "sin";
    case Operation::cos:
      return "cos";
    case Operation::tan:
      return "tan";
    case Operation::exp:
      return "exp";
    case Operation::log:
      return "log";
    case Operation::sqrt:
      return "sqrt";
    case Operation::abs:
      return "abs";
    default:
      return "";
  }
}

std::string caret_power(const std::string& base, int exponent) {
  return base + '^' + std::to_string(exponent);
}
std::string two_stars_power(const std::string& base, int exponent) {
  return base + "**" + std::to_string(exponent);
}
std::string minus(const std::string& term) {
  return '-' + term;
}

}  // namespace mpmvv::mms::expression
