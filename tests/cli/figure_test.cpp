#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_store.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::figure_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A folder with a store of one study that has one figure, `small`.
class Figure : public testing::Test {
 protected:
  Figure() { store_of(folder_); }

  Answer draw(const std::string& arguments) const {
    return call(folder_, "figure " + arguments + " --db r.db", there_);
  }

  Folder folder_;
  std::string there_ = "cd '" + (folder_ / "") + "' && ";
};

TEST_F(Figure, IsDrawnUnderItsNameOrItsClaims) {
  for (const char* name : {"small", "S-fig10"}) {
    const Answer answer = draw(name);
    EXPECT_EQ(answer.code, 0) << answer.err;
    EXPECT_EQ(answer.out, "small.pdf\n");
    EXPECT_THAT(read_text(folder_ / "small.pdf"), StartsWith("%PDF"));
    fs::remove(folder_ / "small.pdf");
  }
}

TEST_F(Figure, AnotherVersionsResultsAreDrawnWhereItIsNamed) {
  const store::Store here(folder_ / "r.db", store::Store::Mode::read);
  const auto studies = here.studies(here.versions().at(0).digest);
  store::Store(folder_ / "old.db", store::Store::Mode::create_or_write)
      .keep_study(studies.at(0), {},
                  {"00ff11", "c0ffee", false, "GNU 12.2.0", "-O3", "Release", "CPU", "2026-01-01T00:00:00Z"});
  const auto ask = [&](const std::string& arguments) {
    return call(folder_, "figure small --db old.db" + arguments, there_);
  };
  const Answer unnamed = ask("");
  EXPECT_EQ(unnamed.code, 2);
  EXPECT_THAT(unnamed.err, AllOf(HasSubstr("but of c0ffee (digest 00ff11)"), HasSubstr("--of")));
  EXPECT_THAT(ask(" --of dead").err,
              HasSubstr("no results of a version 'dead' of mpmvv (there are: c0ffee (digest 00ff11))"));
  ASSERT_EQ(ask(" --of c0f --out old.svg").code, 0);
  ASSERT_EQ(draw("small --out own.svg").code, 0);
  EXPECT_EQ(read_text(folder_ / "old.svg"), read_text(folder_ / "own.svg"));
}

TEST_F(Figure, AFolderForDrawingThatIsNoneIsNamedWithItsVariable) {
  folder_.write("file", "");
  for (const std::string place : {"", "/nonexist", "file"}) {
    const Answer answer = call(folder_, "figure small --db r.db", there_ + "TMPDIR=" + place + " ");
    EXPECT_EQ(answer.code, 2) << place;
    EXPECT_EQ(answer.err,
              "mpmvv: TMPDIR is '" + place + "', which is no folder (one that is there and can be written)\n");
  }
  EXPECT_THAT(call(folder_, "figure small --db r.db", there_ + "unset TMPDIR; TMP=/nonexist ").err,
              StartsWith("mpmvv: TMP is '/nonexist'"));
}

TEST_F(Figure, IsDrawnIntoNoPipeThatNobodyMayRead) {
  ASSERT_EQ(shell("mkfifo '" + (folder_ / "small.svg") + "'").code, 0);
  const Answer answer = call(folder_, "figure small --db r.db --format svg", there_ + "timeout 20 ");
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(answer.err, "mpmvv: --out small.svg is a pipe, a socket or a disk (a file, or /dev/stdout)\n");
}

TEST_F(Figure, TheFilesEndingSaysItsFormat) {
  EXPECT_EQ(draw("small --out made/by-hand.svg --width 8.4cm").out, "made/by-hand.svg\n");
  EXPECT_THAT(read_text(folder_ / "made/by-hand.svg"), HasSubstr("</svg>"));
  EXPECT_EQ(draw("small --out made --format svg").out, "made/small.svg\n");
}

TEST_F(Figure, AFigureOfTwoStudiesIsNamedAfterBoth) {
  std::string study = small_study;
  study.replace(study.find("[[figure]]"), 10, "[[figure]]\nname = \"errors\"");
  for (const std::string name : {"a", "b"}) {
    folder_.write(name + ".toml", study);
    ASSERT_EQ(call(folder_, "study " + name + ".toml --db r.db", there_).code, 0);
  }
  EXPECT_EQ(draw("errors --format svg --out figs").out, "figs/a~errors.svg\nfigs/b~errors.svg\n");
  EXPECT_EQ(draw("errors --out one.svg").err,
            "mpmvv: --out one.svg for 2 figures, a~errors, b~errors (a folder, or the name of one of them)\n");
  EXPECT_EQ(draw("a~errors --out one.svg").out, "one.svg\n");
  EXPECT_EQ(draw("b~errors --format tex").out,
            "b~errors.tex\nb~errors-lines.pdf\n  \\input{b\\string~errors} with \\usepackage{graphicx,xcolor}\n");
  EXPECT_THAT(read_text(folder_ / "b~errors.tex"), HasSubstr("{b\\string~errors-lines}"));
  EXPECT_EQ(draw("b~errors --out 'a%b.tex'").err, "mpmvv: --out a%b.tex (LaTeX reads no file with % in its name)\n");
  EXPECT_EQ(draw("b~errors --out 'a%b.svg'").code, 0);
}

