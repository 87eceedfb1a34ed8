#include "goldens/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mpmvv::goldens::comparison_test {

using claims::Finding;

using Kind = Finding::Kind;
using testing::ElementsAre;
using testing::IsEmpty;

Finding number(Kind kind, const std::string& name, double value, int better = 0) {
  return {"s", kind, name, value, "", better, {}};
}
Finding word(const std::string& name, const std::string& text) {
  return {"s", Kind::status, name, support::not_measured, text, 0, {}};
}
Finding error(const std::vector<Finding::Level>& levels) {
  return {"s", Kind::error, "error", levels.back().y, "", -1, levels};
}

Finding curve(const std::vector<Finding::Level>& levels) {
  return {"s", Kind::error, "curve", support::not_measured, "curve", 0, levels};
}

double bands(const Finding& before, const Finding& after) {
  return compare({before}, {after}).changes.at(0).bands;
}

TEST(Compare, AVersionWithItselfShowsNothing) {
  const std::vector<Finding> findings{number(Kind::order, "o", 2, 1), word("w", "ok"), error({{8, 1}, {16, 0.25}}),
                                      number(Kind::value, "v", 0)};
  const Comparison same = compare(findings, findings);
  EXPECT_EQ(same.changes.size(), 4U);
  EXPECT_EQ(same.changed(), 0U);
  EXPECT_THAT(same.only_before, IsEmpty());
  EXPECT_THAT(same.only_after, IsEmpty());
}

TEST(Compare, RoundOffIsNoChange) {
  EXPECT_EQ(bands(number(Kind::value, "v", 1), number(Kind::value, "v", 1 + 1e-10)), 0);
  EXPECT_EQ(bands(number(Kind::value, "v", 2e-16), number(Kind::value, "v", -7e-14)), 0);
  EXPECT_GT(bands(number(Kind::value, "v", 1), number(Kind::value, "v", 1 + 1e-8)), 0);
  EXPECT_GT(bands(number(Kind::value, "v", 0), number(Kind::value, "v", 1e-12)), 0);
}

TEST(Compare, MeasuresInTheGoldensBands) {
  EXPECT_NEAR(bands(number(Kind::order, "o", 2, 1), number(Kind::order, "o", 1.7, 1)), 2, 1e-12);
  EXPECT_NEAR(bands(number(Kind::order, "o", 2, 1), number(Kind::order, "o", 2.15, 1)), -1, 1e-12);
  EXPECT_NEAR(bands(number(Kind::limit, "l", 0.8, -1), number(Kind::limit, "l", 0.88, -1)), 2, 1e-12);
  EXPECT_NEAR(bands(error({{8, 1}, {16, 0.2}}), error({{8, 1}, {16, 0.26}})), 3, 1e-12);
  EXPECT_NEAR(bands(number(Kind::value, "v", -1), number(Kind::value, "v", -1.2)), 2, 1e-12);
  EXPECT_NEAR(bands(error({{8, 1}, {16, 0.2}}), error({{8, 1}, {16, 0.14}})), -3, 1e-12) << "smaller is better";
  Finding before = error({{8, 1}, {16, 0.2}}), after = error({{8, 1}, {16, 0.14}});
  before.better = after.better = 0;
  EXPECT_NEAR(bands(before, after), 3, 1e-12) << "of a curve no one knows";
  EXPECT_EQ(bands(error({{8, 1}, {16, 0.2}}), error({{8, 1}, {16, 0.2}})), 0);
}

/// As findings of a study have it, to the sign of a change.
TEST(Compare, KnowsTheBetterSideOfALimit) {
  const auto study = [](const char* key, double stable, double unstable) {
    records::StudyResult result;
    result.name = "s";
    result.series.resize(1);
    fits::StabilityLimit& limit = result.series[0].limit.emplace();
    limit.key = key, limit.stable = stable, limit.unstable = unstable, limit.found = true;
    return claims::findings_of(result);
  };
  const auto change = [&](const char* key, double ratio) {
    const bool below = std::string(key) == "cfl";
    const auto before = study(key, below ? 0.79 : 0.81, below ? 0.81 : 0.79);
    const auto after = study(key, ratio * (below ? 0.79 : 0.81), ratio * (below ? 0.81 : 0.79));
    return compare(before, after).changes.at(0).bands;
  };
  EXPECT_NEAR(change("cfl", 0.9), 2, 1e-12) << "stable up to less";
  EXPECT_NEAR(change("cfl", 1.1), -2, 1e-12);
  EXPECT_NEAR(change("smoothing_length", 0.9), -2, 1e-12) << "stable down to less";
  EXPECT_NEAR(change("smoothing_length", 1.1), 2, 1e-12);
}

