#include "mms/expression/dialect.hpp"

namespace mpmvv::mms::expression {

namespace {

/// Functions in nairn-mpm-fea's input know only the current position and the time.
std::string_view current_variable(Variable variable) {
  return variable < Variable::x ? "" : plain_variable(variable);
}

}  // namespace

/// In this input a sign may stand only at the start of an expression or group, and is applied after powers. All that
/// `minus` and `text` write obeys this.
Dialect nairn_dialect() {
  return {.name = "nairn",
          .what = "functions in the input of nairn-mpm-fea, of the current x, y, z and t, in the units of its input",
          .variable = current_variable};
}

}  // namespace mpmvv::mms::expression
