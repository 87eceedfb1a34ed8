#include "goldens/mutants/tried.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "studies/error.hpp"

namespace mpmvv {
namespace tried_test {

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
  ~TriedFile() override { std::filesystem::remove(file_); }

  TriedMutants read(const std::string& text) const {
    std::ofstream(file_) << text;
    return read_tried(file_);
  }

  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("mpmvv-tried-" + std::to_string(getpid()) + ".json");
};

TEST_F(TriedFile, GivesBackWhatWasWritten) {
  const TriedMutants tried = read(to_json({"d1", "c0ffee", {sign, Mutant{}}}).dump());
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
  EXPECT_TRUE(read_tried(file_).mutants.empty());
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
    EXPECT_THAT(complaint(text), HasSubstr(file_.string())) << text;
  nlohmann::json unknown = to_json({"d", "c", {sign}});
  unknown["mutants"][0]["kind"] = "rare";
  EXPECT_THAT(complaint(unknown.dump()), HasSubstr("unknown word 'rare'"));
}

}  // namespace tried_test
}  // namespace mpmvv
