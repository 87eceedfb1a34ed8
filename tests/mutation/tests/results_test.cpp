#include "tests/mutation/results.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/mutation_results.hpp"
#include "studies/support/error.hpp"
#include "tests/mutation/tests/samples.hpp"

namespace mpmvv::mutation::results_test {

using namespace samples;
using testing::ElementsAre;
using testing::HasSubstr;

const Mutant sign{.name = "sign",
                  .kind = Mutant::Kind::random,
                  .what = "'+' becomes '-'",
                  .file = "solver/grid.hpp",
                  .line = 12,
                  .before = "a + \"b\"",
                  .after = "a - \"b\"",
                  .gate = "1/2",
                  .builds = true,
                  .trials = {{GateStage::quick, true, {"s-fig10: order", "w-one: value"}, 60},
                             {GateStage::unit_tests, false, {}, 1.5}},
                  .reason = "why",
                  .seed = 7};

class TriedFile : public testing::Test {
 protected:
  ResultsFile open(const std::string& digest = "d1") const {
    return ResultsFile(file_, Reasons(folder_ / ""), provenance(digest));
  }
  std::vector<Mutant> kept() const { return read_results(file_)->mutants; }
  static std::string text_of(const std::filesystem::path& file) {
    return (std::stringstream() << std::ifstream(file).rdbuf()).str();
  }

