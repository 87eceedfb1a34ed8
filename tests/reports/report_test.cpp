#include "reports/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "studies/support/error.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports {
namespace report_test {

using claims::Finding;

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

void silent(const std::string&) {}

ReportInput input() {
  ReportInput in;
  in.studies = {synthetic::convergence(), synthetic::limits(), synthetic::check()};
  in.gate = {{"bar-bases: order", "pass", "1.85 to 2.15", "2.01", ""},
             {"bar-cfl: limit", "inconclusive", "1.1 to 1.3", "–", "not <found>"}};
  in.claims = {{"S-fig10", "confirmed", "order 2.01 & <script>alert(1)</script>"}, {"W-fig3", "open", ""}};
  in.provenance = {"00ff", "8be1f2c", true, "GNU 12.2.0", "-O3 \"-march\"", "Release", "CPU", "2026-01-01T00:00:00Z"};
  return in;
}

std::string page_of(const ReportInput& in, const TempFolder& folder) {
  write_report(in, folder / "out", silent);
  return content(folder / "out" / "index.html");
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> result;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) result.push_back((*it)[1]);
  return result;
}

TEST(Report, WritesPageFiguresAndTables) {
  const TempFolder folder;
  std::vector<std::string> told;
  const auto summary = write_report(input(), folder / "out", [&](const std::string& line) { told.push_back(line); });
  EXPECT_EQ(summary.figures, 3);
  EXPECT_EQ(summary.figures_drawn, 3);
  EXPECT_EQ(summary.tables, summary.tables_written);
  for (const char* file :
       {"index.html", "figures/s-fig10.gp", "figures/s-fig10.dat", "figures/s-fig10.svg", "figures/s-fig10.pdf",
        "tables/bar-bases.csv", "tables/bar-bases.tex", "tables/fits/bar-bases.csv", "tables/bar-cfl.tex"})
    EXPECT_TRUE(fs::exists(folder / "out" / file)) << file;
  EXPECT_THAT(told, testing::Contains("figures: 3 of 3 redrawn"));
}

TEST(Report, PlantedMistakesHaveAPlaceOfTheirOwn) {
  const TempFolder folder;
  ReportInput in = input();
  EXPECT_THAT(page_of(in, folder), Not(HasSubstr("id=\"mutants\"")));
  in.mutation.emplace();
  in.mutation->digest = in.provenance.digest;
  in.mutation->mistakes = {{.name = "a <sign>"}};
  EXPECT_THAT(page_of(in, folder), AllOf(HasSubstr("id=\"mutants\""), HasSubstr("a &lt;sign&gt;")));
  EXPECT_TRUE(fs::exists(folder / "out/tables/program/mutants.tex"));
  EXPECT_THAT(page_of(in, folder), Not(HasSubstr("were tried with another build")));
  in.mutation->digest = "other";
  in.mutation->commit = "c0ffee";
  EXPECT_THAT(page_of(in, folder), HasSubstr("were tried with another build, of version c0ffee"));
}

TEST(Report, SecondCallWritesNothing) {
  const TempFolder folder;
  write_report(input(), folder / "out", silent);
  const auto before = fs::last_write_time(folder / "out" / "index.html");
  const auto summary = write_report(input(), folder / "out", silent);
  EXPECT_EQ(summary.figures_drawn, 0);
  EXPECT_EQ(summary.tables_written, 0);
  EXPECT_EQ(fs::last_write_time(folder / "out" / "index.html"), before);
}

TEST(Report, PageIsSelfContained) {
  const TempFolder folder;
  const auto page = page_of(input(), folder);
  for (const auto& address : matches(page, "(?:xmlns|xmlns:xlink)=\"(http[^\"]*)\""))
    EXPECT_THAT(address, HasSubstr("www.w3.org"));
  std::string rest = std::regex_replace(page, std::regex("xmlns(:xlink)?=\"[^\"]*\""), "");
  EXPECT_THAT(rest, AllOf(Not(HasSubstr("http:")), Not(HasSubstr("https:")), Not(HasSubstr("src=")),
                          Not(HasSubstr("<link")), Not(HasSubstr("@import")), Not(HasSubstr("<script"))));
  EXPECT_EQ(matches(page, "(<svg)").size(), 3u);
}

TEST(Report, IdsAreUniqueAndLinksLead) {
  const TempFolder folder;
  const auto page = page_of(input(), folder);
  const auto ids = matches(page, " id=[\"']([^\"']*)[\"']");
  const std::set<std::string> known(ids.begin(), ids.end());
  EXPECT_EQ(known.size(), ids.size());
  for (const auto& target : matches(page, "href=[\"']#([^\"']*)[\"']")) {
    if (target != "claim-S-fig11" && target != "claim-S-fig9" && target != "claim-S-fig4") {
      EXPECT_TRUE(known.contains(target)) << target;
    }
  }
  for (const auto& file : matches(page, "href=\"((?:figures|tables)/[^\"]*)\""))
    EXPECT_TRUE(fs::exists(folder / "out" / file)) << file;
}

