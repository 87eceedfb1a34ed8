#include "reports/published_costs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "studies/support/error.hpp"

namespace mpmvv::reports::published_costs_test {

using testing::ElementsAre;
using testing::MatchesRegex;

TEST(PublishedCosts, EachFigureHasAllThatAReaderNeeds) {
  ASSERT_GE(published_costs().size(), 4u);
  std::set<std::string> seen;
  for (const PublishedCost& code : published_costs()) {
    SCOPED_TRACE(code.name + ", " + code.hardware);
    for (const auto& text : {code.on, code.name, code.what, code.precision, code.hardware, code.published})
      EXPECT_FALSE(text.empty());
    EXPECT_THAT(code.date, MatchesRegex("20[0-9][0-9](-[0-9][0-9]){0,2}"));
    EXPECT_THAT(code.beside, MatchesRegex("[123]D, [0-9]+ per cell/.+"));
    EXPECT_GT(code.per_particle_step(), 1e-11);
    EXPECT_LT(code.per_particle_step(), 1e-3);
    EXPECT_TRUE(seen.insert(code.name + code.what + code.hardware).second) << "stands there twice";
  }
}

constexpr const char* entry = R"(
[[code]]
on = "one thread"
name = "Other"
what = "3D"
precision = "single"
hardware = "a processor"
published = "2 s for 10 steps"
seconds = 2
steps = 10
particles = 1000
beside = "3D, 8 per cell/linear"
source = "https://example.org"
date = "2020"
)";

TEST(PublishedCosts, AFieldThatIsMissingUnknownOrNoSizeIsRefused) {
  EXPECT_EQ(read_published_costs(entry, "codes").size(), 1u);
  const std::string all = entry;
  for (const char* key : {"on", "name", "what", "precision", "hardware", "published", "seconds", "steps", "particles",
                          "beside", "source", "date"}) {
    const auto begin = all.find(std::string("\n") + key + " = ") + 1;
    std::string without = all;
    without.erase(begin, all.find('\n', begin) - begin);
    EXPECT_THROW(read_published_costs(without, "codes"), support::UsageError) << key;
  }
  EXPECT_THROW(read_published_costs(all + "colour = 1\n", "codes"), support::UsageError);
  for (const auto& [right, wrong] : {std::pair{"steps = 10", "steps = 0"}, {"https://", "some paper of "}}) {
    std::string changed = all;
    changed.replace(changed.find(right), std::string_view(right).size(), wrong);
    EXPECT_THROW(read_published_costs(changed, "codes"), support::UsageError) << wrong;
  }
}

TEST(PublishedCosts, HaveNoRatioWhereTheHardwareIsNotSaid) {
  std::string unsaid = entry;
  unsaid.replace(unsaid.find("a processor"), 11, "not said");
  Benchmark benchmark;
  benchmark.rows = {{"case/3D, 8 per cell/linear/cube", "", {{"per_particle_step", {50e-9}}}}};
  const Table table = others_table(benchmark, read_published_costs(unsaid, "codes"));
  EXPECT_THAT(table.groups.at(0).rows.at(0), ElementsAre("Other", "3D", "single", "not said", "2 s for 10 steps",
                                                         "200000", "50.0", "–", "https://example.org", "2020"));
}

TEST(PublishedCosts, StandBesideACaseOfTheSameKind) {
  const auto codes = read_published_costs(entry, "codes");
  Benchmark benchmark;
  benchmark.rows = {{"case/3D, 8 per cell/linear/cube", "", {{"per_particle_step", {50e-9}}}}};
  const Table table = others_table(benchmark, codes);
  ASSERT_EQ(table.groups.size(), 1u);
  EXPECT_EQ(table.groups[0].title, "one thread");
  EXPECT_THAT(table.groups[0].rows, ElementsAre(ElementsAre("Other", "3D", "single", "a processor", "2 s for 10 steps",
                                                            "200000", "50.0", "4000", "https://example.org", "2020")));
  benchmark.rows.insert(benchmark.rows.begin(),
                        {"case/3D, 8 per cell/linear/another", "", {{"per_particle_step", {80e-9}}}});
  auto of_one_case = codes;
  of_one_case[0].beside += "/cube";
  EXPECT_EQ(others_table(benchmark, of_one_case).groups[0].rows, table.groups[0].rows);
  benchmark.rows = {{"case/3D, 8 per cell/linear-like/cube", "", {{"per_particle_step", {50e-9}}}}};
  EXPECT_TRUE(others_table(benchmark, codes).empty());
}

}  // namespace mpmvv::reports::published_costs_test
