#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "reports/report.hpp"
#include "tests/reports/matches.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

/// Every page of a report: where its links lead, what it takes from elsewhere.
namespace mpmvv::reports::links_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A report with every kind of page.
std::map<std::string, std::string> pages_of_everything(const fs::path& out) {
  ReportInput in;
  in.studies = {synthetic::convergence(), synthetic::limits(), synthetic::check()};
  in.gate = {{"bar-bases", "order", records::Verdict::fail, "1", "2", "why"},
             {"elsewhere", "order", records::Verdict::inconclusive, "1", "", "no"}};
  in.claims = {synthetic::claim("a claim"), {"S-fig 9", "another", "", "", claims::Claim::Verdict::open, "", {}, {}}};
  in.benchmark = Benchmark{"", "", {{"skip/x/paid", "", {}}}};
  in.mutation.emplace();
  in.histories = {{"",
                   {{"00ff", {"8be1f2c0"}, "2026-01-01"}, {"11aa", {"9cd"}, "2026-01-02"}},
                   {{"bar-bases", claims::Finding::Kind::order, "order of 'a'", {2, 1.9}}}}};
  write_report(in, out, [](const std::string&) {});
  std::map<std::string, std::string> pages;
  for (const auto& entry : fs::recursive_directory_iterator(out))
    if (entry.path().extension() == ".html")
      pages[entry.path().lexically_relative(out).string()] = content(entry.path());
  return pages;
}

std::set<std::string> ids_of(const std::string& page) {
  const auto all = matches(page, " id=\"([^\"]*)\"");
  const std::set<std::string> ids(all.begin(), all.end());
  EXPECT_EQ(ids.size(), all.size());
  return ids;
}

TEST(Links, LeadToFilesAndPlacesThatAreThere) {
  const TempFolder folder;
  const auto pages = pages_of_everything(folder / "out");
  EXPECT_EQ(pages.size(), 10u);
  std::set<std::string> reached{"index.html"};
  for (const auto& [file, text] : pages) {
    SCOPED_TRACE(file);
    for (const std::string& link : matches(text, " (?:href|src)=\"([^\"]*)\"")) {
      const std::string path = link.substr(0, link.find('#'));
      const std::string target =
          path.empty() ? file : (fs::path(file).parent_path() / path).lexically_normal().string();
      EXPECT_FALSE(target.starts_with("..")) << link << " leads out of the report";
      EXPECT_TRUE(fs::is_regular_file(folder / "out" / target)) << link;
      reached.insert(target);
      if (link.find('#') == std::string::npos || !pages.contains(target)) continue;
      EXPECT_TRUE(ids_of(pages.at(target)).contains(link.substr(link.find('#') + 1))) << link;
    }
  }
  for (const auto& [file, text] : pages) EXPECT_TRUE(reached.contains(file)) << "nothing leads to " << file;
}

TEST(Links, WithoutClaimsNoneLeadsToThem) {
  const TempFolder folder;
  ReportInput in;
  in.studies = {synthetic::check()};
  in.studies[0].claims.clear();
  write_report(in, folder / "out", [](const std::string&) {});
  const std::string page = content(folder / "out/index.html");
  EXPECT_THAT(page, Not(HasSubstr("#claims\"")));
  EXPECT_THAT(
      page, testing::AllOf(HasSubstr("<img src=\"figures/s-fig4.svg\""), HasSubstr("<a href=\"studies/weights.html\">"),
                           HasSubstr("<p>partition_of_unity = 2.2e-16</p>")));
}

TEST(Links, NothingComesFromElsewhere) {
  const TempFolder folder;
  for (const auto& [file, text] : pages_of_everything(folder / "out"))
    for (const char* foreign : {"http:", "https:", "//", "@import"})
      EXPECT_THAT(std::regex_replace(text, std::regex("<pre.*?</pre>|<code>[^<]*</code>"), ""), Not(HasSubstr(foreign)))
          << file;
  for (const char* aid : {"style.css", "report.js"})
    EXPECT_THAT(content(folder / "out" / aid), testing::AllOf(Not(HasSubstr("http")), Not(HasSubstr("@import"))))
        << aid;
}

TEST(Links, EveryPictureSaysWhatItShows) {
  const TempFolder folder;
  const auto pages = pages_of_everything(folder / "out");
  const auto texts = matches(pages.at("studies/bar-bases.html"), "<img[^>]* alt=\"([^\"]*)\"");
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_THAT(texts[0], testing::StartsWith("RMS error δ / m (logarithmic) against cells N (logarithmic)."));
  EXPECT_THAT(texts[0], HasSubstr("bspline2, 4 PPC   2.01 ± 0.03: from 0.004591 at 8 to 1.075e-06 at 512."));
  EXPECT_THAT(texts[0], HasSubstr("unstable at 2 of 7 points"));
}

}  // namespace mpmvv::reports::links_test
