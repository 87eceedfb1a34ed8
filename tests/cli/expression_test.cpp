#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv::cli::expression_test {

using testing::HasSubstr;
using testing::StartsWith;

TEST(ExpressionCommand, PrintsALineForEachComponent) {
  const Folder folder;
  const Answer answer = call(folder, "expression --problem wave --form current --dialect fortran");
  EXPECT_EQ(answer.out,
            "b_x = 0d0\nb_y = 0d0\n"
            "v0_x = 0.36449973833383426d0*sin(3.141592653589793d0*X)\nv0_y = 0d0\n"
            "u_x = 0.001d0*sin(3.141592653589793d0*X)*sin(364.4997383338343d0*t)\nu_y = 0d0\n"
            "F0_xx = 1d0\nF0_xy = 0d0\nF0_yx = 0d0\nF0_yy = 1d0\n");
}

TEST(ExpressionCommand, SaysWhatTheDialectCannotWrite) {
  const Folder folder;
  const Answer answer = call(folder, "expression --problem wave --form current --dialect nairn");
  EXPECT_THAT(answer.out, HasSubstr("v0_x = 0.36449973833383426*sin(3.141592653589793*x)\n"));
  EXPECT_EQ(answer.err, "mpmvv: u is left out: the dialect nairn cannot write it\n");
}

TEST(ExpressionCommand, GivesScriptsAnObject) {
  const Folder folder;
  const auto json = call(folder, "expression --problem square-rest --param amplitude=0.01 --dialect c --json").json();
  EXPECT_EQ(json["form"], "reference");
  EXPECT_EQ(json["parameters"]["amplitude"], 0.01);
  EXPECT_EQ(json["v0"], nlohmann::json::array({"0.0", "0.0"}));
  EXPECT_THAT(json["b"][1].get<std::string>(), StartsWith("0.09869604401089359*sin(3.141592653589793*Y)"));
}

TEST(ExpressionCommand, GivesEachParticleItsLine) {
  const Folder folder;
  const Answer answer =
      call(folder, "expression --problem square-rest --cells 4 --ppc 1 --cfl 0.2 --form per-particle --dialect python");
  EXPECT_THAT(answer.out, StartsWith("id,b_x,b_y\n1,\"0.07553"));
  EXPECT_EQ(std::count(answer.out.begin(), answer.out.end(), '\n'), 17);
  EXPECT_EQ(answer.out.find('X'), std::string::npos);
}

/// In whatever order the case starts with them.
TEST(ExpressionCommand, NamesEachParticleByItsId) {
  const Folder folder;
  const std::string plain =
      "expression --problem square-rest --cells 4 --ppc 1 --cfl 0.2 --form per-particle --dialect python";
  const std::string shuffled = plain + " --shuffle 7", csv = call(folder, shuffled).out;
  auto in_order = call(folder, plain + " --json").json(), json = call(folder, shuffled + " --json").json();
  ASSERT_EQ(json["id"].size(), 16U);
  EXPECT_NE(json["id"], in_order["id"]);
  for (std::size_t p = 0; p < 16; ++p) {
    const auto id = json["id"][p].get<std::size_t>();
    EXPECT_EQ(in_order["id"][id - 1], id);
    EXPECT_EQ(json["b"][p], in_order["b"][id - 1]);
    EXPECT_THAT(csv, HasSubstr(fmt::format("\n{},\"{}\"", id, json["b"][p][0].get<std::string>())));
  }
}

TEST(ExpressionCommand, TakesTheQuarterOfABody) {
  const Folder folder;
  EXPECT_EQ(call(folder, "expression --problem ring --quarter --dialect c").code, 0);
}

TEST(ExpressionCommand, RefusesInOneLine) {
  const Folder folder;
  for (const auto& [arguments, why] :
       {std::pair{"--problem square --form current --dialect c", "problems with form 'current': stretch, "},
        {"--problem square --dialect cobol", "known: c, fortran, python, muparser, nairn, karamelo"},
        {"--problem square --form sideways --dialect c", "known: reference, current, inverse"},
        {"--problem square --form per-particle --dialect c", "no cells given (--cells, or "},
        {"--problem bar --dialect c --basis nonsense --cells -3",
         "basis in --basis has no meaning for form 'reference'"}}) {
    const Answer answer = call(folder, std::string("expression ") + arguments);
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_THAT(answer.err, HasSubstr(why));
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
  }
}

}  // namespace mpmvv::cli::expression_test
