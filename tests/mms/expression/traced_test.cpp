#include "mms/expression/traced.hpp"

#include <gtest/gtest.h>

#include <set>

#include "mms/derived.hpp"
#include "tests/mms/expression/formula_samples.hpp"

namespace mpmvv::mms::expression::traced_test {

const Traced x = Variable::x, y = Variable::y, t = Variable::t;

std::string in_python(const Traced& e) {
  return text(e, dialect("python"));
}

TEST(Traced, FoldsConstantsAndDropsWhatDoesNothing) {
  EXPECT_EQ(in_python(0 * x + 1 * y), "y");
  EXPECT_EQ(in_python(2 * x * 3 + (1 + 2)), "3 + 6*x");
  EXPECT_EQ(in_python(x * x * x / 2), "x**3/2");
  EXPECT_EQ(in_python(sin(x) * sin(y) * sin(y)), "sin(x)*sin(y)**2");
  EXPECT_EQ(in_python(2 * x / (4 * y)), "0.5*x/y");
  EXPECT_EQ(in_python(x - (x - 30 * t)), "30*t");
  EXPECT_EQ(in_python(x / (1 / y)), "x*y");
  EXPECT_EQ(in_python((y + x) - y), "x");
  EXPECT_EQ(in_python(cos(Traced(std::acos(-1.0) / 2))), "0");
  EXPECT_EQ(in_python(pow(x, 3.0) * pow(x, -2)), "x**3*1/x**2");
}

TEST(Traced, WritesSignsAndParentheses) {
  EXPECT_EQ(in_python(-x + y), "y - x");
  EXPECT_EQ(in_python(-x * y - 2), "-x*y - 2");
  EXPECT_EQ(in_python(3 - (x - 2)), "3 - (x - 2)");
  EXPECT_EQ(in_python((x + y) * (x - y) / (x * y)), "(x + y)*(x - y)/(x*y)");
  EXPECT_EQ(in_python(sin(-x)), "sin(-x)");
  EXPECT_EQ(in_python(pow(x + y, 2)), "(x + y)**2");
  EXPECT_EQ(in_python(-1 / x), "-1/x");
}

TEST(Traced, DerivesEveryOperation) {
  EXPECT_EQ(in_python(derivative(x * y, Variable::x)), "y");
  EXPECT_EQ(in_python(derivative(sin(2 * x), Variable::x)), "2*cos(2*x)");
  EXPECT_EQ(in_python(derivative(cos(x), Variable::x)), "-sin(x)");
  EXPECT_EQ(in_python(derivative(exp(x) + log(y), Variable::x)), "exp(x)");
  EXPECT_EQ(in_python(derivative(log(y), Variable::y)), "1/y");
  EXPECT_EQ(in_python(derivative(pow(x, 3), Variable::x)), "3*x**2");
  const auto slope_at_2 = [](const Traced& of_x) {
    return substitute(derivative(of_x, Variable::x), Variable::x, 2).number();
  };
  EXPECT_NEAR(slope_at_2(sqrt(x) / x), -0.5 * std::pow(2, -1.5), 1e-15);
  EXPECT_NEAR(slope_at_2(tan(x)), 1 / std::pow(std::cos(2), 2), 1e-14);
  EXPECT_EQ(slope_at_2(abs(1 - x)), 1);
}

/// With every variable replaced by its value an expression folds to a number.
double value_at(Traced formula, const PlaceAndTime& place) {
  for (std::size_t k = 0; k < place.size(); ++k) formula = substitute(formula, static_cast<Variable>(k), place[k]);
  return formula.number();
}

TEST(Formulas, AreThoseOfEverySolution) {
  std::set<std::string> of_reference, in_place;
  for (const FormulaSample& sample : formula_samples()) {
    for (std::size_t k = 0; k < sample.places.size(); ++k)
      ASSERT_NEAR(value_at(sample.formula, sample.places[k]), sample.expected[k], 1e-13 * sample.scale())
          << sample.what;
    const std::size_t name = sample.what.find(" of ") + 4;
    (sample.is_of_reference ? of_reference : in_place).insert(sample.what.substr(name, sample.what.find(',') - name));
  }
  std::set<std::string> all;
  for (const Entry& entry : catalogue()) all.emplace(entry.name);
  for (const char* without : {"pulse", "square-inverse"}) all.erase(without);
  EXPECT_EQ(of_reference, all);
  EXPECT_EQ(in_place,
            (std::set<std::string>{"square-inverse", "stretch", "stretch-1d", "stretch-3d", "translation", "vortex"}));
}

TEST(Formulas, AreShortEnoughToBeEvaluatedByTheStep) {
  const auto b = [](const char* name) {
    const auto solution = make<2>(name, complete(entry_named(name), {}));
    return in_python(solution->formulas().reference->b[0]).size();
  };
  EXPECT_LT(b("square-rest"), 700U);
  EXPECT_LT(b("ring"), 900U);
}

/// Of a displacement alone: all else is derived, and held against automatic differentiation.
TEST(Formulas, AreDerivedFromADisplacement) {
  const auto sheared = derived<2>(
      [](const auto& X, const auto& time) {
        using std::sin;
        return std::array{0.1 * X[1] * X[1] * sin(time), 0.05 * sin(X[0]) * time};
      },
      Elasticity{1e4, 0.3, 2}, 0.1);
  const auto formulas = sheared.formulas().reference;
  ASSERT_TRUE(formulas);
  const Vec<2> X(0.3, 0.7), b = sheared.b(X, 0.4), v = sheared.v(X, 0.4);
  for (std::size_t d = 0; d < 2; ++d) {
    const PlaceAndTime place{0.3, 0.7, 0, 0, 0, 0, 0.4};
    EXPECT_NEAR(value_at(formulas->b[d], place), b.data()[d], 1e-13 * b.norm());
    EXPECT_NEAR(value_at(formulas->v[d], place), v.data()[d], 1e-15);
  }
}

TEST(Formulas, AreMissingWhereTheDisplacementBranches) {
  const auto stepped = derived<2>(
      [](const auto& X, const auto& time) {
        if (X[0] > 0.5) return std::array{0.1 * time, 0.0 * time};
        return std::array{0.2 * time, 0.0 * time};
      },
      Elasticity{1e4, 0.3, 1}, 0.1);
  EXPECT_FALSE(stepped.formulas().reference);
}

}  // namespace mpmvv::mms::expression::traced_test
