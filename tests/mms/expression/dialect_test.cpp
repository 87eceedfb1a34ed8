#include "mms/expression/dialect.hpp"

#include <gtest/gtest.h>

#include "tests/mms/expression/evaluator.hpp"
#include "tests/mms/expression/formula_samples.hpp"

namespace mpmvv::mms::expression::dialect_test {

const std::map<std::string, std::function<double(double)>> functions{
    {"sin", [](double a) { return std::sin(a); }}, {"cos", [](double a) { return std::cos(a); }},
    {"tan", [](double a) { return std::tan(a); }}, {"exp", [](double a) { return std::exp(a); }},
    {"log", [](double a) { return std::log(a); }}, {"sqrt", [](double a) { return std::sqrt(a); }},
    {"abs", [](double a) { return std::abs(a); }}};

double in_double_precision(const std::string& digits) {
  return std::stod(digits);
}
double in_single_precision(const std::string& digits) {
  return std::stof(digits);
}

/// Expression.hpp of nairn-mpm-fea.
Grammar nairn() {
  return {{{"x", 3}, {"y", 4}, {"z", 5}, {"t", 6}}, functions, in_double_precision, true, true};
}

/// muParser's manual: ln is the natural logarithm.
Grammar muparser() {
  Grammar grammar{{{"X", 0}, {"Y", 1}, {"Z", 2}, {"x", 3}, {"y", 4}, {"z", 5}, {"t", 6}},
                  functions,
                  in_double_precision,
                  true,
                  true};
  grammar.functions["ln"] = grammar.functions.at("log");
  grammar.functions.erase("log");
  return grammar;
}

/// Input::parsev of Karamelo: numbers go through std::stof.
Grammar karamelo(bool is_of_reference) {
  const std::size_t first = is_of_reference ? 0 : 3;
  Grammar grammar{
      {{"x0", first}, {"y0", first + 1}, {"z0", first + 2}, {"time", 6}}, functions, in_single_precision, false, false};
  grammar.functions.erase("abs");
  return grammar;
}

/// How far the text is from the solution at most, by the largest value of the solution.
double error(const FormulaSample& sample, const std::string& name, const Grammar& grammar) {
  const std::string written = text(sample.formula, dialect(name));
  double largest = 0;
  for (std::size_t k = 0; k < sample.places.size(); ++k)
    largest = std::max(largest, std::abs(Evaluator(grammar, written, sample.places[k]).value() - sample.expected[k]));
  return largest / sample.scale();
}

TEST(Dialect, MuParserGivesEverySolution) {
  const Grammar grammar = muparser();
  for (const FormulaSample& sample : formula_samples())
    EXPECT_LT(error(sample, "muparser", grammar), 1e-13) << sample.what;
}

TEST(Dialect, NairnGivesWhatIsAnExpressionOfTheCurrentPosition) {
  const Grammar grammar = nairn();
  for (const FormulaSample& sample : formula_samples()) {
    if (sample.is_of_reference) continue;
    EXPECT_LT(error(sample, "nairn", grammar), 1e-13) << sample.what;
  }
  EXPECT_THROW(text(sin(Traced(Variable::X)), dialect("nairn")), NotWritable);
}

/// Its constants have seven digits.
TEST(Dialect, KarameloGivesEverySolutionInSinglePrecision) {
  for (const FormulaSample& sample : formula_samples())
    EXPECT_LT(error(sample, "karamelo", karamelo(sample.is_of_reference)), 3e-6) << sample.what;
}

TEST(Dialect, KarameloRefusesWhatItCannotRead) {
  const Traced x = Variable::X;
  EXPECT_EQ(text(-sin(x) * 3, dialect("karamelo")), "0 - 3*sin(x0)");
  EXPECT_EQ(text(x + 1e-5, dialect("karamelo")), "0.00001 + x0");
  EXPECT_THROW(text(x + 1e-9, dialect("karamelo")), NotWritable);
  EXPECT_THROW(text(x + 1e13, dialect("karamelo")), NotWritable);
  EXPECT_THROW(text(abs(x), dialect("karamelo")), NotWritable);
}

TEST(Dialect, WritesNumbersAsTheLanguageHasThem) {
  const Traced x = Variable::x;
  const Traced e = 2 * pow(x + 1e-5, 3) / abs(x);
  EXPECT_EQ(text(e, dialect("c")), "2.0*pow(1e-05 + x, 3)/fabs(x)");
  EXPECT_EQ(text(e, dialect("fortran")), "2d0*(1d-05 + x)**3/abs(x)");
  EXPECT_EQ(text(e, dialect("python")), "2*(1e-05 + x)**3/abs(x)");
  EXPECT_EQ(text(log(x), dialect("muparser")), "ln(x)");
  EXPECT_EQ(text(log(x), dialect("nairn")), "log(x)");
}

}  // namespace mpmvv::mms::expression::dialect_test
