#include "reports/original_look.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/picture.hpp"
#include "reports/plot.hpp"
#include "reports/plot_style.hpp"
#include "reports/unstable_band.hpp"

namespace mpmvv::reports::original_look_test {

records::StudyResult study_with(const std::string& figure, const std::string& quantity,
                                const std::vector<std::string>& series) {
  records::StudyResult study;
  study.name = figure, study.sweep = "cells", study.kind = records::StudyKind::convergence;
  for (const auto& name : series) {
    records::Series s{name, {}, {}, {}};
    for (const double x : {4.0, 8.0, 16.0})
      s.points.push_back({.x = x, .status = records::Status::ok, .reason = "", .y = {{quantity, 0.1 / x}}});
    study.series.push_back(s);
  }
  records::Figure shown;
  shown.name = figure, shown.quantity = quantity, shown.slopes = {1};
  study.figures = {shown};
  return study;
}

TEST(OriginalLook, EnergyIsInPercentWhereThePaperHasPercent) {
  const Chart chart = charts_of(study_with("n-fig3a", "energy_loss", {"FLIP"})).at(0);
  EXPECT_EQ(chart.y.label, "energy lost (% of the initial energy)");
  EXPECT_DOUBLE_EQ(chart.curves[0].dots[0].drawn, 100 * 0.1 / 4);
  for (const Dot& dot : chart.curves[0].dots) EXPECT_TRUE(chart.y.holds(dot.drawn)) << dot.x;
  for (const Rule& rule : chart.rules)
    for (const Place& place : rule.path) EXPECT_TRUE(chart.y.holds(place.y)) << rule.meaning;
  EXPECT_FALSE(chart.rules.empty()) << "a reference slope";
}

TEST(OriginalLook, NotesHaveTheUnitOfTheAxis) {
  records::StudyResult study = study_with("n-fig4", "energy_loss", {"uGIMP"});
  study.series[0].points[1].y["energy_loss"] = -0.08171;
  study.figures[0].y_max = 0.01;
  EXPECT_EQ(charts_of(study).at(0).omissions.back(),
            "Without a point: uGIMP at 8 (-8.171 %); uGIMP at 4 (2.5 % is off the axes).");
  study.figures[0].name = "mine";
  EXPECT_THAT(charts_of(study).at(0).omissions.back(), testing::HasSubstr("uGIMP at 8 (-0.08171)"));
}

TEST(OriginalLook, TheBandOfUnstableRunsStaysAboveTheValues) {
  records::StudyResult study = study_with("n-fig4", "energy_loss", {"uGIMP"});
  study.series[0].points[2] = {16, records::Status::unstable, "", {}};
  const Chart chart = charts_of(study).at(0);
  ASSERT_GT(chart.band, 0);
  EXPECT_GT(top_of_values(chart), 100 * 0.1 / 4);
  EXPECT_GT(chart.curves[0].dots[2].drawn, top_of_values(chart));
  EXPECT_TRUE(holds(chart, chart.curves[0].dots[2]));
  EXPECT_EQ(chart.y.tics.back().text, "unstable");
}

TEST(OriginalLook, OtherQuantitiesAndFiguresStayAsTheyAre) {
  for (const auto& [figure, quantity] : {std::pair{"n-fig3a", "l2"}, std::pair{"mine", "energy_loss"}}) {
    const Chart chart = charts_of(study_with(figure, quantity, {"FLIP"})).at(0);
    EXPECT_DOUBLE_EQ(chart.curves[0].dots[0].drawn, 0.1 / 4) << figure;
    EXPECT_EQ(chart.curves[0].style, Style(0)) << figure;
  }
}

TEST(OriginalLook, PressureIsInGigapascal) {
  const Chart chart = charts_of(study_with("n-fig8a", "y", {"pressure"})).at(0);
  EXPECT_EQ(chart.y.label, "pressure (GPa)");
  EXPECT_DOUBLE_EQ(chart.curves[0].dots[0].drawn, 1e-9 * 0.1 / 4);
}

TEST(OriginalLook, DomainsAreToScale) {
  records::StudyResult study = study_with("b-fig16-3a", "y", {"domain"});
  study.figures[0].log_x = study.figures[0].log_y = false;
  study.figures[0].x_min = 4, study.figures[0].x_max = 16, study.figures[0].y_min = 0, study.figures[0].y_max = 6;
  const Chart chart = charts_of(study).at(0);
  EXPECT_TRUE(chart.to_scale);
  EXPECT_DOUBLE_EQ(chart.height, 650 * 6.0 / 12 + 80);
  EXPECT_THAT(description_of(chart), testing::HasSubstr("domain: from")) << "curves, not particles";
  Chart closed = chart;
  const auto corner = [](double x, double y) { return Dot{.x = x, .value = y, .drawn = y, .mark = Mark::inside}; };
  closed.curves[0].dots = {corner(4, 1), corner(7, 1), corner(7, 3), corner(4, 3), corner(4, 1)};
  EXPECT_THAT(description_of(closed), testing::HasSubstr("domain: an outline from 4 to 7, and from 1 to 3 upwards"));
  study.figures[0].log_x = true;
  EXPECT_FALSE(charts_of(study).at(0).to_scale) << "a logarithm has no scale";
}

TEST(OriginalLook, AGroupSharesItsColourAndMarker) {
  const Chart chart =
      charts_of(study_with("n-fig5", "energy_loss", {"FLIP, USF", "another", "FLIP, USL", "FMPM(8), USL"})).at(0);
  const auto style = [&](std::size_t curve) { return chart.curves.at(curve).style; };
  EXPECT_EQ(colour_of(style(2)), colour_of(style(3)));
  EXPECT_EQ(marker_of(style(2)).filled, marker_of(style(3)).filled);
  EXPECT_NE(dash_of(style(2)), dash_of(style(3)));
  EXPECT_FALSE(is_hollow(style(2)));
  EXPECT_TRUE(is_hollow(style(3)));
  EXPECT_NE(colour_of(style(0)), colour_of(style(2)));
  for (const std::size_t grouped : {0u, 2u, 3u})
    EXPECT_NE(marker_of(style(1)).filled, marker_of(style(grouped)).filled);
}

TEST(OriginalLook, HollowPointsAreDrawnAndInTheKey) {
  const Plot plot = plot_of(charts_of(study_with("n-fig5", "energy_loss", {"FMPM(8), USL"})).at(0));
  const auto hollow = std::to_string(marker_of(Style(0, 1)).hollow);
  EXPECT_NE(plot.script.find("($4==1?$3:NaN) with points pt " + hollow), std::string::npos) << plot.script;
  EXPECT_NE(plot.script.find("front point pt " + hollow), std::string::npos) << plot.script;
}

/// Whether two samples of a key follow one another that differ in their dashes alone.
TEST(OriginalLook, NoSampleOfTheKeyTakesTheDashOfTheOneBefore) {
  const Plot plot = plot_of(charts_of(study_with("n-fig5", "energy_loss", {"FLIP, USL", "FMPM(8), USL"})).at(0));
  std::vector<std::string> looks;
  for (std::size_t at = 0; (at = plot.script.find("nohead front ", at)) != std::string::npos; ++at)
    looks.push_back(plot.script.substr(at, plot.script.find('\n', at) - at));
  ASSERT_EQ(looks.size(), 2u);
  EXPECT_NE(looks[0].substr(0, looks[0].find(" dt")), looks[1].substr(0, looks[1].find(" dt")));
}

}  // namespace mpmvv::reports::original_look_test
