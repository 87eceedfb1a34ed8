#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv::cli::particles_test {

using testing::HasSubstr;
using testing::StartsWith;

const std::string square = "particles --problem square-rest --cells 4 --ppc 2 --cfl 0.2";

TEST(ParticlesCommand, PrintsAndWritesTheSameLines) {
  const Folder folder;
  const Answer printed = call(folder, square);
  EXPECT_THAT(printed.out, StartsWith("id,X,Y,x,y,v_x,v_y,m,V,F_xx,F_xy,F_yx,F_yy\n1,0.0625,0.0625,0.0625,0.0625,"));
  EXPECT_EQ(std::count(printed.out.begin(), printed.out.end(), '\n'), 65);
  const Answer written = call(folder, square + " --csv " + (folder / "p.csv") + " --vtu " + (folder / "p.vtu"));
  EXPECT_EQ(written.out, "");
  EXPECT_EQ(read_text(folder / "p.csv"), printed.out);
  EXPECT_THAT(read_text(folder / "p.vtu"), HasSubstr("NumberOfPoints=\"64\""));
}

TEST(ParticlesCommand, SaysWhatACodeHasToKnowBesideThem) {
  const Folder folder;
  const auto json = call(folder, square + " --json").json();
  EXPECT_EQ(json["particles"], 64);
  EXPECT_EQ(json["starts_at_rest"], true);
  EXPECT_EQ(json["starts_undeformed"], true);
  EXPECT_EQ(json["material"], "neo-hookean-log");
  EXPECT_NEAR(json["lambda"], 1e4 * 0.3 / (1.3 * 0.4), 1e-9);
  EXPECT_NEAR(json["mu"], 1e4 / 2.6, 1e-9);
  EXPECT_EQ(json["steps"], 40);
  EXPECT_EQ(json["grid"]["boundary"]["ymax"], "symmetry");
  EXPECT_EQ(json["grid"]["cells"], nlohmann::json::array({4, 4}));
  EXPECT_EQ(json["parameters"]["amplitude"], 0.02);
  EXPECT_FALSE(call(folder, "particles --problem square --cells 4 --ppc 2 --cfl 0.2 --json").json()["starts_at_rest"]);
}

TEST(ParticlesCommand, RefusesWhatIsNoCase) {
  const Folder folder;
  const Answer answer = call(folder, "particles --problem square-rest --cells 4 --ppc 2");
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1);
  EXPECT_EQ(call(folder, square + " --csv " + (folder / "no/such/p.csv")).code, 2);
  const std::string csv = " --csv " + (folder / "a"), other_name = (folder / "b/../a");
  std::filesystem::create_directories(folder / "b");
  EXPECT_THAT(call(folder, square + csv + " --vtu " + other_name).err, HasSubstr("--csv and --vtu both write '"));
  EXPECT_THAT(call(folder, square + " --csv c --vtu ./c").err, HasSubstr("--csv and --vtu both write '"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a"));
}

TEST(ParticlesCommand, RefusesCodesAndVariantsThatAreNotThere) {
  const Folder folder;
  for (const auto& [code, why] : {std::pair{"--code small-mmp", "no adapter of code 'small-mmp' in --code"},
                                  {"--code small-mpm --variant x", "unknown variant 'x' of code 'small-mpm'"},
                                  {"--code small-mpm", "no variant for code 'small-mpm' in --code"}}) {
    const Answer answer = call(folder, square + " " + code);
    EXPECT_EQ(answer.code, 2) << code;
    EXPECT_THAT(answer.err, HasSubstr(why));
    EXPECT_EQ(answer.out, "");
    const std::string forces =
        "expression --dialect python --form per-particle --problem square --cells 4 --ppc 2 --cfl 0.2 ";
    EXPECT_THAT(call(folder, forces + code).err, HasSubstr(why));
  }
  const std::string named = square + " --code small-mpm --variant linear";
  EXPECT_EQ(call(folder, named).out, call(folder, square).out);
  EXPECT_EQ(call(folder, square + " --code matter --variant flip", "unset MPMVV_MATTER; ").code, 0);
}

}  // namespace mpmvv::cli::particles_test
