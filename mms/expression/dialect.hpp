#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mms/expression/traced.hpp"

namespace mpmvv::mms::expression {

// What several dialects share.
std::string shortest(double number);  ///< as many digits as tell it from all others
std::string_view plain_variable(Variable variable);
std::string_view plain_function(Operation function);
std::string caret_power(const std::string& base, int exponent);
std::string two_stars_power(const std::string& base, int exponent);
std::string minus(const std::string& term);

/// How a language, or the input of a code, writes an expression: what it does not say itself, in the plain way.
struct Dialect {
  std::string_view name;
  std::string_view what;                                        ///< one line for people
  std::string (*number)(double) = shortest;                     ///< of one that is not negative
  std::string_view (*variable)(Variable) = plain_variable;      ///< empty where it has none
  std::string (*power)(const std::string&, int) = caret_power;  ///< of a base that is one word or in parentheses
  std::string_view (*function)(Operation) = plain_function;     ///< empty where it has none
  std::string (*negative)(const std::string& term) = minus;     ///< of a product
};

/// The one place where they are named: add a line for a new one.
const std::vector<Dialect>& dialects();

/// The dialect cannot write that.
struct NotWritable : std::domain_error {
  using std::domain_error::domain_error;
};

/// On one line. Throws NotWritable.
std::string text(const Traced& expression, const Dialect& dialect);

// The dialects, each in its own file.
Dialect c_dialect();
Dialect fortran_dialect();
Dialect python_dialect();
Dialect muparser_dialect();
Dialect nairn_dialect();
Dialect karamelo_dialect();

}  // namespace mpmvv::mms::expression