TEST_F(Figure, AFontThatTheMachineLacksIsNamed) {
  const Answer answer = draw("small --font 'No Such Family'");
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.err, StartsWith("this machine has no font 'No Such Family' and draws in "));
  for (const char* known : {"Serif", "serif", "SANS"})
    EXPECT_THAT(draw("small --font " + std::string(known)).err, Not(HasSubstr("font"))) << known;
}

TEST_F(Figure, ForLatexItSaysHowItIsTakenIn) {
  EXPECT_EQ(
      draw("small --out made/f.tex --font-size 7pt").out,
      "made/f.tex\nmade/f-lines.pdf\n  \\graphicspath{{made/}}\\input{made/f} with \\usepackage{graphicx,xcolor}\n");
  EXPECT_THAT(read_text(folder_ / "made/f.tex"), HasSubstr("\\fontsize{7}{8.4}"));
}

TEST_F(Figure, BadOptionsGetOneLineAndWriteNothing) {
  const std::vector<std::pair<std::string, std::string>> calls{
      {"small --format png", "unknown --format 'png' (known: pdf, svg, tex)"},
      {"small --width 84", "--width '84' is no length (a number and its unit: 84mm, 8.4cm, 3.3in, 8pt)"},
      {"small --width 8mm", "--width 8mm (40mm to 400mm)"},
      {"small --width 1.57in", "--width 1.57in (1.58in to 15.74in)"},
      {"small --width 40mm --font-size 16pt",
       "--width 40mm leaves too little for the axes of 'small' (105mm would do, or a smaller --font-size than 16pt)"},
      {"small --height 60", "--height '60' is no length (a number and its unit: 84mm, 8.4cm, 3.3in, 8pt)"},
      {"small --height 40mm --font-size 16pt --width 300mm",
       "--height 40mm leaves too little for the axes of 'small' (a larger one, or a smaller --font-size than 16pt)"},
      {"small --font-size 80pt", "--font-size 80pt (4.26pt to 28.34pt)"},
      {"small --font 'a\"b'", "--font 'a\"b' (a family's name, such as 'Liberation Serif')"},
      {"small --format tex --font Times",
       "--font with --format tex (LaTeX sets the document's own font; leave it out)"},
      {"small --format pdf --out a.svg", "--format pdf with --out a.svg (a file that ends with .pdf)"},
      {"small --out a.png", "--out a.png (a file that ends with .pdf, .svg or .tex, or a folder: a.png/)"},
      {"smal", "unknown figure 'smal'; did you mean 'small'? (known: small, S-fig10)"}};
  for (const auto& [arguments, message] : calls) {
    const Answer answer = draw(arguments);
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_EQ(answer.err, "mpmvv: " + message + "\n");
    EXPECT_EQ(answer.out, "");
  }
  for (const char* file : {"small.pdf", "small.tex", "a.svg"}) EXPECT_FALSE(fs::exists(folder_ / file)) << file;
}

/// Two figures, of which the second has a label of many lines.
std::string two_figures() {
  std::string study = small_study, label;
  for (int i = 0; i < 120; ++i) label += "long ";
  study.insert(study.find("[[criterion]]"),
               "[[figure]]\nname = \"second\"\ncaption = \"C\"\nxlabel = \"x\"\nylabel = \"" + label + "\"\n");
  return study.replace(study.find("[[figure]]"), 10, "[[figure]]\nname = \"first\"");
}

TEST_F(Figure, AFigureWithoutRoomIsNamedWithTheWidthThatWouldDo) {
  folder_.write("two.toml", two_figures());
  ASSERT_EQ(call(folder_, "study two.toml --db r.db", there_).code, 0);
  const Answer both = draw("two");
  EXPECT_EQ(both.code, 0) << both.err;
  EXPECT_EQ(both.out, "first.pdf\n");
  const std::regex complaint(
      "not drawn: --width 84mm leaves too little for the axes of 'second' \\((\\d+)mm would do, or a smaller "
      "--font-size than 8pt\\)\n");
  std::smatch parts;
  ASSERT_TRUE(std::regex_search(both.err, parts, complaint)) << both.err;
  const int width = std::stoi(parts[1]);
  EXPECT_EQ(draw("second --width " + std::to_string(width) + "mm").code, 0);
  const Answer narrower = draw("second --width " + std::to_string(width - 1) + "mm");
  EXPECT_EQ(narrower.code, 2);
  EXPECT_THAT(narrower.err, HasSubstr(" (" + std::to_string(width) + "mm would do"));
  const Answer none = draw("two --width 40mm --font-size 16pt --out none");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, AllOf(HasSubstr("axes of 'first' ("), HasSubstr("; --width 40mm"), HasSubstr("'second' (")));
  EXPECT_FALSE(fs::exists(folder_ / "none"));
}