TEST(Report, TextIsEscaped) {
  const TempFolder folder;
  const auto page = page_of(input(), folder);
  EXPECT_THAT(
      page, AllOf(HasSubstr("order 2.01 &amp; &lt;script&gt;"), HasSubstr("Bar: order of the bases &lt;S &amp; W&gt;"),
                  HasSubstr("&lt;b&gt;at&lt;/b&gt;"), HasSubstr("not &lt;found&gt;"), HasSubstr("# a &lt; b")));
}

TEST(Report, VerdictAndProvenanceStandOnTop) {
  const TempFolder folder;
  auto in = input();
  auto page = page_of(in, folder);
  const auto top = page.substr(0, page.find("<nav"));
  EXPECT_THAT(top, AllOf(HasSubstr("badge inconclusive"), HasSubstr("1 pass, 1 inconclusive"),
                         HasSubstr("1 confirmed, 1 open"), HasSubstr("dirty: built from"), HasSubstr("8be1f2c")));
  in.provenance.dirty = false;
  in.gate[0].verdict = "fail";
  page = page_of(in, folder);
  EXPECT_THAT(page, AllOf(HasSubstr("<title>mpmvv: fail</title>"), Not(HasSubstr("dirty: built from"))));
}

TEST(Report, ClaimsLeadToTheirStudies) {
  const TempFolder folder;
  EXPECT_THAT(page_of(input(), folder), HasSubstr("<a href=\"#study-bar-bases\">bar-bases</a>"));
}

ReportInput input_with_trends() {
  auto in = input();
  in.versions = {{"00ff", {"8be1f2c0"}, "2026-01-01T00:00:00Z"}, {"11aa", {"<7>", "9cd"}, "2026-01-02T00:00:00Z"}};
  in.trends = {{"bar-bases", Finding::Kind::order, "order of 'a' & 'b'", {2, 1.9}},
               {"bar-bases", Finding::Kind::error, "error of 'a'", {1e-3, support::not_measured}},
               {"bar-cfl", Finding::Kind::limit, "limit of 'a'", {0.8, 0.8}},
               {"weights", Finding::Kind::value, "value 'gap'", {1, 1}}};
  return in;
}

TEST(Report, OneVersionHasNoTrends) {
  const TempFolder folder;
  auto in = input_with_trends();
  in.versions.pop_back();
  EXPECT_THAT(page_of(in, folder), Not(HasSubstr("trend.html")));
  EXPECT_FALSE(fs::exists(folder / "out" / "trend.html"));
}

TEST(Report, TrendsHaveAPageOfTheirOwn) {
  const TempFolder folder;
  EXPECT_THAT(page_of(input_with_trends(), folder), HasSubstr("<a href=\"trend.html\">"));
  const auto page = content(folder / "out" / "trend.html");
  EXPECT_EQ(matches(page, "(<svg)").size(), 3u) << "orders, errors, limits; no values";
  EXPECT_THAT(page, AllOf(HasSubstr("<code>&lt;7&gt;</code>"), HasSubstr("href=\"index.html\""), Not(HasSubstr("src=")),
                          Not(HasSubstr("<link")), Not(HasSubstr("<script"))));
  const auto ids = matches(page, " id=[\"']([^\"']*)[\"']");
  const std::set<std::string> known(ids.begin(), ids.end());
  EXPECT_EQ(known.size(), ids.size());
  for (const auto& target : matches(page, "href=[\"']#([^\"']*)[\"']")) EXPECT_TRUE(known.contains(target)) << target;
  const auto files = matches(page, "href=\"(trends/[^\"]*)\"");
  EXPECT_EQ(files.size(), 12u);
  for (const auto& file : files) EXPECT_TRUE(fs::exists(folder / "out" / file)) << file;
}

TEST(Report, TrendsAreDrawnOnce) {
  const TempFolder folder;
  EXPECT_EQ(write_report(input_with_trends(), folder / "out", silent).figures_drawn, 6);
  EXPECT_EQ(write_report(input_with_trends(), folder / "out", silent).figures_drawn, 0);
}

TEST(Report, EmptyInputGivesAPage) {
  const TempFolder folder;
  const auto page = page_of({}, folder);
  EXPECT_THAT(page, AllOf(HasSubstr("not judged"), HasSubstr("No goldens were judged"), HasSubstr("</html>")));
}

std::string refusal(const ReportInput& in, const fs::path& out) {
  try {
    write_report(in, out, silent);
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Report, NamesThatLeaveTheFolderAreRefused) {
  const TempFolder folder;
  auto in = input();
  in.studies[0].figures[0].name = "../../etc";
  EXPECT_THAT(refusal(in, folder / "out"), HasSubstr("'../../etc' cannot name a file"));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(Report, FileInPlaceOfTheFolderIsReported) {
  const TempFolder folder;
  std::ofstream(folder / "out") << "x";
  EXPECT_THAT(refusal(input(), folder / "out"), HasSubstr("cannot make the folder"));
}

}  // namespace report_test
}  // namespace mpmvv::reports
