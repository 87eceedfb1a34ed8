#include "reports/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"
#include "tests/reports/matches.hpp"
#include "tests/reports/report_pages.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports::report_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

using namespace report_pages;

TEST(Report, WritesPagesFiguresAndTables) {
  const TempFolder folder;
  std::vector<std::string> told;
  const auto summary = write_report(input(), folder / "out", [&](const std::string& line) { told.push_back(line); });
  EXPECT_EQ(summary.figures, 3);
  EXPECT_EQ(summary.figures_drawn, 3);
  EXPECT_EQ(summary.tables, summary.tables_written);
  for (const char* file :
       {"index.html", "gate.html", "studies/bar-bases.html", "studies/bar-cfl.html", "claims/S-fig10.html", "style.css",
        "report.js", "figures/s-fig10.gp", "figures/s-fig10.dat", "figures/s-fig10.svg", "figures/s-fig10.pdf",
        "tables/bar-bases.csv", "tables/bar-bases.tex", "tables/fits/bar-bases.csv", "tables/bar-cfl.tex"})
    EXPECT_TRUE(fs::exists(folder / "out" / file)) << file;
  EXPECT_THAT(told, testing::Contains("figures: 3 of 3 redrawn"));
}

TEST(Report, PlantedMistakesHaveAPageOfTheirOwn) {
  const TempFolder folder;
  ReportInput in = input();
  EXPECT_THAT(page_of(in, folder), Not(HasSubstr("mutants.html")));
  in.mutation.emplace();
  in.mutation->digest = in.digest;
  in.mutation->mistakes = {{.name = "a <sign>"}};
  EXPECT_THAT(page_of(in, folder, "mutants.html"), HasSubstr("a &lt;sign&gt;"));
  EXPECT_THAT(page_of(in, folder), HasSubstr("<a href=\"mutants.html\">"));
  EXPECT_TRUE(fs::exists(folder / "out/tables/program/mutants.tex"));
  EXPECT_THAT(page_of(in, folder, "mutants.html"), Not(HasSubstr("were tried with another version")));
  in.mutation->digest = "other";
  in.mutation->commit = "c0ffee0123456789-dirty";
  EXPECT_THAT(page_of(in, folder, "mutants.html"),
              HasSubstr("another version of the program than this report’s: c0ffee012345-dirty."));
}

TEST(Report, ASummaryOfPlantedMistakesSaysWhereTheyStand) {
  const TempFolder folder;
  ReportInput in = input();
  in.mutation.emplace();
  in.mutation->digest = in.digest;
  in.mutation->commit = "c0ffee0123456789 with changes";
  in.mutation->planted = {.should_show = 2, .unit_tests = 2, .caught = 2};
  const std::string page = page_of(in, folder, "mutants.html");
  EXPECT_THAT(page, HasSubstr("<code>tests/mutation/planted.toml</code>"));
  EXPECT_THAT(page, HasSubstr("with the tests and goldens of commit c0ffee012345"));
  EXPECT_THAT(page, HasSubstr("2 of 2 (100 %)"));
  EXPECT_THAT(page, Not(HasSubstr("explained"))) << "nothing random was tried";
}

TEST(Report, SecondCallWritesNothing) {
  const TempFolder folder;
  write_report(input(), folder / "out", silent);
  std::map<std::string, fs::file_time_type> before;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "out"))
    if (entry.is_regular_file()) before[entry.path().string()] = entry.last_write_time();
  const auto summary = write_report(input(), folder / "out", silent);
  EXPECT_EQ(summary.figures_drawn, 0);
  EXPECT_EQ(summary.tables_written, 0);
  EXPECT_GT(before.size(), 20u);
  for (const auto& [file, time] : before) EXPECT_EQ(fs::last_write_time(file), time) << file;
}

TEST(Report, TextIsEscaped) {
  const TempFolder folder;
  EXPECT_THAT(page_of(input(), folder),
              AllOf(HasSubstr("order 2.01 &amp; &lt;script&gt;"), HasSubstr("not &lt;found&gt;"),
                    HasSubstr("Bar: order of the bases &lt;S &amp; W&gt;")));
  EXPECT_THAT(content(folder / "out/studies/bar-bases.html"),
              AllOf(HasSubstr("&lt;b&gt;at&lt;/b&gt;"), HasSubstr("# a &lt; b"), Not(HasSubstr("<b>at"))));
  EXPECT_THAT(content(folder / "out/claims/S-fig10.html"), HasSubstr("order 2.01 &amp; &lt;script&gt;"));
}

