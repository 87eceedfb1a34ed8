#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"

namespace mpmvv::cli {
namespace mutants_test {

using store::Store;

using testing::HasSubstr;

const std::string tree = std::string(" --source '") + MPMVV_SOURCE_DIR + "'";

TEST(MutantsCommand, ListsThePlantedMistakes) {
  const Folder folder;
  const auto mistakes = call(folder, "mutants --list --json" + tree).json()["mistakes"];
  EXPECT_GE(mistakes.size(), 45U);
  for (const auto& mistake : mistakes) EXPECT_FALSE(mistake["what"].get<std::string>().empty());
}

TEST(MutantsCommand, BadInputIsNamed) {
  const Folder folder;
  const auto complaint = [&folder](const std::string& options) {
    const Answer answer = call(folder, "mutants " + options);
    EXPECT_EQ(answer.code, 2) << options;
    return answer.err;
  };
  const std::string db = " --db '" + (folder / "m.db") + "' --work '" + (folder / "work") + "'";
  EXPECT_THAT(complaint(tree), HasSubstr("no --db given"));
  EXPECT_THAT(complaint(db + " --source '" + (folder / "none") + "'"), HasSubstr("planted.toml"));
  EXPECT_THAT(complaint(db + " --random -1" + tree), HasSubstr("--random"));
  EXPECT_THAT(complaint(db + " --publish --only hat-without-its-far-node" + tree), HasSubstr("--only"));
  EXPECT_FALSE(std::filesystem::exists(folder / "m.db"));
}

/// What a campaign needs is looked for before anything is made.
TEST(MutantsCommand, WritesNothingWhereItCannotBegin) {
  const Folder folder;
  const auto complaint = [&](const std::string& db) {
    const Answer answer = call(folder, "mutants --db '" + db + "' --work '" + (folder / "work") + "'" + tree);
    EXPECT_EQ(answer.code, 2);
    EXPECT_FALSE(std::filesystem::exists(db)) << db;
    EXPECT_FALSE(std::filesystem::exists(folder / "work"));
    return answer.err;
  };
  EXPECT_THAT(complaint(folder / "none/m.db"), HasSubstr("none' that may be written for results store"));
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  EXPECT_THAT(complaint(folder / "m.db"), HasSubstr("no program 'cmake'"));
  setenv("PATH", path.c_str(), 1);

  std::filesystem::create_directories(folder / "mine/tree");
  folder.write("mine/tree/notes", "mine");
  EXPECT_THAT(call(folder, "mutants --db '" + (folder / "m.db") + "' --work '" + (folder / "mine") + "'" + tree).err,
              HasSubstr("neither empty nor a laboratory"));
  EXPECT_EQ(read_text(folder / "mine/tree/notes"), "mine");
  EXPECT_FALSE(std::filesystem::exists(folder / "m.db"));
}

/// A store with one planted mistake that the quick gate has caught, tried by this program.
class KnownMutants : public testing::Test {
 protected:
  KnownMutants() {
    std::filesystem::create_directories(folder_ / "goldens/mutants");
    folder_.write(
        "goldens/mutants/planted.toml",
        "[[mistake]]\nname = \"sign\"\nwhat = \"A sign.\"\nfile = \"a.hpp\"\nfind = \"+\"\nreplace = \"-\"\n"
        "[[mistake]]\nname = \"factor\"\nwhat = \"A factor.\"\nfile = \"a.hpp\"\nfind = \"2\"\nreplace = \"3\"\n");
    Mutant sign{.name = "sign", .what = "A sign.", .file = "a.hpp", .line = 1, .gate = "g"};
    sign.trials = {{GateStage::quick, true, {"s-fig10: order"}, 1}};
    Store(db_, Store::Mode::create_or_write)
        .keep_mutant(sign, {known(db_empty())["digest"], "c", false, "", "", "", "", ""});
  }

  /// What is printed of a store and the goldens beside it.
  nlohmann::json known(const std::string& db, const std::string& more = "--known") {
    return call(folder_, "mutants --json --db '" + db + "' --source '" + (folder_ / "") + "' " + more).json();
  }
  std::string db_empty() {
    const std::string db = folder_ / "empty.db";
    Store(db, Store::Mode::create_or_write);
    return db;
  }

  Folder folder_;
  std::string db_ = folder_ / "m.db";
};

TEST_F(KnownMutants, ArePrintedAndNoneIsTried) {
  const auto mutants = known(db_)["mutants"];
  ASSERT_EQ(mutants.size(), 2U);
  EXPECT_EQ(mutants[0]["name"], "sign");
  EXPECT_TRUE(mutants[0]["quick"]["caught"]);
  EXPECT_TRUE(mutants[0]["unit_tests"].is_null());
  EXPECT_TRUE(mutants[1]["quick"].is_null());
}

TEST_F(KnownMutants, NoneIsMissing) {
  const Answer answer =
      call(folder_, "mutants --json --known --db '" + db_empty() + "' --source '" + (folder_ / "") + "'");
  EXPECT_EQ(answer.code, 3);
  EXPECT_EQ(answer.json()["mutants"].size(), 0U);
  EXPECT_THAT(answer.err, HasSubstr("empty.db knows no mutant of this program"));
}

TEST_F(KnownMutants, PublishedOnesCountWithoutAStore) {
  for (const char* time : {"the first", "the second"}) {
    EXPECT_EQ(known(db_, "--publish")["mutants"].size(), 2U) << time;
    const auto mutants = known(db_empty())["mutants"];
    ASSERT_EQ(mutants.size(), 2U) << time;
    EXPECT_TRUE(mutants[0]["quick"]["caught"]) << time;
  }
}

}  // namespace mutants_test
}  // namespace mpmvv::cli
