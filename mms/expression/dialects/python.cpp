#include "mms/expression/dialect.hpp"

namespace mpmvv::mms::expression {

Dialect python_dialect() {
  return {.name = "python",
          .what = "Python, after `from math import *` or, for arrays, `from numpy import *`",
          .number = shortest,
          .variable = plain_variable,
          .power = two_stars_power,
          .function = plain_function,
          .negative = minus};
}

}  // namespace mpmvv::mms::expression
