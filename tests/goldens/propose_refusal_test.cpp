#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "goldens/propose.hpp"
#include "studies/support/error.hpp"
#include "tests/goldens/propose_samples.hpp"

/// What is not proposed, and what stands in for it.
namespace mpmvv::goldens::propose_refusal_test {

using namespace propose_samples;

using support::UsageError;

using testing::HasSubstr;

TEST(Propose, WhatCannotBeProposedIsARemark) {
  Series series = convergent();
  series.orders.push_back(fitted("linf", 2, 2));
  series.limit = cfl_limit(1, 9);
  StudyResult study = study_with(series);
  study.values = {{"gap", not_measured, ""}};
  EXPECT_EQ(proposed(study).size(), 2U);
  const std::string text = draft(study);
  EXPECT_THAT(text, HasSubstr("in linf over [16, 64]: 2 usable points"));
  EXPECT_THAT(text, HasSubstr("# No error of"));
  EXPECT_THAT(text, HasSubstr("it lies between 1 and 9, too far apart"));
  EXPECT_THAT(text, HasSubstr("# No value \"gap\""));
}

TEST(Propose, WithoutAnyGoldenTheReasonIsSaid) {
  Series series = convergent();
  series.name = "a", series.orders.clear();
  series.limit = fits::StabilityLimit{};
  series.limit->key = "cfl", series.limit->stable = 1, series.limit->probes = {{0.5, true, ""}, {1, true, ""}};
  const auto refused = [](const StudyResult& study) -> std::string {
    try {
      propose_goldens(study, clean);
    } catch (const UsageError& e) {
      return e.what();
    }
    return "";
  };
  StudyResult study = study_with(series);
  EXPECT_EQ(refused(study),
            "nothing to propose for study 's-fig10': No limit of \"a\" in cfl: stable at all values tried, up to 1.");
  study.values = {{"gap", not_measured, ""}};
  EXPECT_THAT(refused(study), testing::EndsWith("up to 1. (and 1 more without a golden)"));
  study.values.clear(), study.series[0].limit.reset();
  EXPECT_THAT(refused(study), HasSubstr("(a [[fit]], a [limit], a check, or a [[figure]] of kind curves of an error"));
}

TEST(Propose, TextOfPeopleCannotBreakTheFile) {
  StudyResult study = study_with(convergent());
  study.values = {{"gap\n[[order]]", 1, "two\nlines"}};
  const auto goldens = proposed(study);
  ASSERT_EQ(goldens.size(), 3U);
  EXPECT_EQ(std::get<ValueGolden>(goldens[2].expectation).name, "gap\n[[order]]");
}

TEST(Propose, ADirtyTreeIsNamedAndRefusedWhereACommitIsAsked) {
  store::Provenance dirty = clean;
  dirty.dirty = true;
  const StudyResult study = study_with(convergent());
  EXPECT_THAT(draft(study, dirty), HasSubstr("commit abc with changes that are not committed, digest d1"));
  EXPECT_THAT(draft(study), HasSubstr("commit abc, digest d1"));
  EXPECT_THROW(require_committed(study, dirty), UsageError);
  require_committed(study, clean);
}

TEST(Propose, WithoutAFitOrLimitTheFinestErrorsThatFiguresDraw) {
  Series series = convergent();
  series.orders.clear();
  series.points[2].y["stress_error"] = 17.25, series.points[2].y["l1"] = 1;
  StudyResult study = study_with(series);
  EXPECT_THROW(propose_goldens(study, clean), UsageError) << "no figure";
  study.figures.resize(3);
  study.figures[1].quantity = "stress_error";
  study.figures[2].quantity = "l1", study.figures[2].series = {"another"};
  const auto goldens = proposed(study);
  ASSERT_EQ(goldens.size(), 2U);
  const auto& error = std::get<ErrorGolden>(goldens[1].expectation);
  EXPECT_EQ(error.norm, "stress_error");
  EXPECT_EQ(error.at, 64);
  EXPECT_EQ(error.expected, 17.25);
  study.series[0].limit = cfl_limit(0.7, 0.71);
  EXPECT_EQ(proposed(study).size(), 1U) << "the limit is what was asked";
}

/// What the gate would refuse, and with it the whole file.
TEST(Propose, ANormThatGoldensDoNotKnowIsARemark) {
  Series series = convergent();
  for (records::Point& point : series.points) point.y["ns_per_particle_step"] = 20;
  series.orders.push_back(fitted("ns_per_particle_step", 3, 1));
  const std::string fits = draft(study_with(series));
  EXPECT_THAT(fits, HasSubstr("in ns_per_particle_step over [16, 64]: goldens know no such norm."));
  series.orders.clear();
  StudyResult study = study_with(series);
  study.figures.resize(1);
  study.figures[0].quantity = "ns_per_particle_step";
  EXPECT_THROW(propose_goldens(study, clean), UsageError) << "which leaves nothing";
  study.figures.resize(2);
  EXPECT_THAT(draft(study), HasSubstr("in ns_per_particle_step: goldens know no such norm."));
  EXPECT_EQ(proposed(study).size(), 1U);
}

TEST(Propose, ALevelAtZeroIsARemark) {
  Series series = convergent();
  series.points[0].x = 0;
  series.orders.clear();
  StudyResult study = study_with(series, "grid_offset");
  study.values = {{"gap", 1, ""}};
  study.figures.resize(1);
  EXPECT_THAT(draft(study), HasSubstr("in l2: goldens know no level at 0, only above 0."));
  study.kind = records::StudyKind::check;
  study.series[0].orders = {fitted("y", 3, 2)};
  study.series[0].orders[0].from = 0;
  EXPECT_THAT(draft(study), HasSubstr("in y over [0, 64]: goldens know no level at 0, only above 0."));
}

TEST(Propose, APlantedMistakeHasNoGoldenButARemark) {
  StudyResult study = study_with(convergent());
  Series planted = convergent();
  planted.name = "no \"b\"", planted.code = records::OtherCode{"tiny", "0.3", "", "none"};
  planted.limit = cfl_limit(0.7, 0.71);
  study.series.push_back(planted);
  const auto with = [&](const std::set<std::string>& names) { return propose_goldens(study, clean, {}, names); };
  EXPECT_EQ(parse_goldens(with({}), "new.toml").size(), 5U);
  EXPECT_EQ(parse_goldens(with({planted.name}), "new.toml").size(), 2U);
  EXPECT_THAT(with({planted.name}),
              HasSubstr("\n# No golden of \"no \\\"b\\\"\": a planted mistake, force_form = \"none\", "
                        "which is a criterion's matter.\n"));
  EXPECT_THROW(with({planted.name, convergent().name}), UsageError) << "which leaves nothing";
}

/// An order lets its finest error fall as far as it will.
TEST(Propose, AnErrorThatAnOrderHasTooSaysWhatItAdds) {
  const char* remark = "# An order above fails where this error grows; this golden fails where it falls, too.\n";
  Series series = convergent();
  EXPECT_THAT(draft(study_with(series)), HasSubstr(remark));
  series.points.push_back({512, Status::ok, "", {{"l2", 1e-6}}});
  EXPECT_THAT(draft(study_with(series)), testing::Not(HasSubstr(remark))) << "its window ends before";
  series.points.pop_back(), series.orders[0].points = 2;
  EXPECT_THAT(draft(study_with(series)), testing::Not(HasSubstr(remark))) << "the order has no golden";
}

TEST(Propose, AnErrorSaysWhichFinerLevelsWerePassedOver) {
  Series series = convergent();
  series.points.pop_back();
  EXPECT_THAT(draft(study_with(series)), HasSubstr("# The finest stable level in cells.\n"));
  series.points[2].y["l2"] = -0.0448;
  const std::string text = draft(study_with(series));
  EXPECT_THAT(text, HasSubstr("# The finest stable level in cells with an error above 0, which finer ones lack.\n"));
  EXPECT_THAT(text, HasSubstr("at = 32\n"));
}

TEST(Propose, NothingToProposeIsAnError) {
  EXPECT_THROW(propose_goldens(study_with({}), clean), UsageError);
}

}  // namespace mpmvv::goldens::propose_refusal_test
