#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::mutation_results_test {

using testing::HasSubstr;
using testing::Not;

/// A tree with its program and a store, and beside this and in tests/mutation what a campaign may have left.
class MutationResultsOnDisk : public testing::Test {
 protected:
  MutationResultsOnDisk() {
    for (const char* folder : {"build/release", "tests/mutation", "results", "elsewhere/tests/mutation"})
      std::filesystem::create_directories(folder_ / folder);
    std::filesystem::copy(program(), folder_ / "build/release");
    std::filesystem::create_directory_symlink(MPMVV_SOURCE_DIR "/studies", folder_ / "studies");
    store::Store store(folder_ / "results/r.db", store::Store::Mode::create_or_write);
    records::StudyResult breadth;
    breadth.name = "x-breadth", breadth.kind = records::StudyKind::check, breadth.claims = {"X-mutants"};
    store::Provenance own = store::current_provenance();
    own.digest = own_digest(folder_);
    store.keep_study(breadth, {}, own);
  }

  /// So many mistakes tried, of which some are missed.
  static std::string summary(const std::string& digest, int tried, const std::vector<std::string>& missed) {
    const int caught = tried - static_cast<int>(missed.size());
    return nlohmann::json{{"digest", digest},
                          {"commit", "c0ffee"},
                          {"gate", "g"},
                          {"seeds", {1}},
                          {"unchanged_passes", true},
                          {"planted",
                           {{"should_show", tried},
                            {"equivalent", 0},
                            {"untried", 0},
                            {"open", 0},
                            {"missed", missed},
                            {"caught", caught},
                            {"unit_tests", caught},
                            {"quick", 0},
                            {"nightly", 0}}},
                          {"random",
                           {{"tried", 0},
                            {"explained", 0},
                            {"unexplained", nlohmann::json::array()},
                            {"caught", 0},
                            {"unit_tests", 0},
                            {"quick", 0},
                            {"nightly", 0}}},
                          {"survivors", nlohmann::json::array()}}
        .dump();
  }

  Answer in_folder(const std::string& arguments) const {
    return carry_out(folder_, "build/release/mpmvv " + arguments);
  }

  /// The claim on mutants.
  nlohmann::json claim() const {
    const nlohmann::json answer = in_folder("claims --json --db results/r.db").json();
    for (const auto& claim : answer["claims"])
      if (claim["id"] == "X-mutants") return claim;
    return {};
  }

  const Folder folder_;
};

TEST_F(MutationResultsOnDisk, AreJudgedWhereTheyAreOfThisProgram) {
  EXPECT_EQ(claim()["verdict"], "open");
  folder_.write("tests/mutation/summary.json", summary("other", 5, {}));
  EXPECT_EQ(claim()["verdict"], "open");
  folder_.write("tests/mutation/summary.json", summary(own_digest(folder_), 5, {}));
  EXPECT_EQ(claim()["verdict"], "partly") << "no runs without a mistake";
  EXPECT_THAT(claim()["evidence"].get<std::string>(), HasSubstr("5 of 5; 0 by the quick gate alone, 5 by the unit"));
}

/// A project of one's own may have a folder of that name for its own tests.
TEST_F(MutationResultsOnDisk, AreNotThoseOfTheFolderWhereTheProgramIsCalled) {
  folder_.write("tests/mutation/summary.json", summary(own_digest(folder_), 5, {}));
  const auto called_elsewhere = [&] {
    return carry_out(folder_, "cd elsewhere && ../build/release/mpmvv claims X-mutants --db ../results/r.db");
  };
  EXPECT_THAT(called_elsewhere().out, HasSubstr("X-mutants: partly"));
  folder_.write("elsewhere/tests/mutation/summary.json", "{\"score\": 5}");
  folder_.write("elsewhere/tests/mutation/alarms.toml", "bells = 2\n");
  const Answer answer = called_elsewhere();
  EXPECT_THAT(answer.out, HasSubstr("X-mutants: partly")) << answer.err;
}

TEST_F(MutationResultsOnDisk, OfTheStoresFolderCountWhereTheyKnowMore) {
  folder_.write("tests/mutation/summary.json", summary(own_digest(folder_), 5, {}));
  folder_.write("results/mutants.json", summary(own_digest(folder_), 3, {"sign"}));
  EXPECT_THAT(claim()["evidence"].get<std::string>(), HasSubstr("5 of 5"));
  folder_.write("results/mutants.json", summary(own_digest(folder_), 7, {"sign"}));
  EXPECT_THAT(claim()["evidence"].get<std::string>(), HasSubstr("6 of 7, not sign"));
}

