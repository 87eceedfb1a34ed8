#include <string>

#include "mms/expression/dialect.hpp"

namespace mpmvv::mms::expression {

namespace {

/// How tightly a text binds: as its loosest operator does.
enum class Binding { sum, product, power, word };

struct Written {
  std::string text;
  Binding binding;

  /// Returns the text, in parentheses where it binds less tightly than needed.
  std::string binding_at_least(Binding needed) const { return binding < needed ? '(' + text + ')' : text; }
};

class Writer {
 public:
  explicit Writer(const Dialect& dialect) : dialect_(dialect) {}

  Written written(const Traced& e) const {
    switch (e.operation()) {
      case Operation::number:
        if (e.number() < 0) return {dialect_.negative(dialect_.number(-e.number())), Binding::sum};
        return {dialect_.number(e.number()), Binding::word};
      case Operation::variable:
        return {known(dialect_.variable(e.variable()), plain_variable(e.variable())), Binding::word};
      case Operation::add:
        return {in(e.operand(), Binding::sum) + " + " + in(e.right(), Binding::sum), Binding::sum};
      case Operation::subtract:
        return {in(e.operand(), Binding::sum) + " - " + in(e.right(), Binding::product), Binding::sum};
      case Operation::multiply:
        return product(e);
      case Operation::divide:
        return {in(e.operand(), Binding::product) + '/' + in(e.right(), Binding::power), Binding::product};
      case Operation::power:
        return {dialect_.power(in(e.operand(), Binding::word), static_cast<int>(e.number())), Binding::power};
      default:
        return {known(dialect_.function(e.operation()), plain_function(e.operation())) + '(' +
                    in(e.operand(), Binding::sum) + ')',
                Binding::word};
    }
  }

 private:
  std::string in(const Traced& e, Binding needed) const { return written(e).binding_at_least(needed); }

  Written product(const Traced& e) const {
    const Traced& left = e.operand();
    if (left.is_number() && left.number() < 0) return {dialect_.negative(in(-1.0 * e, Binding::product)), Binding::sum};
    return {in(left, Binding::product) + '*' + in(e.right(), Binding::product), Binding::product};
  }

  std::string known(std::string_view own, std::string_view meant) const {
    if (own.empty()) throw NotWritable(std::string(dialect_.name) + " has no '" + std::string(meant) + "'");
    return std::string(own);
  }

  const Dialect& dialect_;
};

}  // namespace

std::string text(const Traced& expression, const Dialect& dialect) {
  return Writer(dialect).written(expression).text;
}

}  // namespace mpmvv::mms::expression