TEST(Report, VerdictAndProvenanceStandOnTheFirstPage) {
  const TempFolder folder;
  auto in = input();
  auto page = page_of(in, folder);
  EXPECT_THAT(page.substr(0, page.find("id=\"open\"")),
              AllOf(HasSubstr("tile inconclusive"), HasSubstr("1 inconclusive, 1 pass"), HasSubstr("1 of 2"),
                    HasSubstr("1 confirmed, 1 open"), HasSubstr("version 8be1f2c-dirty</span>")));
  EXPECT_THAT(page, HasSubstr("dirty: built from"));
  for (auto& [study, provenance] : in.provenances) provenance.dirty = false;
  in.gate[0].verdict = records::Verdict::fail;
  page = page_of(in, folder);
  EXPECT_THAT(page, AllOf(HasSubstr("<title>mpmvv: fail</title>"), Not(HasSubstr("dirty: built from")),
                          HasSubstr("version 8be1f2c</span>")));
}

TEST(Report, SaysOfEveryStudyWhereItComesFrom) {
  const TempFolder folder;
  auto in = input();
  store::Provenance& newest = in.provenances.at("weights");
  newest.commit = "77aa001", newest.dirty = false, newest.cpu = "another CPU", newest.time = "2026-01-01T12:00:00Z";
  const auto page = page_of(in, folder);
  EXPECT_THAT(page, AllOf(HasSubstr("of 3 studies, version 77aa001, 8be1f2c-dirty</span>"),
                          HasSubstr("<footer>mpmvv 77aa001, 8be1f2c-dirty</footer>")));
  const auto other = page.find("<td>another CPU</td>"), older = page.find("<td>CPU</td>");
  ASSERT_NE(older, std::string::npos);
  EXPECT_LT(other, older) << "the newest first";
  EXPECT_THAT(page.substr(other, older - other),
              AllOf(HasSubstr("1 study, the newest of <time>2026-01-01T12:00:00Z<"), HasSubstr("dirty: built from")));
  EXPECT_THAT(page.substr(older), HasSubstr("2 studies, the newest of <time>2026-01-01T00:00:00Z<"));
}

TEST(Report, CountsClaimsOfPapersAndOurOwnApart) {
  const TempFolder folder;
  auto in = input();
  claims::Claim own = in.claims[0];
  own.id = "X-order", own.source = "mpmvv";
  in.claims.push_back(own);
  EXPECT_THAT(page_of(in, folder),
              AllOf(HasSubstr("<strong>1 of 2</strong>"),
                    HasSubstr("claims of the papers are confirmed, 1 of 1 of our own; all together: "
                              "2 confirmed, 1 open</span>")));
}

TEST(Report, SaysWhichGoldensHaveAnotherVerdict) {
  const TempFolder folder;
  auto in = input();
  in.earlier.emplace();
  const std::string counts = "1 inconclusive, 1 pass</span> <span class=\"change\">Since the version before: ";
  EXPECT_THAT(page_of(in, folder), HasSubstr(counts + "not comparable, as no study with goldens is in both</span>"));
  in.earlier->goldens_compared = 2;
  EXPECT_THAT(page_of(in, folder), HasSubstr(counts + "as before</span>"));
  in.earlier->goldens_compared = 1;
  EXPECT_THAT(page_of(in, folder), HasSubstr(counts + "as before (1 of 2 compared)</span>"));
  in.earlier->goldens_compared = 2;
  in.earlier->gate_change = {{{records::Verdict::pass, records::Verdict::inconclusive}, 1},
                             {{records::Verdict::fail, records::Verdict::pass}, 1}};
  EXPECT_THAT(page_of(in, folder), HasSubstr(counts + "1 inconclusive, was pass; 1 pass, was fail</span>"));
}

TEST(Report, SaysNoChangeWhereNothingIsJudged) {
  const TempFolder folder;
  auto in = input();
  in.earlier.emplace();
  in.gate.clear(), in.claims.clear();
  EXPECT_THAT(page_of(in, folder), AllOf(HasSubstr("no golden of these studies</span></a>"),
                                         HasSubstr("no study names a claim</span></a>")));
}

void set_cost(records::Series& series, double cost) {
  auto& y = series.points.back().y;
  y["step_seconds"] = 1, y["ns_per_particle_step"] = cost;
}

TEST(Report, TheCostIsTheMedianOfAnEvenNumberToo) {
  const TempFolder folder;
  auto in = input();
  set_cost(in.studies[0].series[0], 10), set_cost(in.studies[0].series[1], 30);
  EXPECT_THAT(page_of(in, folder),
              AllOf(HasSubstr("<strong>20.0 ns</strong>"), HasSubstr("median of 2 timed series, 10.0 to 30.0 ns")));
}

/// Costs of two nights: a range, of which the outer quarters are left out.
TEST(Report, TheCostHasChangedByARange) {
  const TempFolder folder;
  auto in = input();
  set_cost(in.studies[0].series[0], 10);
  in.earlier.emplace();
  EXPECT_THAT(page_of(in, folder), Not(HasSubstr("times what it was")));
  in.earlier->cost_ratios = {1.2, 0.9};
  EXPECT_THAT(page_of(in, folder), HasSubstr("Since the version before: 0.90 to 1.20 times what it was (2 series; "
                                             "another night alone makes up to 1.3)</span>"));
  in.earlier->cost_ratios = {9, 0.97, 1.12, 1.04, 0.1};
  EXPECT_THAT(page_of(in, folder), HasSubstr(": 0.97 to 1.12 times what it was (middle half of 5 series; "));
}

