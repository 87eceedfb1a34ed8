#include "reports/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reports/csv.hpp"
#include "reports/latex_table.hpp"
#include "tests/reports/distinct.hpp"
#include "tests/reports/synthetic.hpp"

namespace mpmvv::reports::table_test {

using testing::AllOf;
using testing::HasSubstr;

TEST(Csv, HasEveryPointWithSeventeenDigits) {
  auto study = synthetic::convergence();
  study.series[1].points[0].y["l2"] = 0.1;
  study.series[1].points[0].y["l1"] = support::not_measured;
  const std::string text = csv_tables(study).at("bar-bases.csv");
  EXPECT_THAT(text, testing::StartsWith("series,x,status,l1,l2,l2_order,linf,wall_seconds,reason\n"));
  EXPECT_THAT(text, HasSubstr("\"bspline2, 4 PPC\",8,ok,,0.10000000000000001,"));
  EXPECT_THAT(text, HasSubstr("\"bspline3-open {a^2}, 4 PPC\",8,unstable,,,,,,det F <= 0 in step 12\n"));
  EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 5 * 7);
}

TEST(Csv, HasFitsLimitsProbesAndValuesWhereThereAreAny) {
  const auto fits = csv_tables(synthetic::convergence());
  EXPECT_EQ(fits.size(), 2u);
  EXPECT_THAT(fits.at("fits/bar-bases.csv"), HasSubstr("\"bspline2, 4 PPC\",l2,16,128,4,2.0099999999999998,"));
  const auto limits = csv_tables(synthetic::limits());
  EXPECT_THAT(limits.at("limits/bar-cfl.csv"), HasSubstr("\"l = 3h/8, 4 PPC\",cfl,"));
  EXPECT_TRUE(limits.contains("probes/bar-cfl.csv"));
  EXPECT_THAT(csv_tables(synthetic::check()).at("values/weights.csv"), HasSubstr("\nnothing,,a NaN\n"));
}

/// Half the difference of the segments' orders stands in for the interval of three points; two have none.
TEST(Csv, FitsHaveTheHalfWidthThatTheyAreJudgedBy) {
  fits::ObservedOrder three;
  three.norm = "l2", three.from = 1, three.to = 4, three.points = 3, three.order = 2;
  three.segments = {{1, 2, 1.75}, {2, 4, 2.25}};
  fits::ObservedOrder two = three, four = three;
  two.points = 2, two.segments.pop_back();
  four.points = 4, four.half_width = 0.5;
  records::StudyResult study;
  study.name = "s", study.series = {{"a", {}, {three, two, four}, {}}};
  EXPECT_THAT(csv_tables(study).at("fits/s.csv"),
              AllOf(HasSubstr(",order,half_width,student_half_width,constant,"), HasSubstr("a,l2,1,4,3,2,0.25,,,"),
                    HasSubstr("a,l2,1,4,2,2,,,,"), HasSubstr("a,l2,1,4,4,2,0.5,0.5,,")));
}

TEST(Table, SegmentOrdersStandBesideTheirErrors) {
  const auto table = points_table(synthetic::convergence());
  EXPECT_THAT(table.columns, testing::ElementsAre("cells", "status", "l2 (m)", "order of l2", "l1 (m)", "linf (m)",
                                                  "wall_seconds (s)", "reason"));
  EXPECT_EQ(table.groups[1].rows[0][3], "–");
  EXPECT_EQ(table.groups[1].rows[1][3], "2.01");
  EXPECT_EQ(table.groups[3].rows[0][1], "unstable");
  EXPECT_EQ(table.groups[3].rows[0][2], "–");
  EXPECT_EQ(table.groups[3].rows[0][7], "det F <= 0 in step 12");
}

TEST(Table, TheColumnOfACheckSaysWhatItsCurvesShow) {
  records::StudyResult check = synthetic::convergence();
  for (auto& series : check.series)
    for (auto& point : series.points) point.y = {{"y", point.x}};
  check.figures.resize(1);
  check.figures[0].quantity = "y", check.figures[0].ylabel = "spectral radius";
  EXPECT_THAT(points_table(check).columns, testing::Contains("y: spectral radius"));
  check.figures.push_back(check.figures[0]);
  check.figures[1].ylabel = "gain";
  EXPECT_THAT(points_table(check).columns, testing::Contains("y"));
}

TEST(Table, NoTwoColumnsHaveOneHead) {
  records::StudyResult swept;
  swept.sweep = "cfl";
  swept.series = {records::Series{"a", {}, {}, {}}};
  for (const double cfl : {0.1, 0.2})
    swept.series[0].points.push_back({cfl, records::Status::ok, "", {{"l2", cfl}, {"cfl", 0.99 * cfl}}});
  EXPECT_THAT(points_table(swept).columns, testing::Contains("cfl of the run"));
  for (const auto& study : {swept, distinct::everything(), distinct::costs()})
    for (const Table& table : tables_of(study)) {
      const std::set<std::string> heads(table.columns.begin(), table.columns.end());
      EXPECT_EQ(heads.size(), table.columns.size()) << table.caption;
    }
}