/// An energy loss of -0.5 is half of the energy gained.
TEST(Compare, OfErrorsTheSmallerSizeIsBetter) {
  EXPECT_NEAR(bands(error({{8, 0.01}}), error({{8, -0.5}})), 510, 1e-9);
  EXPECT_NEAR(bands(error({{8, -0.5}}), error({{8, 0.01}})), -10.2, 1e-9);
  EXPECT_NEAR(bands(error({{8, -0.5}}), error({{8, -0.55}})), 1, 1e-9);
  EXPECT_NEAR(bands(error({{8, -0.5}}), error({{8, -0.45}})), -1, 1e-9);
}

/// What a search of two values finds, of which these are stable. The limit lies above what is stable, or below it.
Finding limit(bool stable_below, bool low, bool high) {
  const auto probe = [&](const std::vector<double>&) {
    return std::vector<fits::Probe>{{0.6, low, ""}, {1, high, ""}};
  };
  records::StudyResult study;
  study.series.resize(1);
  study.series[0].limit = fits::find_limit({"k", 0.6, 1, 2, 0.9, stable_below}, probe);
  return claims::findings_of(study).at(0);
}

TEST(Compare, ALimitIsBestBeyondAllThatIsStableAndWorstWhereNothingIs) {
  for (const bool below : {true, false}) {
    const Finding all = limit(below, true, true), none = limit(below, false, false),
                  found = limit(below, below, !below), mixed = limit(below, !below, below);
    ASSERT_EQ(found.word, "");
    EXPECT_EQ(bands(all, found), INFINITY);
    EXPECT_EQ(bands(all, none), INFINITY);
    EXPECT_EQ(bands(found, none), INFINITY);
    EXPECT_EQ(bands(found, mixed), INFINITY) << "lost";
    EXPECT_EQ(bands(none, all), -INFINITY);
    EXPECT_EQ(bands(none, found), -INFINITY);
    EXPECT_EQ(bands(found, all), -INFINITY);
    EXPECT_EQ(bands(mixed, found), -INFINITY);
    for (const Finding& one : {all, none, found, mixed}) EXPECT_EQ(bands(one, one), 0);
  }
}

TEST(Compare, ALimitBeyondOtherValuesTriedHasNotChanged) {
  Finding near = limit(true, true, true), far = near;
  far.word = "stable at all values tried, up to 2";
  EXPECT_EQ(bands(near, far), 0);
}

TEST(Compare, MeasuresWhatIsExtrapolatedInItsUncertainty) {
  Finding before = number(Kind::value, "extrapolated", 1e-3), after = number(Kind::value, "extrapolated", -2e-3);
  before.uncertainty = 1e-3, after.uncertainty = 5;
  EXPECT_NEAR(bands(before, after), 3, 1e-12);
  EXPECT_EQ(bands(before, before), 0);
  before.uncertainty = 1e-15, after.number = 1e-3 * (1 + 1e-10);
  EXPECT_EQ(bands(before, after), 0) << "round-off";
  before.uncertainty = 0, after.number = 1.1e-3;
  EXPECT_NEAR(bands(before, after), 1, 1e-12) << "without an uncertainty, as other values";
}

TEST(Compare, FindsTheLevelThatChangedMost) {
  const Change change = compare({error({{4, 4}, {8, 1}, {16, 0.2}})}, {error({{8, 2}, {16, 0.2}, {32, 9}})}).changes[0];
  ASSERT_TRUE(change.largest);
  EXPECT_EQ(change.largest->x, 8);
  EXPECT_EQ(change.largest->after, 2);
  EXPECT_EQ(change.largest->before, 1);
  EXPECT_NEAR(change.bands, 10, 1e-12);
  const Change other = compare({error({{8, 1}, {16, 0.2}})}, {error({{4, 9}, {8, 1}, {16, 0.3}})}).changes[0];
  EXPECT_EQ(other.largest->x, 16);
  EXPECT_NEAR(other.bands, 5, 1e-12);
}