  OwnFolder folder_;
  std::filesystem::path file_ = folder_ / "mutants.json";
};

TEST_F(TriedFile, AMutantComesBackAsItWasKept) {
  open().keep(mutant("a", {passes, caught}));
  const auto mutants = open().known().mutants;
  ASSERT_EQ(mutants.size(), 1U);
  EXPECT_EQ(find_mutant(mutants, mutant("a", {})), &mutants[0]);
  EXPECT_EQ(find_mutant(mutants, mutant("a", {}, "g2")), nullptr);
  EXPECT_EQ(mutants[0].what, "a \"sign\", or two");
  ASSERT_EQ(mutants[0].trials.size(), 2U);
  EXPECT_EQ(mutants[0].trial(GateStage::quick)->by, caught.by);
  EXPECT_EQ(mutants[0].trial(GateStage::unit_tests)->seconds, 1.5);
  EXPECT_EQ(mutants[0].trial(GateStage::nightly), nullptr);
  EXPECT_TRUE(open("d2").known().mutants.empty());
}

TEST_F(TriedFile, TheLastKeepingStays) {
  ResultsFile file = open();
  file.keep(mutant("a", {passes}));
  file.keep(mutant("a", {passes, caught}));
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_TRUE(kept()[0].caught());
  file.keep(mutant("a", {passes}, "g2"));
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_FALSE(kept()[0].caught());
  Mutant other = sign;
  file.keep(sign);
  other.seed = 8;
  file.keep(other);
  EXPECT_EQ(kept().size(), 3U) << "a draw with another seed is another mutant";
}

TEST_F(TriedFile, AProgramThatComesBackGoesOnFromWhatWasSetAside) {
  open("d1").keep(mutant("a", {passes}));
  open("d2").keep(mutant("b", {passes}));
  EXPECT_EQ(open("d1").known().mutants.size(), 1U);
  open("d1").keep(mutant("c", {passes}));
  open("d2").keep(mutant("d", {passes}));
  EXPECT_EQ(open("d1").known().mutants.size(), 2U);
  EXPECT_EQ(open("d2").known().mutants.size(), 2U);
}

TEST_F(TriedFile, MakesOneMutantOfTwoLayouts) {
  Mutant moved = sign;
  moved.line += 3;
  moved.before += "  // as before";
  EXPECT_NE(find_mutant({moved}, sign), nullptr);
  moved.before += "\nreturn 0;";
  EXPECT_EQ(find_mutant({moved}, sign), nullptr);
}

TEST_F(TriedFile, GivesBackWhatWasPublished) {
  std::ofstream(file_) << to_json({"d1", "c0ffee", {sign, Mutant{}}});
  const Results tried = *read_results(file_);
  EXPECT_EQ(tried.digest, "d1");
  EXPECT_EQ(tried.commit, "c0ffee");
  ASSERT_EQ(tried.mutants.size(), 2U);
  const Mutant& mutant = tried.mutants[0];
  EXPECT_NE(find_mutant({mutant}, sign), nullptr);
  EXPECT_EQ(mutant.kind, sign.kind);
  EXPECT_EQ(mutant.what, sign.what);
  EXPECT_EQ(mutant.reason, sign.reason);
  EXPECT_EQ(mutant.seed, 7U);
  EXPECT_TRUE(mutant.builds);
  ASSERT_EQ(mutant.trials.size(), 2U);
  EXPECT_TRUE(mutant.caught_by(GateStage::quick));
  EXPECT_EQ(mutant.trial(GateStage::quick)->by, sign.trials[0].by);
  EXPECT_EQ(mutant.trial(GateStage::unit_tests)->seconds, 1.5);
  EXPECT_EQ(mutant.trial(GateStage::nightly), nullptr);
  EXPECT_TRUE(tried.mutants[1].trials.empty());
}

TEST_F(TriedFile, MayBeAbsent) {
  EXPECT_FALSE(read_results(file_));
  EXPECT_TRUE(open().known().mutants.empty());
  EXPECT_FALSE(std::filesystem::exists(file_)) << "made with the first mutant";
}

TEST_F(TriedFile, AnythingElseIsRefused) {
  const auto complaint = [this](const std::string& text) -> std::string {
    std::ofstream(file_) << text;
    try {
      open().keep(sign);
    } catch (const support::UsageError& e) {
      EXPECT_EQ(text_of(file_), text) << "left as it is";
      return e.what();
    }
    return "";
  };
  for (const char* text : {"", "[]", "{\"digest\": \"d\"}", "{\"digest\": 1, \"commit\": \"\", \"mutants\": []}",
                           "{\"digest\": \"../d\", \"commit\": \"\", \"mutants\": []}"})
    EXPECT_THAT(complaint(text), HasSubstr(file_.string())) << text;
  auto unknown = to_json({"d", "c", {sign}});
  unknown["mutants"][0]["kind"] = "rare";
  EXPECT_THAT(complaint(unknown.dump()), HasSubstr("unknown kind of mutant 'rare' in " + file_.string()));
  EXPECT_THAT(complaint(summary_of({"d", "c", {sign}}).dump()), HasSubstr("not of this form"));
}

TEST_F(TriedFile, ThoseOfAnotherProgramAreSetAside) {
  open("0123456789abcdef").keep(sign);
  const std::string before = text_of(file_);
  ResultsFile file = open();
  EXPECT_EQ(text_of(file_), before) << "nothing to keep yet";
  file.keep(mutant("a", {passes}));
  EXPECT_EQ(text_of(folder_ / "mutants-01234567.json"), before);
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(kept()[0].name, "a");
}

/// Whenever a campaign is killed, its file is whole and has all that was kept before.
TEST_F(TriedFile, IsWholeWhenItsWriterIsKilled) {
  for (int milliseconds = 1; milliseconds <= 40; milliseconds += 3) {
    const pid_t child = fork();
    if (child == 0) {
      ResultsFile file = open();
      for (int k = 0;; ++k) file.keep(mutant("m" + std::to_string(k % 200), {passes, caught}));
    }
    usleep(static_cast<useconds_t>(1000 * milliseconds));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const std::size_t before = std::filesystem::exists(file_) ? kept().size() : 0;
    open().keep(sign);
    EXPECT_GE(kept().size(), before);
    EXPECT_TRUE(reports::read_mutation_results(file_));
  }
}

TEST(Summaries, HoldTheScoreAndTheSurvivorsAlone) {
  const OwnFolder folder;
  std::vector<Mutant> all = sample();
  for (std::size_t k = 6; k < all.size(); ++k) all[k].seed = 3;
  publish({"d1", "c0ffee", all}, folder / "");
  const auto published = reports::read_mutation_results(folder / "summary.json");
  ASSERT_TRUE(published);
  EXPECT_EQ(published->digest, "d1");
  EXPECT_EQ(published->commit, "c0ffee");
  EXPECT_EQ(published->planted.should_show, 4);
  EXPECT_EQ(published->planted.caught, 2);
  EXPECT_EQ(published->planted.quick, 1);
  EXPECT_THAT(published->planted.missed, ElementsAre("missed"));
  EXPECT_EQ(published->random.tried, 3);
  EXPECT_EQ(published->random.explained, 1);
  EXPECT_TRUE(published->unchanged_passes.value());
  EXPECT_TRUE(published->mistakes.empty());
  ASSERT_EQ(published->survivors.size(), 2U);
  EXPECT_EQ(published->survivors[0].reason, "equivalent");
  EXPECT_EQ(published->survivors[1].before, "a + b;\n  c");
}

/// The report reads of a campaign's file what the campaign knows.
TEST(Summaries, AreOfTheWholeFileToo) {
  const OwnFolder folder;
  std::vector<Mutant> all = sample();
  all[0].gate = "g2";
  std::ofstream(folder / "mutants.json") << to_json({"d1", "c0ffee", all});
  const auto results = reports::read_mutation_results(folder / "mutants.json");
  ASSERT_TRUE(results);
  ASSERT_EQ(results->mistakes.size(), 5U);
  const reports::MutantResult& seen = results->mistakes[0];
  EXPECT_EQ(seen.name, "seen");
  EXPECT_EQ(seen.line, 12);
  EXPECT_TRUE(seen.by_earlier_gate);
  EXPECT_FALSE(seen.unit_tests->caught);
  EXPECT_EQ(seen.quick->by, caught.by);
  EXPECT_FALSE(seen.nightly);
  ASSERT_EQ(results->survivors.size(), 2U);
  EXPECT_EQ(results->survivors[1].name, "hole");
}

}  // namespace mpmvv::mutation::results_test
