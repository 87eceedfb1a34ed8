#include "mms/expression/dialect.hpp"

namespace mpmvv::mms::expression {

namespace {

/// In some versions of muParser log has the base ten, so the natural logarithm is written as ln.
std::string_view function_with_ln(Operation operation) {
  return operation == Operation::log ? "ln" : plain_function(operation);
}

}  // namespace

Dialect muparser_dialect() {
  return {
      .name = "muparser", .what = "the muParser library, and with it deal.II and others", .function = function_with_ln};
}

}  // namespace mpmvv::mms::expression
