#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/reports/matches.hpp"
#include "tests/reports/report_pages.hpp"

namespace mpmvv::reports::trends_page_test {

namespace fs = std::filesystem;
using namespace report_pages;
using claims::Finding;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

ReportInput input_with_trends() {
  auto in = input();
  in.histories = {{"",
                   {{"00ff", {"8be1f2c0"}, "2026-01-01T00:00:00Z"}, {"11aa", {"<7>", "9cd"}, "2026-01-02T00:00:00Z"}},
                   {{"bar-bases", Finding::Kind::order, "order of 'a' & 'b'", {2, 1.9}},
                    {"bar-bases", Finding::Kind::error, "error of 'a'", {1e-3, 2e-3}},
                    {"bar-new", Finding::Kind::order, "of one version", {support::not_measured, 2}},
                    {"bar-cfl", Finding::Kind::limit, "limit of 'a'", {0.8, 0.8}},
                    {"weights", Finding::Kind::value, "value 'gap'", {1, 1}}}}};
  return in;
}

TEST(TrendsPage, IsNotThereWithoutHistories) {
  const TempFolder folder;
  EXPECT_THAT(page_of(input(), folder), Not(HasSubstr("trend.html")));
  EXPECT_FALSE(fs::exists(folder / "out" / "trend.html"));
}

TEST(TrendsPage, AnotherCodeStandsBesideOurOwn) {
  const TempFolder folder;
  auto in = input_with_trends();
  in.histories.push_back({"my-code",
                          {{"77ab", {"1.3"}, "2026-01-01T00:00:00Z"}, {"88cd", {"1.4"}, "2026-01-02T00:00:00Z"}},
                          {{"bar-bases", Finding::Kind::order, "order of 'theirs'", {2, 1.1}}},
                          {11, {"bar-bases: order of 'theirs': 2 -> 1.1 (-0.9)"}, {"study gone"}}});
  const auto page = page_of(in, folder, "trend.html");
  EXPECT_THAT(page,
              AllOf(HasSubstr("Versions of mpmvv"), HasSubstr("Versions of my-code"), HasSubstr("<code>1.4</code>"),
                    HasSubstr("in each version of my-code"), HasSubstr("id=\"trend-my-code~bar-bases\"")));
  EXPECT_TRUE(fs::exists(folder / "out/trends/my-code~bar-bases-orders.svg"));
  EXPECT_THAT(content(folder / "out/index.html"),
              AllOf(HasSubstr("What changed in my-code from 1.3 (digest 77ab) to 1.4 (digest 88cd): 1 of 11 results, 1 "
                              "without a result"),
                    HasSubstr("theirs"), HasSubstr("2 -&gt; 1.1 (-0.9)</li>")));
}

TEST(TrendsPage, HasAFigureOfEachKindOfNumber) {
  const TempFolder folder;
  EXPECT_THAT(page_of(input_with_trends(), folder), HasSubstr("<a href=\"trend.html\">"));
  const auto page = content(folder / "out" / "trend.html");
  EXPECT_EQ(matches(page, "(<figure)").size(), 3u) << "orders, errors, limits; no values, nothing of one version";
  EXPECT_THAT(page, Not(HasSubstr("bar-new")));
  EXPECT_THAT(page, AllOf(HasSubstr("<code>&lt;7&gt;</code>"), HasSubstr("href=\"index.html\"")));
  EXPECT_EQ(matches(page, "href=\"(trends/[^\"]*)\"").size(), 12u);
}

TEST(TrendsPage, NamesVersionsByTheFirstLettersOfTheirHashes) {
  const TempFolder folder;
  auto in = input_with_trends();
  in.histories[0].versions[0] = {"0123456789abcdef", {"fedcba98765432100-dirty"}, "2026-01-01T00:00:00Z"};
  EXPECT_THAT(page_of(in, folder, "trend.html"),
              AllOf(HasSubstr("<code>0123456789ab</code>"), HasSubstr("<code>fedcba987654-dirty</code>")));
}

TEST(TrendsPage, EarlierVersionsOpenWithAClick) {
  const TempFolder folder;
  auto in = input();
  History history{"", {}, {{"bars", Finding::Kind::order, "order of 'a'", std::vector<double>(12, 2)}}};
  for (int v = 1; v <= 12; ++v) history.versions.push_back({fmt::format("digest{}", v), {"c0"}, "2026-01-01"});
  in.histories = {history};
  const auto page = page_of(in, folder, "trend.html");
  const auto earlier = page.find("<details><summary>2 earlier versions</summary>");
  ASSERT_NE(earlier, std::string::npos);
  EXPECT_LT(page.find("<code>digest12</code>"), page.find("<code>digest3</code>")) << "the newest first";
  EXPECT_LT(page.find("<code>digest3</code>"), earlier);
  EXPECT_GT(page.find("<code>digest2</code>"), earlier);
  EXPECT_THAT(page, AllOf(HasSubstr("<caption>Versions of mpmvv"), HasSubstr("<caption>Earlier versions of mpmvv")));
}

TEST(TrendsPage, IsDrawnOnce) {
  const TempFolder folder;
  EXPECT_EQ(write_report(input_with_trends(), folder / "out", silent).figures_drawn, 6);
  EXPECT_EQ(write_report(input_with_trends(), folder / "out", silent).figures_drawn, 0);
}

}  // namespace mpmvv::reports::trends_page_test
