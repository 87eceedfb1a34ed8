#include "studies/codes/expressions.hpp"

#include <gmock/gmock.h>

#include "studies/runs/prepared_case.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"
#include "tests/mms/expression/evaluator.hpp"

namespace mpmvv::codes::expressions_test {

using cases::ForceForm;
using testing::ElementsAre;
using testing::HasSubstr;

cases::ProblemChoice choice_of(const std::string& problem) {
  const std::vector<settings::Setting> settings{{"problem", problem, ""}};
  return settings::make_choice(settings);
}

Expressions of(const std::string& problem, ForceForm form, const std::string& dialect = "python") {
  return expressions(choice_of(problem), form, dialect_named(dialect, "the test"));
}

std::string refusal(const std::string& problem, ForceForm form, const std::string& dialect = "python") {
  try {
    of(problem, form, dialect);
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "";
}

TEST(Expressions, StartFromRestWhereTheProblemDoes) {
  const Expressions all = of("square-rest", ForceForm::reference);
  EXPECT_THAT(all.v0, ElementsAre("0", "0"));
  EXPECT_THAT(all.F0, ElementsAre(ElementsAre("1", "0"), ElementsAre("0", "1")));
  EXPECT_EQ(all.u[1], "0.02*sin(3.141592653589793*Y)*(0.5 + 0.5*sin(314.1592653589793*t - 1.5707963267948966))");
  ASSERT_EQ(all.b.size(), 2U);
  EXPECT_THAT(all.b[0], HasSubstr("log("));
}

TEST(Expressions, StartInMotionWhereTheProblemDoes) {
  const Expressions all = of("square", ForceForm::reference);
  EXPECT_THAT(all.v0, ElementsAre("0", "31.415926535897935*sin(3.141592653589793*Y)"));
  EXPECT_EQ(all.F0[0][0], "1 + 0.3141592653589793*cos(3.141592653589793*X)");
}

TEST(Expressions, AreOfTheCurrentPositionInTheInverseForm) {
  const Expressions all = of("square-inverse", ForceForm::inverse, "nairn");
  EXPECT_THAT(all.b[0], HasSubstr("sin(3.141592653589793*x)"));
  EXPECT_THAT(all.v0, ElementsAre("0", "0"));
  EXPECT_THAT(of("translation", ForceForm::inverse).b, ElementsAre("0", "0"));
  EXPECT_THAT(of("wave", ForceForm::inverse).b, ElementsAre("0", "0"));
}

TEST(Expressions, AreRefusedInFormsThatTheProblemHasNot) {
  EXPECT_EQ(refusal("square", ForceForm::current),
            "form 'current' of problem 'square': its body force depends on the position (problems with form 'current': "
            "stretch, stretch-1d, stretch-3d, wave, translation)");
  EXPECT_THAT(refusal("square", ForceForm::inverse),
              HasSubstr("X(x, t) has no closed form (problems with form 'inverse': vortex, stretch, "));
  EXPECT_THAT(refusal("square-inverse", ForceForm::reference),
              HasSubstr("x(X, t) has no closed form (form 'inverse'; problems with form 'reference': bar, "));
  EXPECT_THAT(refusal("impact", ForceForm::reference),
              HasSubstr("'impact' has no solution in formulas (problems with form 'reference': bar, "));
  EXPECT_THAT(refusal("square", ForceForm::reference, "nairn"), HasSubstr("nairn has no 'X'"));
  EXPECT_TRUE(of("square", ForceForm::per_particle, "nairn").b.empty());
  EXPECT_THROW(dialect_named("cobol", "--dialect"), support::UsageError);
}

TEST(Expressions, PlantMistakes) {
  const std::string right = of("square-rest", ForceForm::reference).b[0];
  std::string misplaced = of("square-rest", ForceForm::misplaced).b[0];
  EXPECT_EQ(misplaced.find_first_of("XY"), std::string::npos);
  for (char& c : misplaced) c = c == 'x' ? 'X' : c == 'y' ? 'Y' : c;
  EXPECT_EQ(misplaced, right);
  EXPECT_THAT(of("square", ForceForm::none).b, ElementsAre("0", "0"));
}

/// A standing wave starts undeformed: what codes know is the current position, which is the reference position then.
TEST(Expressions, StartInTheCoordinatesThatACodeHas) {
  EXPECT_EQ(of("wave", ForceForm::current, "nairn").v0[0], "0.36449973833383426*sin(3.141592653589793*x)");
  EXPECT_TRUE(of("wave", ForceForm::current, "nairn").u.empty());
}

/// Of time alone: what the solution gives at the particle.
TEST(Expressions, GiveEachParticleItsForce) {
  const std::vector<settings::Setting> settings{
      {"problem", "ring", ""}, {"cells", "4", ""}, {"ppc", "1", ""}, {"cfl", "0.4", ""}};
  const cases::Case c = settings::make_case(settings);
  const auto forces = particle_forces(c, dialect_named("nairn", ""));
  const auto prepared = runs::prepare_case<2>(c, problems::find_problem("ring", ""), 1);
  ASSERT_EQ(forces.size(), prepared.X.size());
  mms::Grammar grammar{{{"t", 0}}, {}, [](const std::string& digits) { return std::stod(digits); }, true, true};
  grammar.functions = {{"sin", [](double a) { return std::sin(a); }}, {"cos", [](double a) { return std::cos(a); }}};
  const double t = 0.0037;
  for (std::size_t p = 0; p < forces.size(); ++p) {
    const auto b = prepared.setup.solution->b(prepared.X[p], t);
    for (std::size_t d = 0; d < 2; ++d)
      EXPECT_NEAR(mms::Evaluator(grammar, forces[p][d], std::array{t}).value(), b.data()[d], 1e-10);
  }
}

}  // namespace mpmvv::codes::expressions_test