TEST_F(Figure, WhatItDoesNotShowIsSaid) {
  std::string study = small_study;
  study.replace(study.find("[[figure]]"), 10, "[[figure]]\ny_range = [1e-9, 1e-8]");
  folder_.write("cut.toml", study);
  ASSERT_EQ(call(folder_, "study cut.toml --set ppc=2 --db t.db", there_).code, 0);
  const Answer figure = call(folder_, "figure cut --db t.db", there_);
  EXPECT_EQ(figure.out, "cut.pdf\n");
  EXPECT_THAT(figure.err,
              HasSubstr("\ncut: Made with --set: ppc = 2 in 2 of 2 series.\ncut: Without a point: linear at "));
  const Answer paper = call(folder_, "paper --db t.db --out paper", there_);
  EXPECT_EQ(paper.err, "cut: Made with --set: ppc = 2 in 2 of 2 series.\n");
  EXPECT_THAT(read_text(folder_ / "paper/main.tex"),
              HasSubstr("A small figure. Made with -{}-set: ppc = 2 in 2 of 2 series. Without a point: linear at "));
  folder_.write("whole.toml", small_study);
  ASSERT_EQ(call(folder_, "study whole.toml --db t.db", there_).code, 0);
  EXPECT_EQ(call(folder_, "paper whole --db t.db --out whole", there_).err, "") << "it shows no trial";
}

TEST_F(Figure, ItsMarksAreExplainedAndTextsThatCannotBeSetNamed) {
  std::string study = small_study;
  study.replace(study.find("ylabel = \"error\""), 16, "ylabel = \"$e$ ⌘\"");
  folder_.write("signs.toml", study);
  ASSERT_EQ(call(folder_, "study signs.toml --db r.db", there_).code, 0);
  const std::string marks = "signs: Thick lines: fitted power laws over their windows",
                    dollar = "signs: '$e$ ⌘' is set with its $ signs (h^2, u_h and σ are set as mathematics without",
                    unknown = "signs: LaTeX cannot set '⌘' in '$e$ ⌘' and gets [U+2318]";
  EXPECT_THAT(draw("signs --format pdf").err, AllOf(HasSubstr(marks), HasSubstr(dollar), Not(HasSubstr(unknown))));
  EXPECT_THAT(draw("signs --format tex").err, AllOf(HasSubstr(marks), HasSubstr(dollar), HasSubstr(unknown)));
  EXPECT_THAT(call(folder_, "paper --db r.db --out paper", there_).err, AllOf(HasSubstr(dollar), HasSubstr(unknown)));
}

TEST_F(Figure, AllOfThemMakeADocument) {
  const Answer answer = call(folder_, "paper --db r.db --out paper", there_);
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_EQ(answer.out, "paper/main.tex: 1 figure (1 drawn), 2 tables\n");
  EXPECT_THAT(read_text(folder_ / "paper/main.tex"), AllOf(HasSubstr("{small}"), HasSubstr("A small figure")));
  EXPECT_THAT(read_text(folder_ / "paper/tables/orders-further.tex"), HasSubstr("bspline2"));
  EXPECT_THAT(read_text(folder_ / "paper/tables/errors-small.tex"), HasSubstr("(problem bar)"));
  EXPECT_EQ(call(folder_, "paper small --db r.db --out named", there_).code, 0);
  const Answer unknown = call(folder_, "paper smal --db r.db --out other", there_);
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("unknown figure 'smal'"));
}

TEST_F(Figure, ADocumentOfAnotherHandIsNotOverwritten) {
  fs::create_directories(folder_ / "paper");
  folder_.write("paper/main.tex", "mine");
  const Answer answer = call(folder_, "paper --db r.db --out paper", there_);
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("paper/main.tex is none of ours and would be overwritten"));
  EXPECT_EQ(read_text(folder_ / "paper/main.tex"), "mine");
  EXPECT_FALSE(fs::exists(folder_ / "paper/figures"));
}

TEST_F(Figure, ADocumentNeedsAResult) {
  call(folder_, "db forget small --db r.db", there_);
  const Answer answer = call(folder_, "paper --db r.db --out paper", there_);
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(answer.err, "mpmvv: r.db holds no study of this program (run `mpmvv study` first)\n");
  EXPECT_FALSE(fs::exists(folder_ / "paper"));
}

TEST_F(Figure, TheStoreIsNoPlaceForIt) {
  fs::copy(folder_ / "r.db", folder_ / "r.pdf");
  const Answer answer = call(folder_, "figure small --db r.pdf --out r.pdf", there_);
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("would overwrite 'r.pdf'"));
}

}  // namespace mpmvv::cli::figure_test
