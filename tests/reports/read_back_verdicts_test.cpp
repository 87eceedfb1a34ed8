#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <regex>

#include "tests/reports/distinct.hpp"
#include "tests/reports/matches.hpp"
#include "tests/reports/written_report.hpp"

/// Goldens, claims and criteria, as a report's pages say them.
namespace mpmvv::reports::read_back_verdicts_test {

using read_back::ExpectedTable;
using read_back::WrittenReport;

/// What stands on the card of a claim.
struct Card {
  std::string verdict, text;
};

std::map<std::string, Card> cards_on(const std::string& page) {
  static const std::regex card(
      R"re(<article class="card" data-verdict="([^"]*)" data-id="([^"]*)">([\s\S]*?)</article>)re"),
      tag("<[^>]*>"), space("\\s+");
  std::map<std::string, Card> cards;
  for (std::sregex_iterator it(page.begin(), page.end(), card), end; it != end; ++it)
    cards[(*it)[2]] = {(*it)[1], std::regex_replace(std::regex_replace((*it)[3].str(), tag, " "), space, " ")};
  return cards;
}

records::ClaimPart part(records::PartVerdict verdict, std::optional<double> at_least, std::optional<double> at_most,
                        const std::vector<records::Found>& found) {
  records::ClaimPart part{"X-one", "asked of " + found[0].what, verdict, "evidence", "", "order"};
  part.at_least = at_least, part.at_most = at_most, part.found = found;
  return part;
}

TEST(ReadBackPage, VerdictsStandBesideWhatTheyAreOf) {
  ReportInput input = read_back::input_of(distinct::everything());
  input.gate = {{"all-numbers", "golden one", records::Verdict::pass, "1.1 to 1.2", "1.15", "why pass"},
                {"all-numbers", "golden two", records::Verdict::pass, "2.1 to 2.2", "2.15", "why too"}};
  store::Provenance& p = input.provenances[input.studies.at(0).name];
  p = {"d1935", "c0331", true, "GNU 12", "-O9", "Fast", "a processor", "2026-01-02"};
  ExpectedTable provenance;
  provenance.add("", {{"", "commit"}, {"", p.commit + " dirty: built from changes that are not committed"}});
  provenance.add("", {{"", "digest"}, {"", p.digest}});
  provenance.add("", {{"", "compiler"}, {"", p.compiler + ", " + p.build_type}});
  provenance.add("", {{"", "flags"}, {"", p.flags}});
  provenance.add("", {{"", "processor"}, {"", p.cpu}});
  provenance.add("", {{"", "results"}, {"", "1 study, the newest of " + p.time}});
  const WrittenReport report(input);
  report.expect_html(provenance);
  ExpectedTable gate;
  for (const GateLine& g : input.gate)
    gate.add("", {{"golden", g.name},
                  {"verdict", to_string(g.verdict)},
                  {"expected", g.expected},
                  {"measured", g.measured},
                  {"reason", g.reason}});
  report.expect_html(gate);
}

TEST(ReadBackPage, GoldensThatDoNotPassStandOnEveryPageOfTheirStudy) {
  ReportInput input = read_back::input_of(distinct::everything());
  input.gate = {{"all-numbers", "golden one", records::Verdict::pass, "1.1 to 1.2", "1.15", ""},
                {"all-numbers", "golden two", records::Verdict::fail, "2.1 to 2.2", "2.35", "why fail"}};
  ExpectedTable failing;
  failing.add("", {{"golden", "golden two"},
                   {"verdict", "fail"},
                   {"expected", "2.1 to 2.2"},
                   {"measured", "2.35"},
                   {"reason", "why fail"}});
  const WrittenReport report(input);
  for (const char* page : {"index.html", "studies/all-numbers.html"}) report.expect_html_on(page, failing);
}

TEST(ReadBackPage, GoldensWithoutReasonsHaveNoColumnForThem) {
  ReportInput input = read_back::input_of(distinct::everything());
  input.gate = {{"all-numbers", "golden one", records::Verdict::pass, "1.1 to 1.2", "1.15", ""}};
  const std::string page = WrittenReport(input).page("gate.html");
  EXPECT_THAT(page, testing::HasSubstr(">measured</th>"));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr(">reason</th>")));
}

TEST(ReadBackPage, GoldensStandBelowTheTitleOfTheirStudy) {
  ReportInput input = read_back::input_of(distinct::everything());
  input.studies[0].title = "What bars do";
  input.gate = {{"all-numbers", "golden one", records::Verdict::pass, "1.1 to 1.2", "1.15", ""}};
  EXPECT_THAT(WrittenReport(input).page("gate.html"), testing::HasSubstr("1 pass · What bars do"));
}

