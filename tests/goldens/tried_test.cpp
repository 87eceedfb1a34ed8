#include "goldens/mutants/tried.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "studies/support/error.hpp"

namespace mpmvv {
namespace tried_test {

using support::UsageError;

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
                  .reason = "why"};

class TriedFile : public testing::Test {
 protected:
  TriedFile() { std::filesystem::create_directories(folder_); }
  ~TriedFile() override { std::filesystem::remove_all(folder_); }

  TriedMutants read(const std::string& text) const {
    std::ofstream(folder_ / "tried.json") << text;
    return read_tried(folder_);
  }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("mpmvv-tried-" + std::to_string(getpid()));
};

TEST_F(TriedFile, GivesBackWhatWasPublished) {
  publish({"d1", "c0ffee", {sign, Mutant{}}}, folder_);
  const TriedMutants tried = read_tried(folder_);
  EXPECT_EQ(tried.digest, "d1");
  EXPECT_EQ(tried.commit, "c0ffee");
  ASSERT_EQ(tried.mutants.size(), 2U);
  const Mutant& mutant = tried.mutants[0];
  EXPECT_NE(find_mutant({mutant}, sign), nullptr);
  EXPECT_EQ(mutant.kind, sign.kind);
  EXPECT_EQ(mutant.what, sign.what);
  EXPECT_EQ(mutant.reason, sign.reason);
  EXPECT_TRUE(mutant.builds);
  ASSERT_EQ(mutant.trials.size(), 2U);
  EXPECT_TRUE(mutant.caught_by(GateStage::quick));
  EXPECT_EQ(mutant.trial(GateStage::quick)->by, sign.trials[0].by);
  EXPECT_EQ(mutant.trial(GateStage::unit_tests)->seconds, 1.5);
  EXPECT_EQ(mutant.trial(GateStage::nightly), nullptr);
  EXPECT_TRUE(tried.mutants[1].trials.empty());
}

TEST_F(TriedFile, MayBeAbsent) {
  EXPECT_TRUE(read_tried(folder_).mutants.empty());
}

TEST_F(TriedFile, AnythingElseIsRefused) {
  const auto complaint = [this](const std::string& text) -> std::string {
    try {
      read(text);
    } catch (const UsageError& e) {
      return e.what();
    }
    return "";
  };
  for (const char* text : {"", "[]", "{\"digest\": \"d\"}", "{\"digest\": 1, \"commit\": \"\", \"mutants\": []}"})
    EXPECT_THAT(complaint(text), HasSubstr((folder_ / "tried.json").string())) << text;
  nlohmann::json unknown = to_json({"d", "c", {sign}});
  unknown["mutants"][0]["kind"] = "rare";
  EXPECT_THAT(complaint(unknown.dump()), HasSubstr("unknown word 'rare'"));
}

TEST(PublishedMutants, AddWhatTheStoreDoesNotKnow) {
  Mutant stored = sign, published = sign, other = sign;
  stored.trials = {{GateStage::quick, false, {}, 1}};
  other.name = "other";
  const auto all = with_published({stored}, {published, other});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].name, "other");
  EXPECT_FALSE(all[1].caught_by(GateStage::quick)) << "the store's own";
  EXPECT_NE(all[1].trial(GateStage::unit_tests), nullptr);
}

}  // namespace tried_test
}  // namespace mpmvv
