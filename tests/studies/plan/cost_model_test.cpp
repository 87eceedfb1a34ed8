#include "studies/plan/cost_model.hpp"

#include <gtest/gtest.h>

#include "studies/settings/settings.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::plan::cost_model_test {

using CostModels = store::store_samples::StoreTest;
using store::Store;

cases::Case cube(const std::string& cells, const std::string& repeat = "") {
  std::vector<settings::Setting> settings{{"problem", "cube", ""}, {"basis", "bspline2", ""}, {"integrator", "cd", ""},
                                          {"cells", cells, ""},    {"ppc", "2", ""},          {"cfl", "0.5", ""},
                                          {"steps", "10", ""}};
  if (!repeat.empty()) settings.push_back({"repeat", repeat, ""});
  return settings::make_case(settings);
}

TEST_F(CostModels, LearnFromTheSameCaseElseFromLikeOnesElseGuess) {
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  EXPECT_EQ(CostModel(nullptr).time(cube("16")).source, Source::guess);
  EXPECT_EQ(CostModel(&store).time(cube("16")).source, Source::guess);
  store::Provenance older = store::current_provenance();
  older.digest = "older";
  for (const double seconds : {9.0, 3.0}) {  // the newer one counts
    older.digest += "x", older.time = seconds > 5 ? "2026-01-01T00:00:00Z" : "2026-01-02T00:00:00Z";
    records::Record record;
    record.the_case = cube("16"), record.particles = 32768, record.steps = 10, record.images = 8;
    record.wall_seconds = seconds;
    store.keep(record, older);
  }
  const CostModel model(&store);
  EXPECT_EQ(model.time(cube("16")).source, Source::same_case);
  EXPECT_DOUBLE_EQ(model.time(cube("16")).seconds, 3);
  const CostModel::Time like = model.time(cube("32"));  // on an eighth, as the other
  EXPECT_EQ(like.source, Source::like_cases);
  EXPECT_NEAR(like.seconds, 8 * 6, 1e-9) << "the mean of all runs, by particles and steps";
  EXPECT_NEAR(model.time(cube("32", "3")).seconds, 4 * 8 * like.seconds, 1e-9) << "four times the whole";
}

/// As of a code that chooses its time step and does not say how many it took.
TEST_F(CostModels, LearnNothingWithoutTheNumberOfSteps) {
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  records::Record record;
  record.the_case = cube("16"), record.particles = 32768, record.steps = 0, record.wall_seconds = 2;
  store.keep(record, store::current_provenance());
  EXPECT_TRUE(store.step_costs().empty());
  EXPECT_EQ(CostModel(&store).time(cube("32")).source, Source::guess);
  EXPECT_DOUBLE_EQ(CostModel(&store).time(cube("16")).seconds, 2);
}

TEST_F(CostModels, CountTheThreadsThatSharedARun) {
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  records::Record record;
  record.the_case = cube("16"), record.particles = 32768, record.steps = 10, record.images = 8;
  record.wall_seconds = 2, record.threads = 4;
  store.keep(record, store::current_provenance());
  EXPECT_DOUBLE_EQ(CostModel(&store).time(cube("16")).seconds, 8);
  EXPECT_NEAR(CostModel(&store).time(cube("32")).seconds, 8 * 8, 1e-9);
}

TEST(CostModel, GuessesTheCostOfThePartThatIsRun) {
  for (const auto& [problem, images] : {std::pair("vortex", 4), std::pair("ring", 8)}) {
    std::vector<settings::Setting> settings{
        {"problem", problem, ""}, {"basis", "bspline3", ""}, {"cells", "16", ""}, {"ppc", "2", ""}, {"cfl", "0.2", ""}};
    const double part = CostModel(nullptr).time(settings::make_case(settings)).seconds;
    settings.push_back({"whole", "true", ""});
    EXPECT_NEAR(CostModel(nullptr).time(settings::make_case(settings)).seconds, images * part, 1e-9 * part) << problem;
  }
}

}  // namespace mpmvv::plan::cost_model_test
