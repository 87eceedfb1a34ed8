#include "reports/paper.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "reports/latex_table.hpp"
#include "reports/orders_table.hpp"
#include "studies/support/error.hpp"
#include "studies/support/process.hpp"
#include "tests/reports/distinct.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports::paper_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

store::Provenance provenance() {
  store::Provenance p;
  p.commit = "0123456789abcdef", p.time = "2026-03-04T05:06:07Z";
  p.digest = "dd00", p.compiler = "GNU 12.2.0", p.flags = "-O2 --fast", p.build_type = "Release";
  return p;
}

Provenances provenances(const std::vector<records::StudyResult>& studies) {
  Provenances all;
  for (const auto& study : studies) all[study.name] = provenance();
  return all;
}

Sheet column() {
  Sheet sheet;
  sheet.format = Format::tex;
  return sheet;
}

PaperSummary write(const std::vector<records::StudyResult>& studies, const fs::path& folder) {
  return write_paper(studies, provenances(studies), folder, column());
}

/// A study under the name of one of S's, with the two panels of a figure of S.
records::StudyResult of_s() {
  records::StudyResult study = distinct::laws();
  study.name = "s-fig9";
  study.figures = {distinct::figure("s-fig9a", records::Figure::Kind::curves),
                   distinct::figure("s-fig9b", records::Figure::Kind::curves)};
  study.figures[0].caption = "Error for l = h/2 & more";
  return study;
}

TEST(Paper, FiguresOfThePapersComeFirstAndInTheirPanels) {
  const TempFolder folder;
  const PaperSummary summary = write({distinct::curves(), of_s()}, folder.path());
  EXPECT_EQ(summary.figures, 3);
  EXPECT_EQ(summary.figures_drawn, 3);
  EXPECT_EQ(summary.tables, 2) << "orders, and the errors of a study";
  const std::string text = content(folder / "main.tex");
  EXPECT_THAT(text, AllOf(HasSubstr("\\panel{84mm}{s-fig9a}{(a)\\\\}\\hfill"), HasSubstr("\\panel{84mm}{s-fig9b}{(b)"),
                          HasSubstr("\\caption{S Fig. 9. (a) Error for $l$ = $h$/2 \\& more (b) Caption of s-fig9b}"),
                          HasSubstr("\\input{tables/orders-S}"), HasSubstr("\\input{tables/errors-s-fig9}"),
                          HasSubstr("mpmvv 0123456789ab, 2026-03-04"), HasSubstr("commit & 0123456789abcdef \\\\\n"),
                          HasSubstr("digest & dd00 \\\\\n"), HasSubstr("compiler & GNU 12.2.0, Release \\\\\n"),
                          HasSubstr("flags & -O2 -{}-fast \\\\\n")));
  EXPECT_LT(text.find("{s-fig9a}"), text.find("{curves}"));
  EXPECT_THAT(text, Not(HasSubstr("\\section{Nairn"))) << "the store has nothing of that paper";
  EXPECT_TRUE(fs::exists(folder / "figures/s-fig9a.tex") && fs::exists(folder / "figures/s-fig9a.pdf"));
}

