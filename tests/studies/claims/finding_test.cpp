#include "studies/claims/finding.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "studies/claims/trend.hpp"

namespace mpmvv::claims::finding_test {

using records::StudyResult;

using testing::ElementsAre;
using testing::NanSensitiveDoubleEq;

StudyResult sample() {
  records::Series a{"a",
                    {{8, records::Status::ok, "", {{"l2", 4e-4}, {"linf", 1}, {"kinetic", 5}}},
                     {16, records::Status::ok, "", {{"l2", 1e-4}, {"linf", 1}, {"kinetic", 5}}},
                     {32, records::Status::unstable, "", {}}},
                    {},
                    fits::StabilityLimit{}};
  a.orders.resize(1);
  a.orders[0].norm = "l2";
  a.orders[0].from = 8;
  a.orders[0].to = 16;
  a.orders[0].order = 2;
  a.limit->key = "cfl";
  a.limit->stable = 0.8;
  a.limit->unstable = 0.82;
  a.limit->found = true;
  StudyResult study;
  study.name = "s";
  study.sweep = "cells";
  study.series = {a};
  study.values = {{"gap", 3, ""}};
  return study;
}

Finding found(const StudyResult& study, const std::string& name) {
  const auto findings = findings_of(study);
  const auto it = std::ranges::find(findings, name, &Finding::name);
  return it == findings.end() ? Finding{} : *it;
}

TEST(Findings, OfEveryKind) {
  const StudyResult study = sample();
  EXPECT_EQ(found(study, "order of 'a' in l2 over [8, 16]").number, 2);
  EXPECT_EQ(found(study, "error of 'a' in l2").number, 1e-4) << "at the finest level with a result";
  EXPECT_EQ(found(study, "error of 'a' in l2").levels.size(), 2U);
  EXPECT_DOUBLE_EQ(found(study, "cfl limit of 'a'").number, 0.81);
  EXPECT_EQ(found(study, "cfl limit of 'a'").better, 1);
  EXPECT_EQ(found(study, "status of 'a' at 32").word, "unstable");
  EXPECT_EQ(found(study, "value 'gap'").number, 3);
  EXPECT_EQ(findings_of(study).size(), 7U) << "linf is neither fitted nor drawn, the energy is no error";
}

TEST(Findings, ALimitThatWasNotFoundSaysWhatWasSeen) {
  StudyResult study = sample();
  const auto limit = [&](const std::vector<fits::Probe>& probes, double stable, double unstable) {
    fits::StabilityLimit unfound;
    unfound.key = "cfl", unfound.probes = probes, unfound.stable = stable, unfound.unstable = unstable;
    study.series[0].limit = unfound;
    return found(study, "cfl limit of 'a'");
  };
  const Finding calm = limit({{0.5, true, ""}, {1, true, ""}}, 1, not_measured);
  EXPECT_EQ(text(calm), "stable at all values tried, up to 1");
  EXPECT_EQ(calm.side, 1);
  const Finding wild = limit({{0.5, false, ""}, {1, false, ""}}, not_measured, 0.5);
  EXPECT_EQ(text(wild), "unstable at all values tried, down to 0.5");
  EXPECT_EQ(wild.side, -1);
  EXPECT_EQ(limit({{0.5, false, ""}, {1, true, ""}}, not_measured, 0.5).side, 0);
  EXPECT_EQ(limit({}, not_measured, not_measured).side, 0);
  EXPECT_EQ(found(sample(), "cfl limit of 'a'").side, 0);
}

TEST(Findings, ALimitSaysThatItIsNotMonotone) {
  StudyResult study = sample();
  EXPECT_EQ(text(found(study, "cfl limit of 'a'")), "0.81");
  study.series[0].limit->monotone = false;
  EXPECT_EQ(text(found(study, "cfl limit of 'a'")), "0.81, not monotone");
}

TEST(Findings, CostOnlyWhereItIsEvidence) {
  StudyResult study = sample();
  study.series[0].points[0].y["ns_per_particle_step"] = 20;
  EXPECT_EQ(found(study, "ns per particle and step of 'a'").name, "");
  study.series[0].points[0].y["step_seconds"] = 1;
  EXPECT_EQ(found(study, "ns per particle and step of 'a'").number, 20);
}

TEST(Findings, ACheckHasCurvesInsteadOfErrors) {
  StudyResult study = sample();
  study.kind = records::StudyKind::check;
  study.figures.resize(1);
  study.figures[0].quantity = "linf";
  EXPECT_EQ(text(found(study, "curve 'a' of linf")), "curve");
  EXPECT_EQ(found(study, "status of 'a' at 32").name, "");
}

TEST(Trends, HaveTheUnitOfWhatTheyShow) {
  StudyResult study;
  study.name = "s", study.sweep = "cells";
  records::Series series{"b' in c of 'd", {{8, records::Status::ok, "", {{"stress_error", 2}}}}, {}, {}};
  series.orders.resize(1);
  series.orders[0].norm = "stress_error", series.orders[0].order = 1;
  series.extrapolations.resize(1);
  series.extrapolations[0].norm = "l2", series.extrapolations[0].limit = 1;
  series.limit.emplace();
  series.limit->key = "cfl";
  study.series = {series};
  study.values = {{"gap", 1, ""}};
  std::map<std::string, std::string> quantities;
  for (const Trend& trend : trends_of({findings_of(study)})) quantities[label_with_unit(trend)] = trend.quantity;
  const std::map<std::string, std::string> expected{
      {"order of 'b' in c of 'd' in stress_error over [0, 0]", ""},
      {"error of 'b' in c of 'd' in stress_error (Pa) at 8", "stress_error"},
      {"extrapolated l2 of 'b' in c of 'd' over [0, 0] (m)", "l2"},
      {"cfl limit of 'b' in c of 'd'", "cfl"},
      {"value 'gap'", ""}};
  EXPECT_EQ(quantities, expected);
}

TEST(Findings, AnExtrapolatedValueHasItsUncertainty) {
  StudyResult study = sample();
  study.series[0].extrapolations = {
      {"kinetic", 8, 64, 4, "φ0 + α h", 1, 0.25, 0, 0.3, 0.0625, support::not_measured},
      {"kinetic", 32, 64, 2, "none: 2 usable points in the window (4 needed)", support::not_measured}};
  const Finding finding = found(study, "extrapolated kinetic of 'a' over [8, 64]");
  EXPECT_EQ(finding.kind, Finding::Kind::value);
  EXPECT_EQ(text(finding), "0.25 (the finest value's ± 0.062)");
  EXPECT_EQ(text(found(study, "extrapolated kinetic of 'a' over [32, 64]")), "not measured");
  EXPECT_EQ(trends_of({findings_of(study)}).size(), 5U) << "order, error, limit, a value, an extrapolated one";
}

TEST(Findings, AStudyWithoutAClaimGivesNoVerdict) {
  StudyResult study = sample();
  EXPECT_EQ(findings_of(std::vector{study}).size(), findings_of(study).size());
  study.claims = {"S-fig10"};
  study.parts = {{"S-fig10", "", records::PartVerdict::holds, "", ""}};
  EXPECT_EQ(findings_of(std::vector{study}).back().word, "confirmed");
}

TEST(Findings, OfAllStudiesHaveTheVerdictOnEachCriterion) {
  StudyResult study = sample();
  study.claims = {"S-fig10"};
  study.parts = {{"S-fig10", "second order", records::PartVerdict::fails, "", ""},
                 {"S-fig10", "as the figure shows", records::PartVerdict::shown, "", ""}};
  const auto all = findings_of(std::vector{study});
  EXPECT_EQ(all.size(), findings_of(study).size() + 2) << "one criterion, one claim";
  const auto criterion = std::ranges::find(all, "criterion of S-fig10: second order", &Finding::name);
  ASSERT_NE(criterion, all.end());
  EXPECT_EQ(criterion->study, "s");
  EXPECT_EQ(criterion->kind, Finding::Kind::verdict);
  EXPECT_EQ(text(*criterion), "fails");
  EXPECT_EQ(trends_of({all}).size(), trends_of({findings_of(study)}).size()) << "trends are of numbers and limits";
}

TEST(Trends, HaveANumberPerVersion) {
  StudyResult first = sample(), last = sample();
  last.series[0].orders[0].order = 1.9;
  last.values.push_back({"late", 1, ""});
  const auto trends = trends_of({findings_of(first), {}, findings_of(last)});
  ASSERT_EQ(trends.size(), 5U) << "order, error, limit, two values; no statuses";
  EXPECT_THAT(trends[0].numbers, ElementsAre(2, NanSensitiveDoubleEq(NAN), 1.9));
  EXPECT_EQ(trends.back().name, "value 'late'");
  EXPECT_THAT(trends.back().numbers, ElementsAre(NanSensitiveDoubleEq(NAN), NanSensitiveDoubleEq(NAN), 1));
}

TEST(Trends, ALimitThatIsLostHasAShortRemark) {
  StudyResult lost = sample();
  lost.series[0].limit->found = false;
  lost.series[0].limit->probes = {{0.5, false, ""}, {1, false, ""}};
  const auto trends = trends_of({findings_of(sample()), findings_of(lost)});
  const auto limit = std::ranges::find(trends, "cfl limit of 'a'", &Trend::name);
  ASSERT_NE(limit, trends.end());
  EXPECT_THAT(limit->remarks, ElementsAre("", "all unstable"));
}

TEST(Trends, ALimitThatNoVersionFoundHasALineThatSaysWhy) {
  const auto unfound = [](bool low, bool high) {
    StudyResult study = sample();
    study.series[0].limit->found = false;
    study.series[0].limit->probes = {{0.5, low, ""}, {1, high, ""}};
    return findings_of(study);
  };
  const auto trends = trends_of({unfound(true, true), unfound(false, false), unfound(false, true), {}});
  const auto limit = std::ranges::find(trends, "cfl limit of 'a'", &Trend::name);
  ASSERT_NE(limit, trends.end());
  EXPECT_THAT(limit->remarks, ElementsAre("all stable", "all unstable", "not found", ""));
  EXPECT_THAT(limit->numbers, testing::Each(NanSensitiveDoubleEq(NAN)));
}

TEST(Trends, AnErrorIsOfOneLevelInAllVersions) {
  StudyResult coarse = sample(), fine = sample();
  fine.series[0].points[2] = {32, records::Status::ok, "", {{"l2", 2e-5}}};
  fine.series[0].points[1].status = records::Status::failed;
  const auto trends = trends_of({findings_of(coarse), findings_of(fine)});
  ASSERT_GE(trends.size(), 3U);
  EXPECT_EQ(label(trends[0]), "order of 'a' in l2 over [8, 16]");
  EXPECT_THAT(trends[0].remarks, ElementsAre("", "failed")) << "a run of its window";
  EXPECT_EQ(label(trends[1]), "error of 'a' in l2 at 16");
  EXPECT_THAT(trends[1].numbers, ElementsAre(1e-4, NanSensitiveDoubleEq(NAN)));
  EXPECT_THAT(trends[1].remarks, ElementsAre("", "failed"));
  const auto at_32 = std::ranges::find(trends, "error of 'a' in l2 at 32", label);
  ASSERT_NE(at_32, trends.end());
  EXPECT_THAT(at_32->numbers, ElementsAre(NanSensitiveDoubleEq(NAN), 2e-5));
  EXPECT_THAT(at_32->remarks, ElementsAre("unstable", ""));
}

}  // namespace mpmvv::claims::finding_test
