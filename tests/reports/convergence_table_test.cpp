#include "reports/convergence_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "reports/norm_symbol.hpp"
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

/// No box is overfull at the narrowest text that the tables are for.
TEST(ConvergenceTableNightly, FitsInto125Millimetres) {
  const TempFolder folder;
  records::StudyResult study = synthetic::convergence();
  study.series[1].orders[0].order = -0.14, study.series[1].orders[0].half_width = 0.63;
  std::ofstream(folder / "table.tex") << latex_convergence_tables(study) << latex_convergence_tables(two_series());
  std::ofstream(folder / "main.tex") << "\\documentclass{article}\\usepackage[textwidth=125mm]{geometry}\n"
                                        "\\usepackage{amsmath,booktabs,longtable,tabularx}\n"
                                        "\\begin{document}\\input{table}\\end{document}\n";
  const auto end = support::run_process({"pdflatex", "-halt-on-error", "-interaction=nonstopmode", "main.tex"},
                                        folder.path(), {}, std::chrono::seconds(60));
  if (end.start_error != 0) GTEST_SKIP() << "no pdflatex";
  EXPECT_TRUE(end.good()) << end.output;
  EXPECT_THAT(end.output, Not(HasSubstr("Overfull")));
}

}  // namespace mpmvv::reports::convergence_table_test
