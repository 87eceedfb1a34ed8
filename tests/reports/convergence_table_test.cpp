#include "reports/convergence_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "reports/latex_table.hpp"
#include "reports/norm_symbol.hpp"
#include "reports/orders_table.hpp"
#include "studies/records/record.hpp"
#include "studies/support/process.hpp"
#include "tests/reports/distinct.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports::convergence_table_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::ptrdiff_t count(const std::string& text, const std::string& part) {
  std::ptrdiff_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Two series of second order, of which the second loses a level.
records::StudyResult two_series() {
  records::StudyResult study = synthetic::convergence();
  study.text = "[fixed]\nproblem = \"bar\"\n";
  study.series = {synthetic::power_law("a_1, 50 %", 0.3, 2, 0), synthetic::power_law("gimp", 0.6, 2, 0, {32})};
  study.series[1].orders[0].points = 3;
  study.figures.clear();
  return study;
}

TEST(ConvergenceTable, HasErrorsOrdersAndFits) {
  const std::string text = latex_convergence_tables(two_series());
  EXPECT_THAT(text, testing::ContainsRegex("begin.tabular..@..l[^\n]*r[^\n]*r[^\n]*r[^\n]*r@..}\n.toprule\n"));
  EXPECT_THAT(text, HasSubstr("{\\centering $a$$_{1}$, 50 \\%}} & "));
  EXPECT_THAT(text, HasSubstr("cells & $\\ell_2$ & order & $\\ell_2$ & order \\\\\n"));
  EXPECT_THAT(text, HasSubstr("$8$ & $4.69 \\times 10^{-3}$ & -- & $9.37 \\times 10^{-3}$ & -- \\\\\n"));
  EXPECT_THAT(text, HasSubstr("$32$ & $2.93 \\times 10^{-4}$ & $2.00$ & unstable & -- \\\\\n"));
  EXPECT_THAT(text, HasSubstr("$16$ to $128$ & \\multicolumn{2}{c}{$2.00 \\pm 0.03$} & "
                              "\\multicolumn{2}{c}{$2.00 \\pm 0.03$$^*$} \\\\\n"));
}

TEST(ConvergenceTable, TheCaptionSaysProblemNormAndOrder) {
  records::StudyResult study = two_series();
  EXPECT_THAT(latex_convergence_tables(study),
              AllOf(HasSubstr("\\caption{Bar: order of the bases $<$S \\& W$>$ (problem bar). Errors are $\\ell_2 = "),
                    HasSubstr("that in the cell width $h$"), HasSubstr("a star marks"), HasSubstr("gimp (3 of 4)"),
                    HasSubstr("\\label{tab:bar-bases-l2}")));
  study.sweep = "cfl", study.text = "no TOML [", study.series.pop_back();
  EXPECT_THAT(latex_convergence_tables(study), AllOf(HasSubstr("that in the Courant number"), HasSubstr("CFL & "),
                                                     Not(HasSubstr("problem")), Not(HasSubstr("a star"))));
}

TEST(ConvergenceTable, TheCaptionNamesTheProblemOfAllSeriesAlone) {
  records::StudyResult study = two_series();
  const std::string fixed = "[fixed]\nproblem = \"bar\"\n", first = "[[series]]\nname = \"a_1, 50 %\"\n",
                    second = "[[series]]\nname = \"gimp\"\n", ring = "problem = \"ring\"\n";
  study.text = fixed + first + ring + second + ring;
  EXPECT_THAT(latex_convergence_tables(study), HasSubstr("(problem ring)")) << "every series has its own";
  study.text = fixed + first + second + ring;
  EXPECT_THAT(latex_convergence_tables(study), Not(HasSubstr("(problem")));
  study.text +=
      "# mpmvv study --set: problem = square in 2 of 2 series\n# mpmvv study --set: ppc = 2 in 1 of 2 series\n";
  EXPECT_THAT(latex_convergence_tables(study), AllOf(HasSubstr("(problem square)"), HasSubstr("ppc = 2 in 1 of 2")));
  study.text = fixed + first + second + "# mpmvv study --set: problem = square in 1 of 2 series\n";
  EXPECT_THAT(latex_convergence_tables(study),
              AllOf(Not(HasSubstr("(problem")), HasSubstr("problem = square in 1 of 2 series")));
}