TEST(ReadBackPage, AnIntervalStandsBesideWhatWasFound) {
  using enum records::PartVerdict;
  ReportInput input = read_back::input_of(distinct::everything());
  records::ClaimPart asked =
      part(inconclusive, 1.8, std::nullopt, {{"order of 'a'", 1.97, 1.69, 2.25}, {"order of 'b'", 2.5, 2.4, 2.6}});
  asked.evidence = "order of 'a' = 1.97 ± 0.28 (asked: at least 1.8, but an interval reaches across)";
  input.claims = {{"X-one", "a sentence", "", "", claims::Claim::Verdict::open, "", {}, {"all-numbers"}}};
  input.claims[0].parts = {{"all-numbers", asked}};
  const std::string page = WrittenReport(input).page("claims/X-one.html");
  EXPECT_THAT(page, testing::AllOf(testing::HasSubstr(">1.97 ± 0.28<"), testing::HasSubstr(">2.5 ± 0.1<"),
                                   testing::HasSubstr("An interval reaches across a bound: order of &apos;a&apos; = "
                                                      "1.97 ± 0.28. Other points"),
                                   testing::HasSubstr("order of &apos;a&apos;: 1.97 ± 0.28 (asked: at least 1.8; "
                                                      "inconclusive)"),
                                   testing::Not(testing::HasSubstr(asked.evidence))));
}

TEST(ReadBackPage, TheFinestSegmentStandsBesideAnOrderWhoseIntervalItLeaves) {
  using enum records::PartVerdict;
  ReportInput input = read_back::input_of(distinct::everything());
  records::ClaimPart asked =
      part(holds, 1.6, std::nullopt, {{"order of 'a'", 1.88, 1.67, 2.09, "finest segment 1.42"}});
  input.claims = {{"X-one", "a sentence", "", "", claims::Claim::Verdict::open, "", {}, {}}};
  input.claims[0].parts = {{"all-numbers", asked}};
  EXPECT_THAT(WrittenReport(input).page("claims/X-one.html"),
              testing::HasSubstr(">1.88 ± 0.21 <span class=\"soft remark\">finest segment 1.42</span><"));
}

TEST(ReadBackPage, WhatIsMissingStandsBesideANumberThatFails) {
  using enum records::PartVerdict;
  ReportInput input = read_back::input_of(distinct::everything());
  input.claims = {{"X-one", "a sentence", "", "", claims::Claim::Verdict::refuted, "", {}, {}}};
  input.claims[0].parts = {{"all-numbers", part(fails, 1.8, std::nullopt,
                                                {{"order of 'a'", 1.5}, {"'b' failed at cells = 32", std::nan("")}})}};
  EXPECT_THAT(WrittenReport(input).page("claims/X-one.html"),
              testing::AllOf(testing::HasSubstr("&apos;b&apos; failed at cells = 32"),
                             testing::HasSubstr("order of &apos;a&apos;: 1.5 (asked: at least 1.8")));
}

TEST(ReadBackPage, BracketsAndRangesOfTimesAreLinesOnTheBand) {
  using enum records::PartVerdict;
  ReportInput input = read_back::input_of(distinct::everything());
  records::ClaimPart limit =
      part(inconclusive, std::nullopt, 0.439, {{"cfl limit of 'a' between 0.4375 and 0.4401", 0.4388, 0.4375, 0.4401}});
  limit.measure = "limit";
  records::ClaimPart cost =
      part(inconclusive, std::nullopt, 0.6, {{"cost of 'a' over 'b' at l2 1e-02", 0.5, 0.3, 0.7}});
  cost.measure = "cost-ratio";
  input.claims = {{"X-one", "a sentence", "", "", claims::Claim::Verdict::open, "", {}, {}}};
  input.claims[0].parts = {
      {"all-numbers", limit}, {"all-numbers", cost}, {"all-numbers", part(holds, 1, 3, {{"c", 2}})}};
  EXPECT_EQ(matches(WrittenReport(input).page("claims/X-one.html"), "(class=\"reach\")").size(), 2u);
}

TEST(ReadBackPage, RowsOfACriterionSayOnceWhatTheyCompare) {
  using enum records::PartVerdict;
  ReportInput input = read_back::input_of(distinct::everything());
  input.claims = {{"X-one", "a sentence", "", "", claims::Claim::Verdict::confirmed, "", {}, {}}};
  input.claims[0].parts = {{"all-numbers", part(holds, 1, 3,
                                                {{"l2 of 'a' at cells = 8", 1.5},
                                                 {"l2 of 'a' at cells = 16", 1.6},
                                                 {"l2 of 'b' at cells = 16", 1.7},
                                                 {"l2 of 'b' at rest", 1.8}})}};
  const std::string page = WrittenReport(input).page("claims/X-one.html");
  for (const char* what : {"l2 of &apos;a&apos; at cells = 8", "at cells = 16", "l2 of &apos;b&apos; at cells = 16",
                           "l2 of &apos;b&apos; at rest"})
    EXPECT_THAT(page, testing::HasSubstr(std::string("<tr><td>") + what + "</td>"));
}