TEST(Compare, AStepOfACurveIsMeasuredAgainstTheWholeCurve) {
  const Finding before = curve({{0, 0}, {1, 1e-12}, {2, 3}, {3, 4}}),
                after = curve({{0, 1e-12}, {1, 1e-9}, {2, 4}, {3, 5}, {4, 9}});
  const Change change = compare({before}, {after}).changes[0];
  ASSERT_TRUE(change.largest);
  EXPECT_EQ(change.largest->x, 2) << "not where it was 0";
  EXPECT_NEAR(change.bands, 10 * 1. / 9, 1e-12) << "the largest size is that of either version";
  EXPECT_NEAR(bands(curve({{0, -4}, {1, 1}}), curve({{0, -4}, {1, 2}})), 2.5, 1e-12);
  EXPECT_EQ(bands(curve({{0, 0}}), curve({{0, 0}})), 0);
  EXPECT_TRUE(is_curve(before));
  EXPECT_FALSE(is_curve(error({{8, 1}})));
}

TEST(Compare, AChangeFromExactlyZeroIsFinite) {
  EXPECT_NEAR(bands(number(Kind::value, "v", 0), number(Kind::value, "v", -3)), 10, 1e-12);
  EXPECT_NEAR(bands(error({{8, 0}, {16, 1}}), error({{8, 1e-3}, {16, 1.2}})), 10, 1e-12);
}

TEST(Compare, WorstStandsFirst) {
  const std::vector<Finding> before{number(Kind::order, "drop", 2, 1), number(Kind::order, "rise", 1, 1),
                                    number(Kind::order, "same", 1, 1), word("worse", "ok"), word("better", "unstable")};
  const std::vector<Finding> after{number(Kind::order, "drop", 1, 1), number(Kind::order, "rise", 2, 1),
                                   number(Kind::order, "same", 1, 1), word("worse", "unstable"), word("better", "ok")};
  std::vector<std::string> names;
  for (const Change& change : compare(before, after).changes) names.push_back(change.before.name);
  EXPECT_THAT(names, ElementsAre("worse", "drop", "same", "rise", "better"));
}

TEST(Compare, ANumberThatIsLostIsTheWorst) {
  Finding lost = number(Kind::order, "o", support::not_measured, 1);
  lost.word = "not measured";
  EXPECT_EQ(bands(number(Kind::order, "o", 2, 1), lost), INFINITY);
  EXPECT_EQ(bands(lost, number(Kind::order, "o", 2, 1)), -INFINITY);
  EXPECT_EQ(bands(lost, lost), 0);
}

TEST(Compare, AnotherWordOutweighsNumbers) {
  EXPECT_EQ(bands(word("w", "refuted"), word("w", "confirmed")), -INFINITY);
  EXPECT_EQ(bands(word("w", "confirmed"), word("w", "partly")), INFINITY);
  EXPECT_EQ(bands(word("w", "unstable"), word("w", "ok")), -INFINITY);
  EXPECT_EQ(bands(word("w", "unstable"), word("w", "failed")), INFINITY);
  EXPECT_EQ(bands(word("w", "failed"), word("w", "unstable")), -INFINITY);
  EXPECT_EQ(bands(word("w", "refuted"), word("w", "partly")), -INFINITY);
  EXPECT_EQ(bands(word("w", "open"), word("w", "refuted")), INFINITY);
  EXPECT_EQ(bands(word("w", "confirmed"), word("w", "shown")), INFINITY) << "neither, so it is not hidden at the end";
  EXPECT_EQ(bands(word("w", "refuted"), word("w", "shown")), INFINITY);
  EXPECT_EQ(compare({word("w", "ok"), word("v", "ok")}, {word("w", "unstable"), word("v", "ok")}).changed(), 1U);
}

