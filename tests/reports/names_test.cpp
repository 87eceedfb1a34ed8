#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <span>

#include "reports/csv.hpp"
#include "reports/plot.hpp"
#include "reports/report.hpp"
#include "reports/table.hpp"
#include "reports/text.hpp"
#include "tests/reports/matches.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports::names_test {

using records::StudyResult;

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// What people, or mischief, may call a series, and how a line of text shows it.
struct Name {
  std::string given, shown;
};

const std::vector<Name>& nasty_names() {
  static const std::vector<std::string> as_they_are{"'front",
                                                    "end'",
                                                    "in''side",
                                                    "''",
                                                    "'",
                                                    "\"a\" b\"",
                                                    "\\n \\047 \\",
                                                    "{/:Bold a}",
                                                    "a_b^{2}",
                                                    "@pi @",
                                                    "&amp; &",
                                                    "<b> <script>",
                                                    "100% %d %s %%",
                                                    "$x$ #1 ~",
                                                    "`date`",
                                                    "x]]>y",
                                                    "=1+1",
                                                    "+1",
                                                    "-a",
                                                    "Ünï ✓ δ",
                                                    "[a] *",
                                                    "--",
                                                    "{{title}} {{{svg}}} {{#gate}}",
                                                    "# a, b;c",
                                                    std::string(40, 'w')};
  static const std::vector<Name> names = [] {
    std::vector<Name> all{{"two\nlines\r\tand a tab", "two lines  and a tab"},
                          {std::string("n\0l", 3), "n\uFFFDl"},
                          {"\x1b[31m\a", "\uFFFD[31m\uFFFD"},
                          {"\xff\xfe\xc3", "\uFFFD\uFFFD\uFFFD"},
                          {"\x7f \uFFFE \u0085", "\uFFFD \uFFFD \uFFFD"},
                          {"\xed\xa0\x80 \xc0\xaf", "\uFFFD\uFFFD\uFFFD \uFFFD\uFFFD"}};
    for (const auto& name : as_they_are) all.push_back({name, name});
    return all;
  }();
  return names;
}

std::string unescaped(std::string text) {
  for (const auto& [entity, character] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&apos;", "'"}, {"&amp;", "&"}})
    text = replace_all(text, entity, character);
  return text;
}

/// The texts of a figure, without the spaces around them.
std::vector<std::string> texts_of(const std::string& svg) {
  static const std::regex text("<text[^>]*>(.*)</text>"), tag("<[^>]*>"), ends("^ +| +$");
  std::vector<std::string> texts;
  for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it)
    texts.push_back(std::regex_replace(unescaped(std::regex_replace((*it)[1].str(), tag, "")), ends, ""));
  return texts;
}

std::string trimmed(const std::string& text) {
  return std::regex_replace(text, std::regex("^ +| +$"), "");
}

void expect_markup(const std::string& text) {
  EXPECT_EQ(text, marked_up_text(text));
  EXPECT_THAT(text, Not(HasSubstr("]]>")));
}

/// One study for each kind of figure, its series of these names.
std::vector<StudyResult> studies_of(std::span<const Name> names) {
  StudyResult curves = synthetic::check(), panels = synthetic::check(), limits = synthetic::limits();
  const records::Series curve = curves.series[0], limit = limits.series[0];
  records::Series panel{
      "", {{0, records::Status::ok, "", {{"y", 0}}}, {1, records::Status::ok, "", {{"y", 1}}}}, {}, std::nullopt};
  for (StudyResult* study : {&curves, &panels, &limits}) study->series.clear();
  for (const Name& name : names) {
    for (const auto& [study, series] : {std::pair{&curves, &curve}, {&panels, &panel}, {&limits, &limit}}) {
      study->series.push_back(*series);
      study->series.back().name = name.given;
    }
  }
  panels.name = "panels";
  panels.figures[0].name = "panels";
  panels.figures[0].kind = records::Figure::Kind::particles;
  return {curves, limits, panels};
}

/// A few at a time: what does not fit into a legend is not drawn.
TEST(Names, AreDrawnAsTheyAreWritten) {
  constexpr std::size_t few = 4;
  const std::span<const Name> all = nasty_names();
  for (std::size_t k = 0; k < all.size(); k += few) {
    const TempFolder folder;
    const auto names = all.subspan(k, std::min(few, all.size() - k));
    std::vector<Plot> plots;
    for (const auto& study : studies_of(names))
      for (const auto& chart : charts_of(study)) plots.push_back(plot_of(chart));
    ASSERT_EQ(draw(plots, folder.path()), 3);
    for (const char* figure : {"s-fig4", "bar-cfl-map", "panels"}) {
      const std::string svg = content(folder / (std::string(figure) + ".svg"));
      expect_markup(svg);
      const auto texts = texts_of(svg);
      for (const auto& name : names) EXPECT_THAT(texts, Contains(trimmed(name.shown))) << figure;
    }
  }
}