TEST(ReadBackPage, AClaimWithoutAFigureShowsItsCriteria) {
  using enum records::PartVerdict;
  ReportInput input = read_back::input_of(distinct::everything());
  input.claims = {{"X-one", "a sentence", "", "", claims::Claim::Verdict::partly, "", {}, {}}};
  input.claims[0].parts = {{"elsewhere", part(holds, 1, 2, {{"first", 1.5}})},
                           {"elsewhere", part(fails, 1, 2, {{"second", 2.5}})}};
  const std::string page = WrittenReport(input).page("index.html");
  EXPECT_THAT(page, testing::HasSubstr("<span class=\"mark fails\">fails</span>: asked of second"));
  input.claims[0].parts.resize(1);
  const auto said_of = [&input](records::PartVerdict verdict) {
    input.claims[0].parts[0].part.verdict = verdict;
    return WrittenReport(input).page("index.html");
  };
  EXPECT_THAT(said_of(holds), testing::HasSubstr("X-one · its criterion holds"));
  EXPECT_THAT(said_of(fails), testing::HasSubstr("X-one · its criterion does not hold"));
  EXPECT_THAT(said_of(inconclusive), testing::HasSubstr("X-one · its criterion is inconclusive"));
}

TEST(ReadBackPage, ClaimsOfWhichAPartFailsStandApartFromThoseThatAreUndecided) {
  using enum records::PartVerdict;
  ReportInput input = read_back::input_of(distinct::everything());
  input.claims = {{"X-one", "a sentence", "", "", claims::Claim::Verdict::partly, "", {}, {}}};
  input.claims[0].parts = {{"elsewhere", part(holds, 1, 2, {{"first", 1.5}})},
                           {"elsewhere", part(fails, 1, 2, {{"second", 2.5}})}};
  input.claims.push_back(input.claims[0]);
  input.claims[1].parts[1].part.verdict = inconclusive;
  const std::string page = WrittenReport(input).page("index.html");
  EXPECT_THAT(page, testing::HasSubstr("<summary>Claims that hold in part, the rest fails: 1</summary>"));
  EXPECT_THAT(page, testing::HasSubstr("<summary>Claims that hold in part, the rest is undecided: 1</summary>"));
}

TEST(ReadBackPage, CriteriaHaveWhatWasAskedBesideWhatWasFound) {
  using enum records::PartVerdict;
  ReportInput input = read_back::input_of(distinct::everything());
  input.studies[0].parts = {part(holds, 1.75, 2.25, {{"first", 1.972}, {"second", 2.004}}),
                            part(fails, std::nullopt, 0.8, {{"third", 0.91}, {"fourth", 1.33}}),
                            part(inconclusive, 3, std::nullopt, {{"fifth", 2.7}})};
  input.studies[0].parts[1].reason = "why it fails";
  claims::Claim claim{"X-one", "a sentence", "A paper",      "Fig. 7", claims::Claim::Verdict::partly,
                      "",      {},           {"all-numbers"}};
  for (const auto& each : input.studies[0].parts) claim.parts.push_back({"all-numbers", each});
  input.claims = {claim};
  const WrittenReport report(input);
  ExpectedTable criteria;
  const auto add = [&](const std::string& group, const char* what, const char* asked, const char* found) {
    criteria.add(group, {{"what was compared", what}, {"asked", asked}, {"found", found}, {"on the band", ""}});
  };
  add("asked of first holds (all-numbers)", "first", "1.75 to 2.25", "1.972");
  add("asked of first holds (all-numbers)", "second", "1.75 to 2.25", "2.004");
  add("asked of third fails (all-numbers)  Reason: why it fails", "third", "at most 0.8", "0.91");
  add("asked of third fails (all-numbers)  Reason: why it fails", "fourth", "at most 0.8", "1.33");
  add("asked of fifth inconclusive (all-numbers)  evidence", "fifth", "at least 3", "2.7");
  report.expect_html(criteria);
  EXPECT_THAT(report.page("studies/all-numbers.html"),
              testing::HasSubstr("<span class=\"badge fails\">fails</span> asked of third"));
  const auto cards = cards_on(report.page("index.html"));
  ASSERT_EQ(cards.size(), 1u);
  EXPECT_EQ(cards.at("X-one").verdict, "partly");
  EXPECT_THAT(cards.at("X-one").text,
              testing::AllOf(testing::HasSubstr("a sentence"), testing::HasSubstr("fourth: 1.33 (asked: at most 0.8)"),
                             testing::HasSubstr("X-one, Fig. 7 · 1 of 3 criteria hold, 1 inconclusive")));
}

}  // namespace mpmvv::reports::read_back_verdicts_test