TEST(ConvergenceTable, ShowsSeriesThatAreUnstableEverywhere) {
  records::StudyResult study = two_series();
  for (records::Point& point : study.series[1].points) point.status = records::Status::unstable, point.y.clear();
  study.series[1].orders.clear();
  EXPECT_THAT(latex_convergence_tables(study), AllOf(HasSubstr("gimp"), HasSubstr("$8$ & $4.69 \\times 10^{-3}$ & -- & "
                                                                                  "unstable & -- \\\\\n")));
}

TEST(ConvergenceTable, LeavesOutSeriesThatDoNotMeasureTheNorm) {
  records::StudyResult study = two_series();
  for (records::Point& point : study.series[1].points) point.y.clear();
  study.series[1].orders.clear();
  ASSERT_EQ(study.series[1].points[2].status, records::Status::unstable);
  EXPECT_THAT(latex_convergence_tables(study), Not(HasSubstr("gimp")));
}

/// Eighteen series, five of which have fits of fewer points, which the caption tells.
records::StudyResult long_names() {
  records::StudyResult study = two_series();
  study.series.assign(18, study.series[0]);
  for (std::size_t k = 0; k < study.series.size(); ++k) {
    study.series[k].name =
        "linear with integrator usl and FLIP update on periodic grid (case number " + std::to_string(k) + ")";
    if (k % 4 == 0) study.series[k].orders[0].points = 3;
  }
  return study;
}

TEST(ConvergenceTable, NamesOfSeveralLinesLeaveRoomForFewerRowsOfSeries) {
  records::StudyResult study = long_names();
  EXPECT_EQ(count(latex_convergence_tables(study), "\\begin{table}"), 3);
  for (records::Series& series : study.series) series.name = "short";
  EXPECT_EQ(count(latex_convergence_tables(study), "\\begin{table}"), 2);
}

/// Levels that differ from series to series, so that together they are more than a page has room for.
records::StudyResult many_levels() {
  records::StudyResult study = two_series();
  for (int k = 0; k < 10; ++k) {
    study.series.push_back(study.series[0]);
    for (records::Point& point : study.series.back().points) point.x += k + 1;
  }
  return study;
}

TEST(ConvergenceTable, LevelsThatAPageHasNoRoomForStandInPieces) {
  const std::string text = latex_convergence_tables(many_levels());
  EXPECT_EQ(count(text, "\\begin{tabular}"), 3 * 2) << "twelve series, four abreast, and their levels in two pieces";
  EXPECT_EQ(count(text, "\\begin{table}"), 6);
  EXPECT_EQ(count(text, "As Table~\\ref{tab:bar-bases-l2}, of further rows."), 1);
  EXPECT_EQ(count(text, "As Table~\\ref{tab:bar-bases-l2}, of further series."), 4);
  EXPECT_EQ(count(text, "$512$ & "), 3) << "each level once for each four series";
  EXPECT_EQ(count(text, "$16$ to $128$ & "), 3);
  EXPECT_LT(text.find("$512$ & "), text.find("$16$ to $128$ & ")) << "fitted orders stand below the last levels";
}

TEST(ConvergenceTable, FourSeriesStandAbreast) {
  records::StudyResult study = two_series();
  for (int k = 0; k < 3; ++k) study.series.push_back(study.series[0]);
  const std::string text = latex_convergence_tables(study);
  EXPECT_EQ(count(text, "\\begin{tabular}"), 2) << "three and two";
  EXPECT_EQ(count(text, "cells & $\\ell_2$ & order & $\\ell_2$ & order & $\\ell_2$ & order \\\\\n"), 1);
  EXPECT_EQ(count(text, "cells & $\\ell_2$ & order & $\\ell_2$ & order \\\\\n"), 1);
  EXPECT_EQ(count(text, "\\begin{table}"), 1);
  for (int k = 0; k < 20; ++k) study.series.push_back(study.series[0]);
  EXPECT_EQ(count(latex_convergence_tables(study), "\\begin{table}"), 2) << "a page has room for four rows of series";
  EXPECT_THAT(latex_convergence_tables(study), HasSubstr("As Table~\\ref{tab:bar-bases-l2}, of further series."));
}