TEST(Table, WhatIsTheSameAtEveryPointStandsInTheNote) {
  records::StudyResult study;
  study.sweep = "cells";
  study.series = {records::Series{"a", {}, {}, {}}};
  for (const double n : {1.0, 2.0, 3.0})
    study.series[0].points.push_back({n,
                                      records::Status::ok,
                                      "",
                                      {{"l2", 0.1 / n},
                                       {"steps", 100 * n},
                                       {"images", 4},
                                       {"initial_total", 2.516e2},
                                       {"kinetic", 1 + 1e-6 * n},
                                       {"strain", n},
                                       {"momentum_change", 1e-15 * n},
                                       {"angular_momentum_change", 0},
                                       {"mass_change", 1e-9 * n}}});
  const auto table = points_table(study, 3);
  EXPECT_THAT(table.columns, testing::ElementsAre("cells", "l2 (m)", "mass_change", "steps"));
  EXPECT_THAT(table.groups.at(0).rows.at(1), testing::ElementsAre("2", "5.000e-02", "2.000e-09", "200"));
  EXPECT_EQ(table.note,
            "At every point: status ok, momentum_change at most 3.0e-15, angular_momentum_change = 0, kinetic = 1 J, "
            "initial_total = 251.6 J, images = 4. Measured, too, and in the CSV file: strain.");
  study.series[0].points.resize(1);
  EXPECT_EQ(points_table(study).note, "") << "a point by itself has nothing to be the same as";
}

TEST(Table, TheNoteSaysWhatOnlySomePointsHave) {
  records::StudyResult study;
  study.sweep = "cells";
  study.series = {records::Series{"a", {}, {}, {}}};
  for (const double n : {1.0, 2.0, 3.0})
    study.series[0].points.push_back(
        {n, records::Status::ok, "", {{"l2", 0.1 / n}, {"images", 4}, {"mass_change", 0}}});
  study.series[0].points[2].status = records::Status::unstable;
  study.series[0].points[2].y = {{"images", 4}};
  EXPECT_EQ(points_table(study).note,
            "At every point: images = 4. At every point that has the number: mass_change = 0.");
}

TEST(Table, FitsSayWindowIntervalAndFloor) {
  const auto table = fits_table(synthetic::convergence());
  EXPECT_THAT(table.groups[2].rows[0],
              testing::ElementsAre("l2", "16 to 128", "4", "2.02 ± 0.03", "0.15", "0.99980", "yes", "8 to 128",
                                   "E0 = 1.1e-06, order 2.02: residual 0.3 % against 21 %"));
}

TEST(Csv, AFittedErrorHasItsOrderFromThePointBefore) {
  const std::string text = csv_tables(synthetic::convergence()).at("bar-bases.csv");
  EXPECT_THAT(text, testing::ContainsRegex("\"bspline2, 4 PPC\",8,ok,[0-9.e-]+,[0-9.e-]+,,"));
  EXPECT_THAT(text, testing::ContainsRegex("\"bspline2, 4 PPC\",16,ok,[0-9.e-]+,[0-9.e-]+,2\\.0(1|0999999)"));
}

TEST(Table, FitsSayHowManyPointsOfTheWindowTheyTake) {
  auto study = synthetic::convergence();
  study.series[0].orders[0].points = 2;
  const auto row = fits_table(study).groups[0].rows[0];
  EXPECT_EQ(row[2], "2 of 4");
  EXPECT_EQ(row[5], "–") << "a line through two points";
  EXPECT_EQ(fits_table(study).groups[1].rows[0][2], "4");
}

TEST(Table, ExtrapolationsNameWhatIsSwept) {
  auto study = synthetic::convergence();
  study.series[0].extrapolations = {{"l2", 0.1, 0.4, 4, "φ0 + α h", 1, 2e-3, 0, 3e-3, 1e-3}};
  EXPECT_THAT(extrapolations_table(study).caption,
              HasSubstr("to h = 0, with the uncertainty of the value of the finest"));
  EXPECT_THAT(extrapolations_table(study).columns, testing::IsSupersetOf({"grids", "finest grid"}));
  study.sweep = "cfl";
  const Table table = extrapolations_table(study);
  EXPECT_THAT(table.caption, HasSubstr("to cfl = 0, with the uncertainty of the value of the smallest cfl"));
  EXPECT_THAT(table.columns, testing::IsSupersetOf({"points", "smallest cfl"}));
  EXPECT_THAT(table.note, HasSubstr("Here h stands for the Courant number."));
}

