#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "studies/provenance.hpp"
#include "studies/store.hpp"
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
  const Answer empty = call(folder, gate);
  EXPECT_EQ(empty.code, 2) << "a gate without goldens must not pass";
  EXPECT_THAT(empty.err, HasSubstr("`mpmvv propose --db DB --study NAME --out"));
  const auto golden = [&](const char* series, double expected, const char* mark = "reviewed = \"now\"\n") {
    folder.write("goldens/small.toml", std::string(mark) + "study = \"small\"\n[[order]]\nseries = \"" +
                                           std::string(series) + "\"\nnorm = \"l2\"\nexpected = " +
                                           std::to_string(expected) + "\nlower = " + std::to_string(expected - 0.15) +
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
  golden("bspline2", order, "");
  EXPECT_EQ(call(folder, gate).code, 3) << "nobody has reviewed it";
}

TEST(GateCommand, ATrialPassesOnlyWhereItIsAskedFor) {
  const Folder folder;
  std::string text = small_study;
  text.pop_back();  // no newline at its end
  const std::string file = folder.write("small.toml", text), db = folder / "r.db";
  std::filesystem::create_directories(folder / "goldens");
  folder.write("goldens/small.toml",
               "reviewed = \"now\"\nstudy = \"small\"\n[[status]]\nseries = \"linear\"\nat = 8\nexpected = \"ok\"\n");
  const std::string gate = "gate --db " + db + " --goldens " + (folder / "goldens") + " ";
  ASSERT_EQ(call(folder, "study --set-where-taken shuffle=3 " + file + " --db " + db).code, 0);
  const Answer trial = call(folder, gate);
  EXPECT_EQ(trial.code, 3);
  EXPECT_THAT(trial.out, HasSubstr("(made with --set: shuffle = 3 in 2 of 2 series)"));
  EXPECT_EQ(call(folder, gate + "--as-set").code, 0);
  ASSERT_EQ(call(folder, "study " + file + " --db " + db).code, 0);
  EXPECT_EQ(call(folder, gate).code, 0) << "the study as it stands";
}

TEST(ProposeCommand, MakesTheFolderOfItsFileAndNeedsNoGoldens) {
  const Folder folder;
  const std::string db = folder / "r.db", file = folder / "new/goldens/s.toml";
  StudyResult study;
  study.name = "s";
  study.values = {{"gap", 1, "a gap"}};
  Provenance clean = current_provenance();
  clean.dirty = false;
  Store(db, Store::Mode::create_or_write).keep_study(study, {}, clean);
  std::filesystem::create_directories(folder / "none/mutants");
  const std::string propose = "propose --db " + db + " --study s --goldens " + (folder / "none") + " --out ";
  const Answer made = call(folder, propose + file);
  EXPECT_EQ(made.code, 0) << made.err;
  const std::string gate = "gate --db " + db + " --goldens " + (folder / "new/goldens");
  EXPECT_EQ(call(folder, gate).code, 3) << "not reviewed yet";
  const std::string text = read_text(file);
  folder.write("new/goldens/s.toml", "reviewed = \"now\"\n" + text);
  EXPECT_EQ(call(folder, gate).code, 0);
  EXPECT_EQ(call(folder, propose + file).code, 2) << "it is there";
  const Answer no_folder = call(folder, propose + db + "/s.toml");
  EXPECT_EQ(no_folder.code, 2);
  EXPECT_THAT(no_folder.err, HasSubstr("cannot make the folder of " + db));
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