TEST(Compare, OfVerdictsOnACriterionHoldsIsTheBestAndFailsTheWorst) {
  const auto change = [](records::PartVerdict before, records::PartVerdict after) {
    const auto judged = [](records::PartVerdict verdict) {
      records::StudyResult study;
      study.name = "s", study.claims = {"B-v"};
      study.parts = {{"B-v", "the error falls", verdict, "", ""}};
      return claims::findings_of(std::vector{study});
    };
    const Comparison comparison = compare(judged(before), judged(after));
    const auto found = std::ranges::find(comparison.changes, "criterion of B-v: the error falls",
                                         [](const Change& one) { return one.after.name; });
    return found == comparison.changes.end() ? NAN : found->bands;
  };
  using enum records::PartVerdict;
  EXPECT_EQ(change(holds, fails), INFINITY);
  EXPECT_EQ(change(holds, inconclusive), INFINITY);
  EXPECT_EQ(change(inconclusive, fails), INFINITY);
  EXPECT_EQ(change(fails, holds), -INFINITY);
  EXPECT_EQ(change(fails, inconclusive), -INFINITY);
  EXPECT_EQ(change(inconclusive, holds), -INFINITY);
  EXPECT_EQ(change(fails, fails), 0);
  EXPECT_TRUE(std::isnan(change(shown, shown))) << "nothing is asked";
}

TEST(Compare, TellsWhichStudiesJudgeAClaimThatOthersJudgeInTheOtherVersion) {
  const auto judged_by = [](const std::vector<std::string>& studies) {
    Finding finding = word("claim B-v", studies.size() == 2 ? "partly" : "refuted");
    finding.study = "";
    finding.judges = studies;
    return std::vector{finding};
  };
  const Comparison comparison = compare(judged_by({"b", "a"}), judged_by({"b"}));
  EXPECT_THAT(comparison.changes, IsEmpty()) << "study a has not run yet";
  EXPECT_THAT(comparison.only_before, ElementsAre("claim B-v by a, b"));
  EXPECT_THAT(comparison.only_after, ElementsAre("claim B-v by b"));
  EXPECT_EQ(compare(judged_by({"a", "b"}), judged_by({"b", "a"})).changes.size(), 1U);
}

/// Two criteria of a claim may have one statement, each for a series of its own.
TEST(Compare, OfFindingsWithOneNameTheFirstIsHeldAgainstTheFirst) {
  const auto two = [](const std::string& second) {
    return std::vector{word("criterion 'o' of claim c", "holds"), word("criterion 'o' of claim c", second)};
  };
  EXPECT_EQ(compare(two("holds"), two("fails")).changed(), 1U);
  EXPECT_EQ(compare(two("fails"), two("fails")).changed(), 0U);
}

TEST(Compare, ANumberThatBecomesInfiniteIsBeyondAll) {
  const auto bands = [](double before, double after) {
    return compare({number(Kind::value, "v", before)}, {number(Kind::value, "v", after)}).changes[0].bands;
  };
  EXPECT_EQ(bands(13.8, INFINITY), INFINITY);
  EXPECT_EQ(bands(INFINITY, 13.8), INFINITY);
  EXPECT_EQ(bands(-INFINITY, INFINITY), INFINITY);
  EXPECT_EQ(bands(INFINITY, INFINITY), 0);
}

TEST(Compare, CostIsShownApart) {
  const std::vector<Finding> before{number(Kind::cost, "a", 10, -1), number(Kind::cost, "b", 10, -1)};
  const Comparison comparison = compare(before, {number(Kind::cost, "a", 11, -1), number(Kind::cost, "b", 20, -1)});
  EXPECT_THAT(comparison.changes, IsEmpty());
  ASSERT_EQ(comparison.costs.size(), 2U);
  EXPECT_EQ(comparison.costs[0].before.name, "b");
}

TEST(Compare, ListsWhatOnlyOneHas) {
  Finding elsewhere = number(Kind::value, "v", 1), twice = number(Kind::value, "w", 1);
  elsewhere.study = twice.study = "t";
  const Comparison comparison = compare({number(Kind::value, "v", 1), number(Kind::value, "gone", 1)},
                                        {number(Kind::value, "v", 1), elsewhere, twice});
  EXPECT_THAT(comparison.only_before, ElementsAre("s: gone"));
  EXPECT_THAT(comparison.only_after, ElementsAre("study t"));
  Finding claim = word("claim S-fig10", "confirmed");
  claim.study = "";
  EXPECT_THAT(compare({claim}, {}).only_before, ElementsAre("claim S-fig10"));
}

}  // namespace mpmvv::goldens::comparison_test
