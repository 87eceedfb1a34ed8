#include "mms/expression/dialect.hpp"

namespace mpmvv::mms::expression {

namespace {

/// Its functions know the current position and time alone.
std::string_view current_variable(Variable variable) {
  return variable < Variable::x ? "" : plain_variable(variable);
}

}  // namespace

/// A sign may stand at the start of an expression or group alone, and is applied after powers: what `minus` and `text`
/// make is that anyway.
Dialect nairn_dialect() {
  return {.name = "nairn",
          .what = "functions in the input of nairn-mpm-fea, of the current x, y, z and t, in the units of its input",
          .variable = current_variable};
}

}  // namespace mpmvv::mms::expression
