#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reports/chart.hpp"
#include "reports/picture.hpp"
#include "reports/plot.hpp"

/// Particles of runs, coloured by their errors.
namespace mpmvv::reports::particle_error_chart_test {

using records::ParticleError;
using records::Series;
using records::Status;
using records::StudyResult;

using testing::Contains;
using testing::HasSubstr;

/// 10 by 10 particles, a tenth apart, whose errors grow along x from 1e-6 to 1e-4.
std::vector<ParticleError> square() {
  std::vector<ParticleError> all;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) all.push_back({0.05 + 0.1 * i, 0.05 + 0.1 * j, 1e-6 * std::pow(100, i / 9.0)});
  return all;
}

StudyResult runs_study() {
  StudyResult study;
  study.name = "runs";
  study.kind = records::StudyKind::convergence;
  study.sweep = "cells";
  study.series = {Series{"theirs", {}, {}, {}}, Series{"ours", {}, {}, {}}};
  for (Series& series : study.series) {
    series.points = {
        {8, Status::ok, "", {{"images", 1}}}, {16, Status::ok, "", {{"images", 1}}}, {32, Status::unstable, "", {}}};
    series.points[0].particle_errors = {{0, 0.1, 1}};
    series.points[1].particle_errors = square();
  }
  records::Figure figure;
  figure.name = "runs", figure.kind = records::Figure::Kind::particles, figure.xlabel = "x", figure.ylabel = "y";
  study.figures = {figure};
  return study;
}

TEST(ParticleErrorChart, SaysWhichSeriesHaveNoErrorAtAll) {
  StudyResult study = runs_study();
  for (ParticleError& one : study.series[0].points[1].particle_errors) one.error = 0;
  const Chart chart = charts_of(study).at(0);
  EXPECT_THAT(chart.omissions, Contains("The errors are exactly 0, drawn like the smallest: theirs."));
  EXPECT_GT(chart.shades->tics.size(), 1U);
  study.series.pop_back();
  const Chart all_zero = charts_of(study).at(0);
  EXPECT_EQ(all_zero.shades->label, "displacement error (m), all 0");
  for (const Tic& tic : all_zero.shades->tics) EXPECT_EQ(tic.text, "");
}

TEST(ParticleErrorChart, HasAPanelOfSquaresForTheLastSoundRunOfEachSeries) {
  const Chart chart = charts_of(runs_study()).at(0);
  ASSERT_EQ(chart.curves.size(), 2U);
  EXPECT_TRUE(chart.to_scale);
  EXPECT_TRUE(chart.boxes.empty());
  EXPECT_EQ(chart.curves[0].dots.size(), 100U);
  EXPECT_NEAR(chart.curves[0].square, 0.1, 1e-12);
  EXPECT_NEAR(chart.curves[1].dots[99].shade, 1e-4, 1e-12);
  EXPECT_TRUE(std::ranges::is_sorted(chart.curves[1].dots, {}, &Dot::shade)) << "the largest error is drawn last";
  EXPECT_GT(chart.curves[1].dots[0].x, 1) << "beside the first panel";
  EXPECT_THAT(chart.notes, Contains(HasSubstr("theirs at cells 16; ours at cells 16")));
}

/// Squares of many particles hide no neighbour and make the body no larger than it is.
TEST(ParticleErrorChart, SquaresOfManyParticlesTileTheBody) {
  StudyResult study = runs_study();
  auto& many = study.series[0].points[1].particle_errors;
  many.clear();
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) many.push_back({0.5 + i, 0.5 + j, 1e-6 * (400 - 20 * i - j)});
  const Chart chart = charts_of(study).at(0);
  EXPECT_NEAR(chart.curves[0].square, 1, 1e-12);
  const auto frame = std::ranges::find(chart.rules, Rule::Kind::frame, &Rule::kind);
  ASSERT_NE(frame, chart.rules.end());
  EXPECT_NEAR(frame->path[0].x, 0, 1e-12);
  EXPECT_NEAR(frame->path[1].x, 20, 1e-12);
}

TEST(ParticleErrorChart, SquaresOfASingleRowAreAsLargeAsItsSpacing) {
  StudyResult study = runs_study();
  auto& row = study.series[0].points[1].particle_errors;
  row.clear();
  for (int i = 0; i < 10; ++i) row.push_back({0.01 + 0.02 * i, 0.01, 1e-6});
  EXPECT_NEAR(charts_of(study).at(0).curves[0].square, 0.02, 1e-9);
  EXPECT_THAT(charts_of(study).at(0).notes, testing::Not(Contains(HasSubstr("lone particle"))));
  row.resize(1);
  EXPECT_NEAR(charts_of(study).at(0).curves[0].square, 0.02, 1e-9);
  EXPECT_THAT(charts_of(study).at(0).notes, Contains(HasSubstr("its square is a guess")));
}