TEST_F(MutationResultsOnDisk, AreMadeAnewByTheTree) {
  const auto page = [&] { return in_folder("claims X-mutants --db results/r.db").out; };
  EXPECT_THAT(page(), HasSubstr("repeat: ./run mutants && ./run alarms\n"));
  EXPECT_THAT(page(), HasSubstr("not judged yet for this version of the program\n"));
  folder_.write("tests/mutation/summary.json", summary(own_digest(folder_), 5, {}));
  EXPECT_THAT(page(), testing::AllOf(HasSubstr("repeat: ./run mutants && ./run alarms\n"), Not(HasSubstr("no study"))));
  ASSERT_EQ(in_folder("report --db results/r.db --out report").code, 0);
  EXPECT_THAT(read_text(folder_ / "report/claims/X-mutants.html"),
              HasSubstr("<code>./run mutants &amp;&amp; ./run alarms</code>"));
}

/// What a campaign found of an earlier version is gone, so nothing is said of a change.
TEST_F(MutationResultsOnDisk, AreNotHeldAgainstAnEarlierVersion) {
  store::Provenance earlier = store::current_provenance();
  earlier.digest = "00ff", earlier.commit = "c0ffee", earlier.time = "2001-01-01T00:00:00Z";
  {
    store::Store store(folder_ / "results/r.db", store::Store::Mode::write);
    store.keep_study(store.studies(own_digest(folder_)).at(0), {}, earlier);
  }
  folder_.write("tests/mutation/summary.json", summary(own_digest(folder_), 5, {}));
  ASSERT_EQ(in_folder("report --db results/r.db --out report").code, 0);
  const std::string page = read_text(folder_ / "report/index.html");
  EXPECT_THAT(page, HasSubstr("Since the version before"));
  EXPECT_THAT(page, Not(HasSubstr("was open")));
}

TEST_F(MutationResultsOnDisk, HaveNoReportInTheirPlace) {
  for (const char* out : {"tests/mutation", "tests"})
    EXPECT_THAT(in_folder(std::string("report --db results/r.db --out ") + out).err,
                HasSubstr(std::string(out) + " is a folder that holds '"));
}

TEST_F(MutationResultsOnDisk, AnythingElseIsRefused) {
  for (const char* file : {"tests/mutation/summary.json", "results/mutants.json"}) {
    folder_.write(file, "{\"digest\": 5}");
    const Answer answer = in_folder("claims --db results/r.db");
    EXPECT_EQ(answer.code, 2);
    EXPECT_THAT(answer.err, HasSubstr(std::string(file) + " is not what `./run mutants` writes"));
    std::filesystem::remove(folder_ / file);
  }
}

TEST_F(MutationResultsOnDisk, AreShownInTheReportWithTheirVersion) {
  folder_.write("small.toml", small_study);
  ASSERT_EQ(in_folder("study small.toml --db results/r.db").code, 0);
  const auto page = [&] {
    const Answer answer = in_folder("report --db results/r.db --out report");
    EXPECT_EQ(answer.code, 0) << answer.err;
    return read_text(folder_ / "report/mutants.html");
  };
  EXPECT_THAT(page(), Not(HasSubstr("id=\"mutants\"")));
  folder_.write("tests/mutation/summary.json", summary("other", 5, {"sign"}));
  EXPECT_THAT(page(), testing::AllOf(HasSubstr("commit c0ffee"), HasSubstr("were tried with another version")));
  EXPECT_THAT(page(), HasSubstr("4 of 5 (80 %)"));
  folder_.write("results/mutants.json", summary(own_digest(folder_), 7, {}));
  EXPECT_THAT(page(), testing::AllOf(HasSubstr("7 of 7 (100 %)"), Not(HasSubstr("another version"))));
}

TEST(Program, KnowsNothingOfMutants) {
  const Folder folder;
  EXPECT_THAT(call(folder, "--help").out, Not(HasSubstr("mutant")));
  const Answer answer = call(folder, "mutants --list");
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("unknown command 'mutants' (known: "));
}

}  // namespace mpmvv::cli::mutation_results_test
