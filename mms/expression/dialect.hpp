#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mms/expression/traced.hpp"

namespace mpmvv::mms::expression {

// Ways of writing that several dialects share.
std::string shortest(double number);  ///< with the fewest digits that read back as the same number
std::string_view plain_variable(Variable variable);
std::string_view plain_function(Operation function);
std::string caret_power(const std::string& base, int exponent);
std::string two_stars_power(const std::string& base, int exponent);
std::string minus(const std::string& term);

/// How a language, or the input of a code, writes expressions. What a dialect does not set is written in the plain way.
struct Dialect {
  std::string_view name;
  std::string_view what;                                        ///< a description of one line, for people
  std::string (*number)(double) = shortest;                     ///< writes a number that is not negative
  std::string_view (*variable)(Variable) = plain_variable;      ///< its name; empty: the dialect has none
  std::string (*power)(const std::string&, int) = caret_power;  ///< writes a power; base: a word or in parentheses
  std::string_view (*function)(Operation) = plain_function;     ///< its name; empty: the dialect has none
  std::string (*negative)(const std::string& term) = minus;     ///< -term, for a number or a product
};

/// All dialects. This is the one place where they are listed: add a line for a new one.
const std::vector<Dialect>& dialects();

/// Thrown where a dialect cannot write an expression.
struct NotWritable : std::domain_error {
  using std::domain_error::domain_error;
};

/// Writes the expression on one line. Throws NotWritable.
std::string text(const Traced& expression, const Dialect& dialect);

// The dialects, each in its own file.
Dialect c_dialect();
Dialect fortran_dialect();
Dialect python_dialect();
Dialect muparser_dialect();
Dialect nairn_dialect();
Dialect karamelo_dialect();

}  // namespace mpmvv::mms::expression