/// A few that are about zero would take the colours of all others.
TEST(ParticleErrorChart, ItsColoursAreThoseOfNearlyAllErrors) {
  StudyResult study = runs_study();
  study.series[0].points[1].particle_errors[3].error = 1e-15;
  study.series[0].points[1].particle_errors[4].error = 0;
  const Chart chart = charts_of(study).at(0);
  ASSERT_TRUE(chart.shades);
  EXPECT_TRUE(chart.shades->log);
  EXPECT_DOUBLE_EQ(chart.shades->from, 1e-6);
  EXPECT_NEAR(chart.shades->to, 1e-4, 1e-12);
}

TEST(ParticleErrorChart, IsDrawnInThePaletteAndItsErrorsAreInTheData) {
  const Chart chart = charts_of(runs_study()).at(0);
  const Plot plot = plot_of(chart);
  for (const char* text : {"set palette defined", "set logscale cb", "lc palette", "displacement error (m)"})
    EXPECT_THAT(plot.script, HasSubstr(text));
  const auto behind = plot.script.find("using 1:3:(0.06"), square = plot.script.find("using 1:3:(0.05");
  EXPECT_LT(behind, square) << "larger squares close gaps";
  EXPECT_NE(square, std::string::npos);
  EXPECT_THAT(plot.data, HasSubstr(" 1 1.6681005372000587e-06\n"));
  EXPECT_THAT(description_of(chart), HasSubstr("100 of theirs, errors from 1e-06 to 0.0001"));
}

TEST(ParticleErrorChart, OfABodyAlongALineIsErrorAgainstPlace) {
  StudyResult study = runs_study();
  for (Series& series : study.series) series.points[1].particle_errors = {{0.9, 0, 2e-5}, {0.1, 0, 1e-6}, {0.5, 0, 0}};
  const Chart chart = charts_of(study).at(0);
  EXPECT_FALSE(chart.to_scale);
  EXPECT_FALSE(chart.shades);
  ASSERT_EQ(chart.curves[0].dots.size(), 3U);
  EXPECT_EQ(chart.curves[0].dots[2].x, 0.9);
  EXPECT_EQ(chart.curves[0].dots[2].value, 2e-5);
  EXPECT_EQ(chart.curves[0].dots[1].mark, Mark::absent);
}

TEST(ParticleErrorChart, SaysWhatIsNotThere) {
  StudyResult study = runs_study();
  study.series[0].points[1].y["images"] = 4;
  EXPECT_THAT(charts_of(study).at(0).omissions, Contains(HasSubstr("mirror images in planes across the axes")));
  for (ParticleError& one : study.series[0].points[1].particle_errors) one.x -= 0.5, one.y -= 0.5;
  EXPECT_TRUE(charts_of(study).at(0).omissions.empty()) << "quarter turns have their images around the origin";
  study.series[0].points[1].y["images"] = 2;
  for (ParticleError& one : study.series[0].points[1].particle_errors) one.x += 0.5, one.y += 0.5;
  EXPECT_TRUE(charts_of(study).at(0).omissions.empty()) << "the image in the diagonal is drawn";
  for (Series& series : study.series)
    for (records::Point& point : series.points) point.particle_errors.clear();
  const Chart empty = charts_of(study).at(0);
  EXPECT_THAT(empty.omissions, Contains("No run has errors of particles."));
  EXPECT_THAT(plot_of(empty).script, HasSubstr("nothing to draw"));
}

TEST(ParticleErrorChart, ASeriesThatIsUnstableOnEveryMeshIsNamed) {
  StudyResult study = runs_study();
  study.series.push_back({"lost", {{8, Status::unstable, "", {}}, {16, Status::unstable, "", {}}}, {}, {}});
  study.series.push_back({"not asked", {{8, Status::ok, "", {}}}, {}, {}});
  EXPECT_THAT(charts_of(study).at(0).omissions,
              testing::ElementsAre("Not drawn, as all its runs are unstable or failed: lost."));
}

}  // namespace mpmvv::reports::particle_error_chart_test