TEST(ConvergenceTable, ThreeStandAbreastWhereWindowsHaveLongNames) {
  records::StudyResult study = two_series();
  study.series.insert(study.series.end(), 2, study.series[0]);
  EXPECT_EQ(count(latex_convergence_tables(study), "\\begin{tabular}"), 1);
  study.series[0].orders[0].from = 0.0125, study.series[0].orders[0].to = 0.05;
  EXPECT_EQ(count(latex_convergence_tables(study), "\\begin{tabular}"), 2);
}

TEST(ConvergenceTable, WhatIsDrawnAloneHasNoOrders) {
  records::StudyResult study = two_series();
  for (records::Series& series : study.series) series.orders.clear();
  EXPECT_EQ(latex_convergence_tables(study), "");
  study.figures = {distinct::figure("f", records::Figure::Kind::work_precision)};
  study.figures[0].quantity = "linf";
  EXPECT_THAT(latex_convergence_tables(study),
              AllOf(HasSubstr("cells & $\\ell_\\infty$ & $\\ell_\\infty$ \\\\\n"), Not(HasSubstr("The order"))));
}

TEST(NormSymbol, EveryNormHasOneOfItsOwn) {
  std::set<std::string> symbols;
  for (const std::string& norm : records::norm_words()) {
    const NormSymbol symbol = norm_symbol(norm);
    EXPECT_TRUE(symbols.insert(symbol.symbol).second) << norm;
    EXPECT_THAT(symbol.symbol, testing::MatchesRegex("[$].*[$]"));
    EXPECT_THAT(symbol.definition, testing::StartsWith(symbol.symbol.substr(0, symbol.symbol.size() - 1)));
    const std::string unit = records::unit_of(norm);
    EXPECT_THAT(symbol.definition, HasSubstr(unit == "m/s2" ? "m/s$^2$" : unit == "%" ? "per cent" : unit));
  }
}

/// A study with orders, and extrapolated values, in every norm.
records::StudyResult all_norms() {
  records::StudyResult study = synthetic::convergence();
  records::Series& series = study.series[1];
  fits::ObservedOrder order = series.orders[0];
  order.order = -0.14, order.half_width = 0.63, order.floor = fits::FloorFit{1, 2, 3.2e-7, 1e-3, true, ""};
  series.orders.clear();
  for (const std::string& norm : records::norm_words()) {
    order.norm = norm;
    series.orders.push_back(order);
    series.extrapolations.push_back({norm, 0.0125, 0.05, 4, "φ0 + α h^p", -2.03, -2.345e-13, 1.23e-12, 3.4e-13, 1e-3});
  }
  study.sweep = "wall_depth";
  return study;
}

/// No box is overfull at the narrowest text that the tables are for, and no table is longer than a page.
TEST(ConvergenceTableNightly, FitsInto125Millimetres) {
  const TempFolder folder;
  const records::StudyResult study = all_norms();
  std::ofstream(folder / "table.tex") << latex_convergence_tables(study) << latex_convergence_tables(two_series())
                                      << latex_convergence_tables(many_levels())
                                      << latex_convergence_tables(long_names())
                                      << latex_long_table(orders_table({&study}))
                                      << latex_long_table(extrapolated_table({&study}));
  std::ofstream(folder / "main.tex") << "\\documentclass{article}\\usepackage[textwidth=125mm]{geometry}\n"
                                        "\\usepackage{amsmath,booktabs,longtable,tabularx}\n"
                                        "\\begin{document}\\input{table}\\end{document}\n";
  const auto end = support::run_process({"pdflatex", "-halt-on-error", "-interaction=nonstopmode", "main.tex"},
                                        folder.path(), {}, std::chrono::seconds(60));
  if (end.start_error != 0) GTEST_SKIP() << "no pdflatex";
  EXPECT_TRUE(end.good()) << end.output;
  for (const char* complaint : {"Overfull", "Float too large"}) EXPECT_THAT(end.output, Not(HasSubstr(complaint)));
}

}  // namespace mpmvv::reports::convergence_table_test
