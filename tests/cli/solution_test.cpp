#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv::cli::solution_test {

TEST(SolutionCommand, GivesTheFieldsOfTheBar) {
  const Folder folder;
  const auto s = call(folder, "solution --problem bar --at 0.2 --time 0.001 --json").json();
  const double pi = std::acos(-1.0), u = 0.05 * std::sin(0.4 * pi) * std::cos(0.1 * pi);
  const double F = 1 + 0.1 * pi * std::cos(0.4 * pi) * std::cos(0.1 * pi);
  EXPECT_NEAR(s["u"][0], u, 1e-15);
  EXPECT_NEAR(s["F"][0][0], F, 1e-15);
  EXPECT_NEAR(s["P"][0][0], 5000 * (F - 1 / F), 1e-10);
  EXPECT_NEAR(s["b"][0], 1e4 * pi * pi * u * (2 / (F * F) + 1), 1e-9);
}

/// W (56) to (59) and S (51) to (53) as printed.
TEST(SolutionCommand, GivesTheFieldsOfSquareAndCube) {
  const Folder folder;
  const double pi = std::acos(-1.0), E = 1e4, lambda = E * 0.3 / (1.3 * 0.4), mu = E / 2.6;
  const auto square = call(folder, "solution --problem square --at 0.2,0.7 --time 0.001 --json").json();
  {
    const double u = 0.1 * std::sin(0.2 * pi) * std::cos(0.1 * pi);
    const double F = 1 + 0.1 * pi * std::cos(0.2 * pi) * std::cos(0.1 * pi);
    const double K = std::log(F * (1 + 0.1 * pi * std::cos(0.7 * pi) * std::sin(0.1 * pi)));
    EXPECT_NEAR(square["u"][0], u, 1e-15);
    EXPECT_NEAR(square["F"][0][0], F, 1e-15);
    EXPECT_NEAR(square["P"][0][0], lambda / F * K + mu / F * (F * F - 1), 1e-10);
    EXPECT_NEAR(square["b"][0], pi * pi * u * (lambda / (F * F) * (1 - K) + mu * (1 + 1 / (F * F)) - E), 1e-9);
  }
  const auto cube = call(folder, "solution --problem cube --at 0.2,0.7,0.4 --time 0.001 --json").json();
  {
    const double phase = 2 * pi / 3, u = 0.05 * std::sin(1.4 * pi) * std::sin(phase + 0.1 * pi);
    const auto F_at = [&](double x, double shift) {
      return 1 + 0.1 * pi * std::cos(2 * pi * x) * std::sin(shift + 0.1 * pi);
    };
    const double F = F_at(0.7, phase), K = std::log(F_at(0.2, 0) * F * F_at(0.4, 2 * phase));
    EXPECT_NEAR(cube["u"][1], u, 1e-15);
    EXPECT_NEAR(cube["F"][1][1], F, 1e-15);
    EXPECT_NEAR(cube["b"][1], pi * pi * u * (4 * mu - E - 4 * (lambda * (K - 1) - mu) / (F * F)), 1e-9);
  }
}

TEST(SolutionCommand, TakesManyPointsFromAFileOrStandardInput) {
  const Folder folder;
  const std::string points = folder.write("points.csv", "X,Y,t\n0.2,0.7,0.001\n0.5,0.5,0\n");
  const std::string rest = "solution --problem square --fields u,traction --normal 0,1 --points ";
  const Answer of_file = call(folder, rest + points), of_input = call(folder, rest + "- < " + points);
  EXPECT_THAT(of_file.out, testing::StartsWith("X,Y,t,u_x,u_y,traction_x,traction_y\n0.20000000000000001,0.6999"));
  EXPECT_EQ(of_file.out, of_input.out);
  const auto single = call(folder, "solution --problem square --at 0.2,0.7 --time 0.001 --normal 0,2 --json").json();
  EXPECT_THAT(of_file.out, testing::HasSubstr(fmt::format(",{:.17g}\n", single["traction"][1].get<double>())));
  EXPECT_EQ(single["traction"][1], single["P"][1][1]);
}

TEST(SolutionCommand, SaysWhereItsPointsAreWrong) {
  const Folder folder;
  const std::string points = folder.write("points.csv", "X,Y,t\n0.2,0.7,0.001\n0.5,1.5,0\n");
  for (const auto& [arguments, why] :
       {std::pair<std::string, std::string>{"--points " + points, "points.csv:3 is outside the body"},
        {"--points - < " + points, "standard input:3 is outside the body"},
        {"--points " + points + " --fields w", "unknown field 'w' in --fields"},
        {"--points " + points + " --fields u,P,u", "field 'u' stands twice in --fields"},
        {"--points " + points + " --at 0,0", "--at excludes --points"},
        {"--points " + (folder / "none.csv"), "none.csv"},
        {"--at 0,0 --fields u", "--fields requires --points"},
        {"--points " + points + " --fields u --normal 1,0", "--normal without traction in --fields"},
        {"--at 0,0", "--time is required"},
        {"--at 0 --time 0", "--at 0 has 1 coordinate (the problem has 2)"},
        {"--time 0", "--at or --points is required"},
        {"--at 0,0 --time 0 --normal 0,0", "--normal has no direction"}}) {
    const Answer answer = call(folder, "solution --problem square " + arguments);
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_THAT(answer.err, testing::HasSubstr(why));
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
  }
}

TEST(SolutionCommand, QuotesLittleOfPointsThatAreNone) {
  const Folder folder;
  folder.write("binary", "SQLite" + std::string(50'000, '\0') + "\n1\n");
  const std::string solution = "solution --problem bar --time 0 --points ", name = folder / "binary";
  const std::string why = " is no text: it has bytes of 0 (CSV with columns X, ... and t)\n";
  EXPECT_EQ(call(folder, solution + name).err, "mpmvv: --points " + name + why);
  EXPECT_EQ(call(folder, solution + "- < " + name).err, "mpmvv: --points -" + why);
  const Answer words = call(folder, solution + folder.write("words", std::string(50'000, 'x') + "\n1\n"));
  EXPECT_EQ(words.code, 2);
  EXPECT_THAT(words.err, testing::StartsWith("mpmvv: no column 'X' in "));
  EXPECT_THAT(words.err, testing::HasSubstr("xxx…xxx"));
  EXPECT_THAT(words.err, testing::EndsWith("xxx)\n")) << "the end stays";
  EXPECT_LT(words.err.size(), 2100U);
  std::string umlauts_of_a_file;
  for (int k = 0; k < 5000; ++k) umlauts_of_a_file += "ä";
  const Answer umlauts = call(folder, solution + folder.write("words", umlauts_of_a_file + "\n1\n"));
  EXPECT_THAT(umlauts.err, testing::EndsWith("ää)\n"));
  EXPECT_THAT(umlauts.err, testing::Not(testing::HasSubstr("\\x"))) << "no half of a character";
}

}  // namespace mpmvv::cli::solution_test