TEST(Paper, CaptionsDoNotCompareAFigureWithItself) {
  const TempFolder folder;
  records::StudyResult study = of_s();
  const auto caption_of = [&](const std::string& caption) {
    study.figures[0].caption = caption;
    write({study}, folder.path());
    const std::string text = content(folder / "main.tex"), begin = "\\caption{S Fig. 9. (a) ";
    const auto from = text.find(begin) + begin.size();
    return text.substr(from, text.find(" (b) ", from) - from);
  };
  EXPECT_EQ(caption_of("An error. Compare S Fig. 9(a)."), "An error.");
  EXPECT_EQ(caption_of("An error. Compare B Fig. 16.4, left. Of ours."), "An error. Of ours.");
  EXPECT_EQ(caption_of("An error. Compare S Fig. 9 and ours."), "An error. Compare S Fig. 9 and ours.");
  EXPECT_EQ(caption_of("An error. Compare N section 2."), "An error. Compare N section 2.");
  const std::string endless = "An error. Compare S Fig. " + std::string(200'000, '7');
  EXPECT_EQ(caption_of(endless), endless);
}

TEST(Paper, SaysWhatOfAPaperIsNotDrawnAndWhy) {
  const TempFolder folder;
  const auto without = write({of_s()}, folder.path()).without;
  EXPECT_THAT(without, Contains("S Fig. 1 is not drawn: a sketch of the method."));
  EXPECT_THAT(without, Contains("S Fig. 10 is not drawn: the store has no figure s-fig10."));
  EXPECT_THAT(without, Not(Contains(HasSubstr("S Fig. 9"))));
  EXPECT_THAT(content(folder / "main.tex"), HasSubstr("S Fig. 1 is not drawn"));
}

TEST(Paper, SaysOfWhichPapersTheStoreHasNothing) {
  const TempFolder folder;
  EXPECT_THAT(write({of_s()}, folder.path()).without,
              Contains(testing::StartsWith("The store has neither figures nor tables of: Nairn")));
  const std::string text = content(folder / "main.tex");
  EXPECT_THAT(text, AllOf(HasSubstr("\\medskip The store has neither figures nor tables of: Nairn"),
                          Not(HasSubstr("tables of: Steffen"))));
  EXPECT_LT(text.find("tables of: Nairn"), text.find("\\section"));
  EXPECT_TRUE(write({distinct::curves()}, folder.path()).without.empty()) << "a store of other studies alone";
  EXPECT_THAT(content(folder / "main.tex"), Not(HasSubstr("Nairn")));
}

TEST(Paper, OfTwoPanelsTheOneThatIsThereHasNoLetter) {
  const TempFolder folder;
  records::StudyResult study = of_s();
  study.figures.erase(study.figures.begin());
  EXPECT_THAT(write({study}, folder.path()).without,
              Contains("S Fig. 9 is not wholly drawn: the store has no figure s-fig9a."));
  EXPECT_THAT(content(folder / "main.tex"),
              AllOf(HasSubstr("\\panel{84mm}{s-fig9b}{}"), HasSubstr("\\caption{S Fig. 9. Caption of s-fig9b}")));
}

TEST(Paper, NamesAreNoFormulas) {
  records::StudyResult study = distinct::laws();
  study.name = study.figures[0].name = "a_b", study.sweep = "h_p", study.title = "laws";
  store::Provenance made = provenance();
  made.commit = "59e7e5289b0123456789";
  const TempFolder folder;
  write_paper({study}, {{"a_b", made}}, folder.path(), column());
  EXPECT_THAT(content(folder / "main.tex"),
              AllOf(HasSubstr("\nmpmvv 59e7e5289b01, 2026"), HasSubstr("\\caption{a\\_b. Caption of laws}")));
  EXPECT_THAT(content(folder / "tables/orders-further.tex"), HasSubstr("\\emph{a\\_b (h\\_p): laws}"));
}

TEST(Paper, SaysWhereTheStudiesThatItShowsComeFrom) {
  const TempFolder folder;
  const std::vector<records::StudyResult> studies{distinct::curves(), distinct::laws(), of_s()};
  Provenances from = provenances(studies);
  from.at("laws").dirty = true, from.at("laws").cpu = "another", from.at("laws").time = "2026-03-05";
  write_paper(studies, from, folder.path(), column());
  EXPECT_THAT(content(folder / "main.tex"),
              AllOf(HasSubstr("\nmpmvv 0123456789ab-dirty, 0123456789ab, 2026-03-05\n"),
                    HasSubstr("0123456789abcdef with changes"), HasSubstr("processor & another "),
                    HasSubstr("results & 1 study, the newest of 2026-03-05 "),
                    HasSubstr("results & 2 studies, the newest of 2026-03-04 ")));
  write_paper(studies, from, folder.path(), column(), {"curves"});
  EXPECT_THAT(content(folder / "main.tex"), AllOf(HasSubstr("\nmpmvv 0123456789ab, 2026-03-04\n"),
                                                  HasSubstr("results & 1 study, "), Not(HasSubstr("another"))));
}

TEST(Paper, NamesChooseFiguresAndTheirOrder) {
  const TempFolder folder;
  const auto named = [&](const std::vector<std::string>& names) {
    write_paper({distinct::curves(), distinct::laws(), of_s()}, {}, folder.path(), column(), names);
    return content(folder / "main.tex");
  };
  const std::string both = named({"s-fig9b", "laws"});
  EXPECT_LT(both.find("{s-fig9b}"), both.find("{laws}"));
  EXPECT_LT(both.find("{tables/errors-s-fig9}"), both.find("{tables/errors-laws}"));
  EXPECT_THAT(both, AllOf(Not(HasSubstr("{s-fig9a}")), Not(HasSubstr("{curves}")), HasSubstr("{tables/orders-named}")));
  const std::string other = named({"laws", "laws", "s-fig9"});
  EXPECT_LT(other.find("{laws}"), other.find("{s-fig9a}"));
  EXPECT_EQ(other.find("{laws}"), other.rfind("{laws}")) << "once";
  EXPECT_THROW(named({"law"}), support::UsageError);
}

TEST(Paper, AStudyWithoutAFigureIsNamedForItsTables) {
  const TempFolder folder;
  auto study = distinct::laws();
  study.figures.clear();
  const auto summary = write_paper({study}, {}, folder.path(), column(), {"laws"});
  EXPECT_EQ(summary.figures, 0);
  EXPECT_EQ(summary.tables, 2);
}

TEST(Paper, ExtrapolatedValuesHaveATable) {
  auto study = distinct::laws();
  study.sweep = "dt";
  study.series[0].extrapolations = {{"l2", 0.1, 0.4, 4, "φ0 + α h", 1, 2.345e-3, 0, 3e-3, 1e-3}};
  const TempFolder folder;
  write({study}, folder.path());
  EXPECT_THAT(content(folder / "main.tex"), HasSubstr("\\input{tables/extrapolations-further}"));
  EXPECT_THAT(content(folder / "tables/extrapolations-further.tex"),
              HasSubstr("law 0 & $\\ell_2$ & 0.1 to 0.4 & dt = 0 & $0.00234$ & $0.003$ & $0.001$ \\\\\n"));
}

TEST(Paper, LimitsAndCostsHaveTables) {
  const TempFolder folder;
  auto limits = distinct::limits();
  limits.title = "Limits of 3 % & more";
  write({limits, distinct::costs()}, folder.path());
  EXPECT_THAT(content(folder / "main.tex"),
              AllOf(HasSubstr("\\input{tables/limits-limits}"), HasSubstr("\\input{tables/costs-costs}"),
                    Not(HasSubstr("{tables/limits-costs}"))));
  EXPECT_THAT(content(folder / "tables/limits-limits.tex"),
              AllOf(HasSubstr("Limits of 3 \\% \\& more. Stability limits."), HasSubstr("\\toprule")));
  EXPECT_THAT(content(folder / "tables/costs-costs.tex"), HasSubstr("Cheapest series for a given error"));
}

TEST(Paper, NamesTheVersionsOfOtherCodesThatItShows) {
  const auto code = [](const std::string& study, const std::string& name, const std::string& version) {
    return store::CodeSeries{study, "theirs", {name, version, "", "reference", "aa11"}, "2026-03-04T05:06:07Z"};
  };
  const std::vector codes{code("laws", "my_code", "1.3"), code("laws", "my_code", "1.3"), code("curves", "other", "2")};
  const TempFolder folder;
  const auto text = [&](const std::vector<std::string>& names) {
    write_paper({distinct::laws(), distinct::curves()}, {}, folder.path(), column(), names, codes);
    return content(folder / "main.tex");
  };
  EXPECT_THAT(text({}),
              AllOf(HasSubstr("my\\_code: \\texttt{1.3, digest aa11}"), HasSubstr("other: \\texttt{2, digest aa11}")));
  EXPECT_THAT(text({"laws"}), AllOf(HasSubstr("my\\_code: \\texttt{1.3"), Not(HasSubstr("other: "))));
}

TEST(Paper, RedrawsOnlyWhatChanged) {
  const TempFolder folder;
  auto studies = std::vector{of_s(), distinct::curves()};
  write(studies, folder.path());
  EXPECT_EQ(write(studies, folder.path()).figures_drawn, 0);
  studies[1].series[0].points[3].y["slope"] += 0.1;
  EXPECT_EQ(write(studies, folder.path()).figures_drawn, 1);
}

TEST(Paper, AFigureThatAColumnHasNoRoomForTakesTwo) {
  const TempFolder folder;
  auto study = distinct::limits();
  study.series[0].name = "a series of a stability map with a name of many words";
  write({study, distinct::curves()}, folder.path());
  EXPECT_THAT(content(folder / "main.tex"),
              AllOf(HasSubstr("\\panel{174mm}{limits}"), HasSubstr("\\panel{84mm}{curves}")));
}

TEST(Paper, OrdersStandInGroupsOfTheirStudies) {
  const records::StudyResult laws = distinct::laws(), curves = distinct::curves();
  const Table table = orders_table({&laws, &curves});
  ASSERT_EQ(table.groups.size(), 1u);
  EXPECT_EQ(table.groups[0].title, "laws (cells): ");
  EXPECT_THAT(table.groups[0].rows[0], ElementsAre("law 0", "l2", "12 to 62", "0 of 4", "1.07 ± 0.03", "–", "no"));
  EXPECT_THAT(table.groups[0].rows[2], ElementsAre("law 1", "l2", "7 to 21", "0 of 3", "2.13 ± 0.05", "0.0017", "no"));
  const std::string text = latex_long_table(table);
  EXPECT_THAT(text, AllOf(HasSubstr("law 0 & $\\ell_2$ & 12 to 62 & 0 of 4 & $1.07 \\pm 0.03$ & -- & no \\\\\n"),
                          testing::ContainsRegex("begin.longtable.[^\n]*llllll.\n"), HasSubstr("\\end{longtable}")));
  EXPECT_EQ(latex_long_table(orders_table({&curves})), "");
}

/// Two studies that share the name of a figure, which has a full stop and an underscore.
std::vector<records::StudyResult> awkward_names() {
  std::vector<records::StudyResult> studies{distinct::laws(), distinct::brackets()};
  for (auto& study : studies) study.figures[0].name = "fig_2.5+";
  studies[0].figures[0].xlabel = "[a label]", studies[1].figures[0].ylabel = "✓";
  studies[0].title = "50 % of $1 & #2 {a} ~ ^ \\ <b>";
  return studies;
}

/// The place in LaTeX's log; empty where it does not complain.
std::string said_about(const std::string& complaint, const std::string& log) {
  const auto place = log.find(complaint);
  return place == std::string::npos ? "" : log.substr(place, 300);
}

/// What latexmk says of the document; skips the test without it.
void expect_compiles(const TempFolder& folder) {
  const auto end = support::run_process({"latexmk", "-pdf", "-interaction=nonstopmode", "-halt-on-error", "main.tex"},
                                        folder.path(), {}, std::chrono::seconds(300));
  if (end.start_error != 0) GTEST_SKIP() << "no latexmk";
  EXPECT_TRUE(end.good()) << end.output;
  EXPECT_THAT(content(folder / "main.pdf"), testing::StartsWith("%PDF"));
  for (const char* complaint : {"Missing character", "undefined on input line", "Overfull", "too large for page"})
    EXPECT_EQ(said_about(complaint, content(folder / "main.log")), "");
}

TEST(PaperNightly, CompilesByOneCommand) {
  const TempFolder folder;
  auto studies = awkward_names();
  for (const auto& study : {synthetic::convergence(), synthetic::limits(), synthetic::check(), distinct::curves(),
                            distinct::limits(), distinct::costs(), distinct::particles(), of_s()})
    studies.push_back(study);
  write(studies, folder.path());
  expect_compiles(folder);
}

/// A table that runs over pages was set beyond the edge of one where figures before it still waited for a place.
TEST(PaperNightly, TablesBehindManyFiguresStayOnTheirPages) {
  const TempFolder folder;
  records::StudyResult study = synthetic::convergence();
  for (int k = 0; k < 4; ++k) {
    study.figures.push_back(study.figures[0]);
    study.figures.back().name += std::to_string(k);
  }
  write({study}, folder.path());
  EXPECT_THAT(content(folder / "main.tex"), testing::ContainsRegex("nofloats\n.input.tables/orders"));
  expect_compiles(folder);
}

}  // namespace mpmvv::reports::paper_test