TEST(Table, EnergiesHaveTheUnitOfTheirDimension) {
  records::StudyResult study;
  study.sweep = "cells";
  study.series = {records::Series{"a", {}, {}, {}}};
  for (const double n : {1.0, 2.0})
    study.series[0].points.push_back({n, records::Status::ok, "", {{"l2", 0.1 / n}, {"initial_total", 593}}});
  EXPECT_THAT(points_table(study, 2).note, HasSubstr("initial_total = 593 J/m."));
  EXPECT_THAT(points_table(study, 1).note, HasSubstr("initial_total = 593 J/m²."));
  EXPECT_THAT(points_table(study, 3).note, HasSubstr("initial_total = 593 J."));
}

TEST(Table, FitsSayWhichErrorsTheyLeaveOutAndWhy) {
  auto study = synthetic::convergence();
  EXPECT_THAT(fits_table(study).note, testing::Not(testing::HasSubstr("Left out")));
  const auto fitted = std::ranges::find_if(study.series, [](const auto& series) { return !series.orders.empty(); });
  fitted->points.back().y["solution_floor"] = fitted->points.back().y.at(fitted->orders.front().norm);
  EXPECT_THAT(fits_table(study).note,
              testing::HasSubstr("512 (within 10 times the error of the solution, which is not exact for the law)"));
}

TEST(Table, CheapestSeriesOfEachPowerOfTen) {
  records::StudyResult study;
  study.series = {records::Series{"first order", {}, {}, {}}, records::Series{"second order", {}, {}, {}}};
  for (const double n : {1.0, 10.0, 100.0}) {
    study.series[0].points.push_back({n, records::Status::ok, "", {{"l2", 0.1 / n}, {"step_seconds", n}}});
    study.series[1].points.push_back({n, records::Status::ok, "", {{"l2", 1 / (n * n)}, {"step_seconds", 4 * n}}});
  }
  EXPECT_TRUE(cheapest_table(study).empty()) << "no figure asks for it";
  records::Figure figure;
  figure.name = "x-cost", figure.kind = records::Figure::Kind::work_precision;
  study.figures = {figure};
  const auto table = cheapest_table(study);
  ASSERT_EQ(table.groups.size(), 1u);
  const auto& rows = table.groups[0].rows;
  ASSERT_EQ(rows.size(), 5u) << "1 to 1e-4";
  EXPECT_THAT(rows[0], testing::ElementsAre("1e+00", "first order", "1", "–", "second order", "4", "4.00", "0 of 2"));
  EXPECT_THAT(rows[3],
              testing::ElementsAre("1e-03", "first order", "100", "–", "second order", "126.5", "1.26", "0 of 2"));
  EXPECT_THAT(rows[4], testing::ElementsAre("1e-04", "second order", "400", "–", "–", "–", "–", "1 of 2"));
}

TEST(Table, LongCurvesStayInTheCsvFile) {
  EXPECT_TRUE(points_table(synthetic::check()).empty());
  EXPECT_EQ(values_table(synthetic::check()).groups[0].rows[1][1], "–");
}

TEST(Table, TheNoteCountsTheSeriesThatAreTooLong) {
  auto study = synthetic::convergence();
  for (int n = 0; n <= 40; ++n) study.series[0].points.push_back(study.series[0].points[0]);
  const auto table = points_table(study);
  EXPECT_EQ(table.groups.size(), 4u);
  EXPECT_THAT(table.note, HasSubstr("In the CSV file alone: 1 series of more than 40 points."));
  EXPECT_THAT(points_table(synthetic::convergence()).note, testing::Not(HasSubstr("alone")));
}

TEST(Table, EnergyLossIsAShare) {
  records::StudyResult study;
  study.sweep = "order";
  study.series = {records::Series{"a", {}, {}, {}}};
  for (const double k : {1.0, 2.0})
    study.series[0].points.push_back({k, records::Status::ok, "", {{"energy_loss", 0.1 / k}}});
  EXPECT_THAT(points_table(study).columns, testing::ElementsAre("order", "energy_loss (of the initial energy)"));
}

TEST(Table, FitsSayThatTheyAreInTheSweptValue) {
  auto study = synthetic::convergence();
  const std::string fit = "The fit is C s^order over the window, s being ";
  EXPECT_THAT(fits_table(study).note, HasSubstr(fit + "the cell width h. "));
  for (const auto& [sweep, step] : {std::pair("dt", "dt"), {"cfl", "the Courant number"}, {"ppc", "1/ppc"}}) {
    study.sweep = sweep;
    EXPECT_THAT(fits_table(study).note, HasSubstr(fit + step + ". "));
  }
}

TEST(Table, AFitWithoutPointsHasDashesAndNoNan) {
  records::StudyResult study;
  study.series = {{"a", {}, {fits::ObservedOrder{}}, {}}};
  const std::string text = latex_tables({fits_table(study)});
  EXPECT_THAT(text, AllOf(HasSubstr("& --"), testing::Not(HasSubstr("nan"))));
}

}  // namespace mpmvv::reports::table_test
