#include "mms/expression/dialect.hpp"

namespace mpmvv::mms::expression {

namespace {

/// Writes a constant in double precision: 2d0, 1.5d-3.
std::string in_double_precision(double value) {
  std::string digits = shortest(value);
  const auto exponent = digits.find('e');
  if (exponent == std::string::npos) return digits + "d0";
  digits[exponent] = 'd';
  return digits;
}

}  // namespace

Dialect fortran_dialect() {
  return {
      .name = "fortran",
      .what = "Fortran in double precision; lines may be longer than 132 columns (gfortran -ffree-line-length-none)",
      .number = in_double_precision,
      .power = two_stars_power};
}

}  // namespace mpmvv::mms::expression
