#include "studies/codes/solution_points.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"
#include "tests/studies/codes/csv_parts.hpp"

namespace mpmvv::codes::solution_points_test {

using testing::HasSubstr;

constexpr double pi = std::numbers::pi;

std::string csv(const std::string& problem, const std::string& points, const PointQuery& query) {
  const std::vector<settings::Setting> settings{{"problem", problem, ""}};
  const PointQuery whole{{points, "points.csv"}, query.time, query.normal, query.fields};
  std::string text;
  solution_at(settings::make_choice(settings), whole, [&](const std::string& part) { text += part; });
  return text;
}

PointQuery with_fields(std::vector<std::string> fields) {
  static const std::string none;
  return {.points = {none, ""}, .normal = {}, .fields = std::move(fields)};
}

std::string refusal(const std::string& points, const PointQuery& query = with_fields({})) {
  try {
    csv("square", points, query);
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "";
}

TEST(SolutionAtPoints, TakesPlacesAndTimesAndLeavesOtherColumnsAlone) {
  const auto lines = lines_of(csv("square", "id,Y,X,t\n7,0.7,0.2,0.001\n8,0.5,0.5,0\n", with_fields({"u", "F"})));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], "X,Y,t,u_x,u_y,F_xx,F_xy,F_yx,F_yy");
  const auto first = numbers(lines[1]);
  EXPECT_EQ(std::vector(first.begin(), first.begin() + 3), (std::vector{0.2, 0.7, 0.001}));
  EXPECT_NEAR(first[3], 0.1 * std::sin(0.2 * pi) * std::cos(0.1 * pi), 1e-16);
  EXPECT_NEAR(first[5], 1 + 0.1 * pi * std::cos(0.2 * pi) * std::cos(0.1 * pi), 1e-15);
  EXPECT_NEAR(numbers(lines[2])[3], 0.1, 1e-16);
}

TEST(SolutionAtPoints, GivesEveryFieldWhereNoneIsNamed) {
  PointQuery query = with_fields({});
  query.time = 0.001;
  EXPECT_EQ(lines_of(csv("bar", "X\n0.2\n", query))[0], "X,t,u_x,v_x,a_x,b_x,F_xx,P_xx");
  EXPECT_THAT(lines_of(csv("cube-rest", "X,Y,Z\n0.2,0.3,0.4\n", query))[0],
              HasSubstr("F_xx,F_xy,F_xz,F_yx,F_yy,F_yz,F_zx,F_zy,F_zz,P_xx"));
}

/// P N on a surface: half of the way through its pulse the end at X = 0 is pulled at 500 Pa.
TEST(SolutionAtPoints, GivesTractionsOnALoadedSurface) {
  const auto lines = lines_of(csv("pulse", "X,Y,t,NX,NY\n0,0,0.0005,-2,0\n", with_fields({"P", "traction"})));
  const auto row = numbers(lines[1]);
  EXPECT_EQ(lines[0], "X,Y,t,P_xx,P_xy,P_yx,P_yy,traction_x,traction_y");
  EXPECT_NEAR(row[3], 500, 1e-9);
  EXPECT_NEAR(row[7], -500, 1e-9);
  PointQuery query = with_fields({"traction"});
  query.normal = std::vector<double>{-1, 0};
  EXPECT_NEAR(numbers(lines_of(csv("pulse", "X,Y,t\n0,0,0.0005\n", query))[1])[3], -500, 1e-9);
}

/// Whatever its length: squares of these components are beyond the range of doubles.
TEST(SolutionAtPoints, TakesOfANormalItsDirection) {
  for (const auto& [N, traction] :
       {std::pair{"-1e200,0", -500.0}, {"-1e-200,0", -500.0}, {"-1.7e308,-1.7e308", -500 / std::numbers::sqrt2}}) {
    const std::string points = fmt::format("X,Y,t,NX,NY\n0,0,0.0005,{}\n", N);
    EXPECT_NEAR(numbers(lines_of(csv("pulse", points, with_fields({"traction"})))[1])[3], traction, 1e-9) << N;
  }
}

TEST(SolutionAtPoints, SaysWhichLineIsBad) {
  EXPECT_THAT(refusal("X,Y,t\n0.1,0.2,0\n\n0.1,abc,0\n"), HasSubstr("'abc' for 'Y' in points.csv:4"));
  EXPECT_THAT(refusal("X,Y,t\n0.1,0.2,0\n# a comment\n1.1,0.2,0\n"),
              HasSubstr("X = 1.1,0.2 in points.csv:4 is outside the body"));
  EXPECT_THAT(refusal("X,Y,t\n0.1,0.2\n"), HasSubstr("points.csv:2"));
  EXPECT_THAT(refusal("X,Y,t,NX,NY\n0.1,0.2,0,0,0\n"), HasSubstr("the normal for points.csv:2 has no direction"));
  EXPECT_THAT(refusal("X,Y,t\n0.1,0.2,1e308\n"), HasSubstr("points.csv:2"));
}

TEST(SolutionAtPoints, SaysWhatIsMissingOrTooMuch) {
  EXPECT_THAT(refusal("X,t\n0.1,0\n"), HasSubstr("no column 'Y' in points.csv (it has: X, t)"));
  EXPECT_THAT(refusal("X,Y,X,t\n0.1,0,0.2,0\n"), HasSubstr("2 columns 'X' in points.csv (one)"));
  EXPECT_EQ(refusal("X,Y,note,note,t\n0.1,0,1,2,0\n"), "");
  EXPECT_THAT(refusal("X,Y\n0.1,0\n"), HasSubstr("no time"));
  EXPECT_THAT(refusal("X,Y,t\n0.1,0,0\n", with_fields({"traction"})), HasSubstr("traction without a normal"));
  PointQuery timed = with_fields({});
  timed.time = 1;
  EXPECT_THAT(refusal("X,Y,t\n0.1,0,0\n", timed), HasSubstr("one of them"));
}

}  // namespace mpmvv::codes::solution_points_test
