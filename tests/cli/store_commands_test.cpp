#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv {
namespace store_commands_test {

using testing::HasSubstr;
using testing::MatchesRegex;

TEST(DbCommand, ABadSourceLeavesNoTarget) {
  const Folder folder;
  const std::string target = folder / "target.db";
  EXPECT_EQ(call(folder, "db merge --db " + target + " " + (folder / "absent.db")).code, 2);
  EXPECT_FALSE(std::filesystem::exists(target));
}

TEST(GateCommand, ExitCodesOfTheContract) {
  const Folder folder;
  const std::string file = folder.write("small.toml", small_study), db = folder / "r.db";
  ASSERT_EQ(call(folder, "study " + file + " --db " + db).code, 0);
  std::filesystem::create_directories(folder / "goldens");
  const std::string gate = "gate --db " + db + " --goldens " + (folder / "goldens") + " ";
  EXPECT_EQ(call(folder, gate).code, 2) << "a gate without goldens must not pass";
  const auto golden = [&](const char* series, double expected) {
    folder.write("goldens/small.toml", "study = \"small\"\n[[order]]\nseries = \"" + std::string(series) +
                                           "\"\nnorm = \"l2\"\nexpected = " + std::to_string(expected) +
                                           "\nlower = " + std::to_string(expected - 0.15) +
                                           "\nupper = " + std::to_string(expected + 0.15) + "\n");
  };
  const auto claims = call(folder, "claims --db " + db + " --json").json()["claims"];
  const auto found = std::find_if(claims.begin(), claims.end(), [](const auto& c) { return c["id"] == "S-fig10"; });
  const std::string evidence = (*found)["evidence"];
  const double order = std::stod(evidence.substr(evidence.find(") = ") + 4));
  golden("bspline2", order);
  EXPECT_EQ(call(folder, gate + "--junit " + (folder / "gate.xml")).code, 0);
  EXPECT_THAT(read_text(folder / "gate.xml"), HasSubstr("<testsuites"));
  golden("bspline2", order + 1);
  EXPECT_EQ(call(folder, gate).code, 1);
  golden("bspline9", order);
  EXPECT_EQ(call(folder, gate).code, 3);
}

TEST(Program, NamesItsVersionWhenAsked) {
  const Folder folder;
  EXPECT_THAT(call(folder, "--version").out, MatchesRegex("mpmvv .*\ndigest [0-9a-f]+\n.*\n"));
}

TEST(ReportCommand, WritesOnePageAndItsFigures) {
  const Folder folder;
  const std::string file = folder.write("small.toml", small_study), db = folder / "r.db";
  ASSERT_EQ(call(folder, "study " + file + " --db " + db).code, 0);
  const Answer report =
      call(folder, "report --db " + db + " --out " + (folder / "report") + " --goldens " + (folder / "none"));
  ASSERT_EQ(report.code, 0) << report.err;
  for (const char* name : {"index.html", "figures/small.svg", "figures/small.pdf", "figures/small.gp",
                           "figures/small.dat", "tables/small.tex"})
    EXPECT_TRUE(std::filesystem::exists(folder / (std::string("report/") + name))) << name;
  EXPECT_THAT(
      call(folder, "report --db " + db + " --out " + (folder / "report") + " --goldens " + (folder / "none")).out,
      HasSubstr("(0 drawn)"));
}

}  // namespace store_commands_test
}  // namespace mpmvv