TEST(Report, TheCostIsNeitherThatOfOtherCodesNorOfTrials) {
  const TempFolder folder;
  auto in = input();
  auto& series = in.studies[0].series;
  for (std::size_t k = 0; k < 3; ++k) set_cost(series[k], 10 + 20 * static_cast<double>(k));
  series[2].code = records::OtherCode{"my-code", "1.3", "", ""};
  records::StudyResult trial = in.studies[0];
  trial.name = "tried", trial.text = store::with_trial(trial.text, "ppc = 4 in 5 of 5 series");
  in.studies.push_back(trial);
  EXPECT_THAT(page_of(in, folder),
              AllOf(HasSubstr("<strong>20.0 ns</strong>"), HasSubstr("median of 2 timed series, 10.0 to 30.0 ns")));
}

TEST(Report, GoldensAreSortedByTheWorstVerdictAndHowManyHaveIt) {
  const TempFolder folder;
  auto in = input();
  for (const records::Verdict verdict : {records::Verdict::fail, records::Verdict::fail, records::Verdict::pass})
    in.gate.push_back({"bar-bases", "one more", verdict, "1", "2", ""});
  EXPECT_THAT(page_of(in, folder), AllOf(HasSubstr("data-key=\"fail 2\""), HasSubstr("data-key=\"inconclusive 1\""),
                                         HasSubstr("data-key=\"not judged 0\"")));
}

TEST(Report, GoldensOfValuesSayWhatTheseMean) {
  const TempFolder folder;
  auto in = input();
  in.gate.push_back({"weights", "value 'partition_of_unity'", records::Verdict::fail, "at most 1e-16", "2.2e-16", ""});
  const std::string golden = "partition_of_unity&apos;<br/><span class=\"soft\">largest |ΣN - 1|</span></th>";
  EXPECT_THAT(page_of(in, folder, "gate.html"), HasSubstr(golden));
  EXPECT_THAT(content(folder / "out/index.html"), HasSubstr(golden));
  EXPECT_THAT(content(folder / "out/gate.html"), HasSubstr("<th scope=\"row\">limit</th>"));
}

TEST(Report, WordsHaveThoseOfVerdictsAndReasons) {
  const TempFolder folder;
  EXPECT_THAT(page_of(input(), folder), AllOf(HasSubstr("<dt>awaited</dt>"), HasSubstr("<dt>rule of widths</dt>")));
}

TEST(Report, WordsSayThatAQuarterMayBeAllThatACaseAsksFor) {
  const TempFolder folder;
  EXPECT_THAT(page_of(input(), folder),
              HasSubstr("make the body that the case asks for (with <code>quarter</code>, the quarter)"));
}

TEST(Report, LettersOfNamesAreExplainedWhereShippedStudiesAreShown) {
  const TempFolder folder;
  ReportInput in = input();
  in.calls["bar-bases"] = {"bar-bases.toml"};
  EXPECT_THAT(page_of(in, folder), testing::Not(HasSubstr("begins with s (Steffen")));
  in.calls["bar-bases"] = {"bar-bases"};
  EXPECT_THAT(page_of(in, folder), HasSubstr("begins with s (Steffen"));
}

TEST(Report, SaysNoMoreThanTheGateWhereGoldensHaveNoResult) {
  const TempFolder folder;
  auto in = input();
  in.gate = {in.gate[0],
             {"not-run", "order", records::Verdict::inconclusive, "1 to 2", "", "no study 'not-run' in the store"}};
  EXPECT_THAT(page_of(in, folder),
              AllOf(HasSubstr("<title>mpmvv: pass, 1 without a result</title>"), HasSubstr("tile inconclusive"),
                    HasSubstr("Every golden that has a result holds")));
  EXPECT_THAT(content(folder / "out/gate.html"),
              HasSubstr("<span class=\"badge inconclusive\">pass, 1 without a result</span>"));
  in.gate.pop_back();
  EXPECT_THAT(page_of(in, folder), AllOf(HasSubstr("<title>mpmvv: pass</title>"), HasSubstr("Every golden holds")));
}

TEST(Report, ClaimsLeadToTheirStudiesAndBack) {
  const TempFolder folder;
  EXPECT_THAT(page_of(input(), folder, "claims/S-fig10.html"), HasSubstr("<a href=\"../studies/bar-bases.html\">"));
  EXPECT_THAT(content(folder / "out/studies/bar-bases.html"), HasSubstr("<a href=\"../claims/S-fig10.html\">"));
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

}  // namespace mpmvv::reports::report_test
