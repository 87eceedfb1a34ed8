#include "reports/latex_table.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "reports/orders_table.hpp"
#include "studies/support/process.hpp"
#include "tests/reports/matches.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports::latex_table_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(LatexCell, NumbersAreMathematics) {
  EXPECT_EQ(latex_cell("1.23e-04"), "$1.23 \\times 10^{-4}$");
  EXPECT_EQ(latex_cell("1e-03"), "$10^{-3}$");
  EXPECT_EQ(latex_cell("2.50e+00"), "$2.50$");
  EXPECT_EQ(latex_cell("-0.14"), "$-0.14$");
  EXPECT_EQ(latex_cell("-0.14 ± 0.63"), "$-0.14 \\pm 0.63$");
  EXPECT_EQ(latex_cell("inf"), "$\\infty$");
  EXPECT_EQ(latex_cell("–"), "--");
  EXPECT_EQ(latex_cell("50 % of stress_error"), "50 \\% of stress\\_error");
}

TEST(LatexLine, NoCellIsAnArgumentOfTheLineBefore) {
  EXPECT_EQ(latex_line({"[7] ring", "1"}), "{}[7] ring & 1 \\\\\n");
  EXPECT_EQ(latex_line({"*", "1"}), "{}* & 1 \\\\\n");
  EXPECT_EQ(latex_line({"a", "b"}), "a & b \\\\\n");
}

TEST(LatexTables, TextIsEscapedAndTheTableIsWhole) {
  const auto text = latex_head("Bar & more") + latex_tables(tables_of(synthetic::convergence()));
  EXPECT_THAT(text, AllOf(HasSubstr("% Bar \\& more\n"), HasSubstr("\\toprule"), HasSubstr("\\bottomrule"),
                          HasSubstr("bspline3-open \\{a\\textasciicircum{}2\\}"), HasSubstr("linear\\_periodic"),
                          HasSubstr("$2.02 \\pm 0.03$"), HasSubstr("det $F$ $<$= 0")));
  std::istringstream lines(text);
  std::size_t columns = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("\\begin{tabular")) {
      const std::string types = replace_all(line, ">{\\raggedright\\arraybackslash}", "");
      columns = matches(types.substr(types.rfind('{')), "([lX])").size();
    }
    if (line.ends_with(" \\\\") && !line.starts_with("\\multicolumn")) {
      EXPECT_EQ(matches(line, "([^\\\\]&)").size(), columns - 1) << line;
    }
  }
  EXPECT_GT(columns, 0U);
}

TEST(LatexTables, ProseSharesTheRestOfTheLine) {
  const Table table{"c", {"name", "meaning"}, {{"", {{"a", "what a text of more than twenty letters says"}}}}};
  EXPECT_THAT(latex_tables({table}), HasSubstr("\\begin{tabularx}{\\linewidth}{l>{\\raggedright\\arraybackslash}X}"));
  EXPECT_THAT(latex_tables({Table{"c", {"a", "b"}, {{"", {{"1", "2"}}}}}}), HasSubstr("\\begin{tabular}{ll}"));
}

/// The text takes 125 mm, 355 points; a letter some 4.4.
TEST(LatexTables, WhereTheLineIsTooShortTheColumnsThatGainMostAreBroken) {
  Table table{"c", {"series", "growth seen", "key", "number"}, {{"", {{"6 PPC, 512 cells", "2 %", "k", "1"}}}}};
  EXPECT_THAT(latex_tables({table}), HasSubstr("\\begin{tabular}{llll}"));
  table.groups[0].rows[0][2] = std::string(20, 'k');
  for (int k = 0; k < 4; ++k) {
    table.columns.emplace_back("stable");
    table.groups[0].rows[0].emplace_back("0.04");
  }
  const std::string broken = ">{\\raggedright\\arraybackslash}X";
  EXPECT_THAT(latex_tables({table}), HasSubstr("{\\linewidth}{" + broken + "lllllll}"));
  for (int k = 0; k < 3; ++k) {
    table.columns.emplace_back("b");
    table.groups[0].rows[0].emplace_back("0.04");
  }
  EXPECT_THAT(latex_tables({table}), HasSubstr("{\\linewidth}{" + broken + broken + "lllllllll}"));
  table.groups[0].rows[0][2] = std::string(45, 'k');
  EXPECT_THAT(latex_tables({table}), HasSubstr("{\\linewidth}{ll" + broken + "llllllll}"))
      << "all that are broken would have to be as wide as the long word";
}

TEST(LatexTables, APageHasRoomForAPiece) {
  Table table{"c", {"a", "b"}, {{"first", {}}, {"second", {}}}, "said of all"};
  for (int k = 0; k < 30; ++k) table.groups[k < 20 ? 0 : 1].rows.push_back({fmt::format("row {}", k), "1"});
  const std::string text = latex_tables({table});
  const auto begin = text.find("\\begin{tabular}"), next = text.find("\\begin{tabular}", begin + 1);
  ASSERT_NE(next, std::string::npos);
  EXPECT_EQ(text.find("\\begin{tabular}", next + 1), std::string::npos);
  EXPECT_LT(text.find("row 14 &"), next);
  EXPECT_LT(text.find("\\emph{first}", next), text.find("row 15 &")) << "its group is named again";
  EXPECT_EQ(text.find("said of all"), text.rfind("said of all")) << "once";
}

TEST(LatexLongTable, ExplainsNormsAndLeavesOutEmptyColumns) {
  const Table table{"Orders", {"series", "norm", "order", "floor"}, {{"study", {{"a", "linf", "1.98", "–"}}}}};
  const std::string text = latex_long_table(table);
  EXPECT_THAT(text, AllOf(HasSubstr("a & $\\ell_\\infty$ & $1.98$ \\\\\n"), HasSubstr("series & norm & order \\\\\n"),
                          HasSubstr("$\\ell_\\infty = \\max_p\\delta_p$, the maximum over"), Not(HasSubstr("floor"))));
  EXPECT_EQ(latex_long_table({}), "");
}

TEST(LatexTablesNightly, Compile) {
  const TempFolder folder;
  auto check = synthetic::check();
  check.values.push_back(
      {"characters", 1, "αβγδΔελμµνπρσΣτφΦΨω∇∞±×·−≤≥≈≠→√°½¼⁰¹²³⁴⁻₀₁₂ₚ–—…‘’“” éñÅß Đ✓ _^~\\{}$&#%<>|\"'"});
  for (const auto& study : {synthetic::convergence(), synthetic::limits(), check}) {
    std::ofstream(folder / "table.tex") << latex_head(study.title) << latex_tables(tables_of(study))
                                        << latex_long_table(orders_table({&study}));
    std::ofstream(folder / "main.tex") << "\\documentclass{article}\\usepackage{amsmath,booktabs,longtable,tabularx}\n"
                                          "\\begin{document}\\input{table}\\end{document}\n";
    const auto end = support::run_process({"pdflatex", "-halt-on-error", "-interaction=nonstopmode", "main.tex"},
                                          folder.path(), {}, std::chrono::seconds(60));
    if (end.start_error != 0) GTEST_SKIP() << "no pdflatex";
    EXPECT_TRUE(end.good()) << end.output;
  }
}

}  // namespace mpmvv::reports::latex_table_test
