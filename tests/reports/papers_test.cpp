#include "reports/papers.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::reports::papers_test {

std::string message(const std::string& text) {
  try {
    read_papers(text, "p.toml");
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "no error";
}

/// Figures that the studies of the tree declare, under the study's own name where they have none.
std::set<std::string> declared_figures() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(MPMVV_SOURCE_DIR "/studies"))
    if (entry.path().extension() == ".toml")
      for (const auto& figure : support::TomlTable::read(entry.path()).tables("figure"))
        names.insert(figure.text("name", entry.path().stem()));
  return names;
}

TEST(Papers, EveryPanelIsAFigureOfAStudy) {
  const auto declared = declared_figures();
  for (const Paper& paper : papers())
    for (const PaperFigure& figure : paper.figures)
      for (const auto& panel : figure.panels)
        EXPECT_TRUE(declared.contains(panel)) << paper.key << " Fig. " << figure.number << ": " << panel;
}

TEST(Papers, EverySeriesOfAGroupIsOneOfTheStudy) {
  int groups = 0;
  for (const Paper& paper : papers())
    for (const PaperFigure& figure : paper.figures)
      for (const auto& group : figure.groups) {
        ++groups;
        std::set<std::string> known;
        const auto study = support::TomlTable::read(MPMVV_SOURCE_DIR "/studies/" + figure.panels.front() + ".toml");
        for (const auto& series : study.tables("series")) known.insert(series.text("name"));
        for (const auto& name : group) EXPECT_TRUE(known.contains(name)) << figure.number << ": " << name;
      }
  EXPECT_GT(groups, 0);
}

TEST(Papers, EveryFigureOfThePapersIsNamed) {
  std::vector<std::string> expected, named;
  for (const auto& [key, last] : {std::pair{"S", 13}, std::pair{"W", 7}, std::pair{"N", 8}})
    for (int number = 1; number <= last; ++number) expected.push_back(fmt::format("{} {}", key, number));
  for (const char* number : {"16.2", "16.3", "16.4", "16.5"}) expected.push_back(fmt::format("B {}", number));
  for (const Paper& paper : papers())
    for (const PaperFigure& figure : paper.figures) named.push_back(paper.key + " " + figure.number);
  EXPECT_EQ(named, expected);
}

TEST(Papers, AFigureHasPanelsOrAReason) {
  const std::string paper = "[[paper]]\nkey = \"S\"\nsource = \"s\"\n[[paper.figure]]\nnumber = \"1\"\n";
  EXPECT_EQ(message(paper), "figure 1 in p.toml:4 (either panels, or why it is without)");
  EXPECT_EQ(message(paper + "panels = [\"a\"]\nwithout = \"b\"\n"),
            "figure 1 in p.toml:4 (either panels, or why it is without)");
  EXPECT_EQ(message(paper + "without = \"a sketch\"\n"), "no error");
  EXPECT_EQ(read_papers(paper + "panels = [\"a\", \"b\"]\nwide = true\n", "p.toml")[0].figures[0].wide, true);
}

}  // namespace mpmvv::reports::papers_test
