#include "mms/expression/dialect.hpp"

namespace mpmvv::mms::expression {

Dialect python_dialect() {
  return {.name = "python",
          .what = "Python, after `from math import *` or, for arrays, `from numpy import *`",
          .power = two_stars_power};
}

}  // namespace mpmvv::mms::expression