TEST(Names, AreAxisLabelsAsTheyAreWritten) {
  const TempFolder folder;
  StudyResult study = synthetic::check();
  const records::Figure figure = study.figures[0];
  study.figures.clear();
  for (std::size_t k = 0; k < nasty_names().size(); ++k) {
    study.figures.push_back(figure);
    study.figures.back().name = "f" + std::to_string(k);
    study.figures.back().xlabel = study.figures.back().ylabel = nasty_names()[k].given;
  }
  std::vector<Plot> plots;
  for (const auto& chart : charts_of(study)) plots.push_back(plot_of(chart));
  draw(plots, folder.path());
  for (std::size_t k = 0; k < nasty_names().size(); ++k) {
    const auto texts = texts_of(content(folder / ("f" + std::to_string(k) + ".svg")));
    EXPECT_EQ(std::ranges::count(texts, trimmed(nasty_names()[k].shown)), 2) << nasty_names()[k].shown;
  }
}

TEST(Names, StandOnThePageAndInTables) {
  const TempFolder folder;
  ReportInput in;
  in.studies = studies_of(nasty_names());
  for (const auto& name : nasty_names()) {
    in.studies[0].values.push_back({name.given, 1, name.given});
    in.studies[0].title += name.given;
    in.studies[0].figures[0].caption += name.given;
  }
  in.studies[0].text = in.studies[0].title;
  write_report(in, folder / "out", [](const std::string&) {});
  const std::string page = content(folder / "out/studies/weights.html"), text = unescaped(page);
  expect_markup(page);
  for (const auto& name : nasty_names()) EXPECT_THAT(text, HasSubstr(">" + marked_up_text(name.given) + "<"));
  std::istringstream tex(content(folder / "out/tables/weights.tex"));
  for (std::string line; std::getline(tex, line);) {
    EXPECT_FALSE(line.starts_with('[') || line.starts_with('*')) << "an argument of the line before: " << line;
    EXPECT_EQ(line, marked_up_text(line));
  }
}

StudyResult named(StudyResult study, const std::string& name) {
  study.name = study.figures.empty() ? name : study.figures[0].name = name;
  study.title = "Title of " + name;
  study.series.resize(1);
  return study;
}

TEST(Names, NeverShareAFileOrAnId) {
  const TempFolder folder;
  ReportInput in;
  for (const char* name : {"ok", "ok-fits", "ok-values", "ok.csv", "a.b", "a-b", "a_b", "a+b", "index", "trend",
                           "benchmark", "mutants", "program", "fits", "svg", "study", "figures"}) {
    in.studies.push_back(named(synthetic::convergence(), name));
    in.studies.push_back(named(synthetic::check(), std::string(name) + "-2"));
    in.studies.back().figures[0].name = "overview";
  }
  in.studies.push_back(named(synthetic::limits(), "overview"));
  in.studies.push_back(named(synthetic::limits(), "ok-fits.x"));
  in.studies.push_back(named(synthetic::check(), "overview-map"));
  in.benchmark = Benchmark{"", "", {{"skip/x/paid", "", {}}}};
  in.mutation.emplace();
  write_report(in, folder / "out", [](const std::string&) {});
  std::map<std::string, int> files;
  for (const auto& entry : fs::directory_iterator(folder / "out/studies")) {
    const std::string page = content(entry.path());
    const auto ids = matches(page, " id=[\"']([^\"']*)[\"']");
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size()) << entry.path();
    for (const auto& file : matches(page, "href=\"../((?:figures|tables)/[^\"]*)\"")) ++files[file];
  }
  EXPECT_GT(files.size(), in.studies.size());
  for (const auto& [file, pages] : files) {
    EXPECT_EQ(pages, 1) << file;
    EXPECT_TRUE(fs::is_regular_file(folder / ("out/" + file))) << file;
  }
  for (const auto& study : in.studies)
    EXPECT_THAT(content(folder / ("out/tables/" + study.name + ".tex")),
                HasSubstr("Title of " + latex_text(study.name)));
}

}  // namespace mpmvv::reports::names_test
