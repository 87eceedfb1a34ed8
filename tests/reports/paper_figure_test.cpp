#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "reports/picture_file.hpp"
#include "reports/plot.hpp"
#include "reports/plot_layout.hpp"
#include "studies/support/process.hpp"
#include "tests/reports/distinct.hpp"
#include "tests/reports/read_back_drawing.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

/// Figures as they are drawn for a paper.
namespace mpmvv::reports::paper_figure_test {

using read_back::Drawing;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Sheet sheet(Format format, double width = 84) {
  Sheet s;
  s.format = format, s.width = width;
  return s;
}

Chart chart_of(const records::StudyResult& study) {
  return charts_of(study, paper_letter).at(0);
}

std::string drawn(const records::StudyResult& study, const Sheet& sheet) {
  const TempFolder folder;
  const auto file = folder / ("picture" + ending_of(sheet.format));
  draw_picture(chart_of(study), sheet, file);
  return content(file);
}

/// The long labels and keys of which the sheet has no room for on one line.
records::StudyResult wordy() {
  auto study = synthetic::convergence();
  study.figures[0].ylabel = "largest displacement error over all steps of a period (m)";
  study.series[1].name = "a series whose name and order are longer than a column of a paper is wide";
  return study;
}

/// However few they are: its height is that of the rows.
TEST(PaperFigure, AMapOfFewLimitsHasRoom) {
  records::StudyResult study = distinct::limits();
  study.series.resize(2);
  EXPECT_TRUE(has_room(chart_of(study), sheet(Format::pdf)));
  EXPECT_FALSE(has_room(chart_of(study), sheet(Format::pdf, 20)));
}

TEST(PaperFigure, ALabelMayEndInASpace) {
  records::StudyResult study = distinct::laws();
  study.figures[0].ylabel = "error ";
  Sheet narrow = sheet(Format::pdf, 40);
  narrow.font_size = 16;
  EXPECT_FALSE(has_room(chart_of(study), narrow));
}

TEST(PaperFigure, PointsStandWhereTheyWereMeasured) {
  const records::StudyResult study = distinct::laws();
  const Drawing drawing = read_back::read_drawing(drawn(study, sheet(Format::svg)));
  ASSERT_EQ(drawing.key.size(), study.series.size());
  for (const records::Series& s : study.series) {
    SCOPED_TRACE(s.name);
    const auto marks = drawing.marks_of(drawing.look_of(s.name));
    ASSERT_EQ(marks.size(), s.points.size());
    for (std::size_t i = 0; i < marks.size(); ++i) {
      EXPECT_NEAR(drawing.x.value(marks[i].at.x), s.points[i].x, 5e-3 * s.points[i].x);
      if (s.points[i].status == records::Status::ok) {
        const double y = s.points[i].y.at("l2");
        EXPECT_NEAR(drawing.y.value(marks[i].at.y), y, 1e-2 * y);
      }
    }
  }
}

TEST(PaperFigure, TheKeyStandsBelowTheAxissLabelAndThatBelowTheTics) {
  for (const double width : {60.0, 84.0, 174.0}) {
    const Drawing drawing = read_back::read_drawing(drawn(distinct::laws(), sheet(Format::svg, width)));
    ASSERT_EQ(drawing.x.label, "abscissa of laws");
    EXPECT_GT(drawing.x.label_at.y - drawing.bottom, 8 / 0.75 * 2) << "a row for the tics";
    for (const auto& entry : drawing.key) EXPECT_GT(entry.at.y - drawing.x.label_at.y, 8 / 0.75) << entry.text;
  }
}

TEST(PaperFigure, ItHasTheSizeAndLettersThatWereAskedFor) {
  Sheet wanted = sheet(Format::svg);
  wanted.font = "Liberation Serif", wanted.font_size = 9;
  const std::string svg = drawn(distinct::laws(), wanted);
  for (const char* part : {"width=\"317\"", "font-family=\"Liberation Serif\"", "font-size=\"12.00\""})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  EXPECT_THAT(plot_of(chart_of(distinct::laws()), sheet(Format::pdf)).script,
              AllOf(HasSubstr("pdfcairo size 3.3071in"), HasSubstr("font 'Sans,6'")))
      << "8 points: that terminal draws a font of 3 points in 4";
}

TEST(PaperFigure, LatexSetsItsTexts) {
  const TempFolder folder;
  const auto files = picture_files(folder / "fig.tex", Format::tex);
  draw_picture(chart_of(distinct::laws()), sheet(Format::tex), files[0]);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[1].filename(), "fig-lines.pdf");
  EXPECT_THAT(content(files[1]), testing::StartsWith("%PDF"));
  EXPECT_THAT(content(files[0]), AllOf(HasSubstr("\\fontsize{8}{9.6}\\selectfont"), HasSubstr("{fig-lines}"),
                                       HasSubstr("law 0\\quad 1.07 $\\pm$ 0.03"), HasSubstr("$h$$^{2}$"),
                                       HasSubstr("abscissa of laws"), Not(HasSubstr("{laws}"))));
}

/// gnuplot takes a bracket or a brace at the beginning for an alignment, and the text would stand outside of its box.
TEST(PaperFigure, LatexSetsALabelThatBeginsWithABracket) {
  records::StudyResult study = distinct::laws();
  study.figures[0].xlabel = "[7] ‖u − u_h‖";
  study.figures[0].ylabel = "⌘ (m)";
  const std::string tex = drawn(study, sheet(Format::tex));
  EXPECT_THAT(tex, AllOf(HasSubstr("\\makebox(0,0){\\strut{}\\relax[7] $\\|$$u$ $-$ $u$$_{h}$$\\|$}"),
                         HasSubstr("\\strut{}\\relax[U+2318] (m)}"), Not(HasSubstr("\\makebox(0,0){}"))));
}

/// The unit of a line's width is half as large in the one terminal as in the other.
TEST(PaperFigure, LinesAreAsWideInLatexAsInPdf) {
  const auto unit = [](Format format) {
    const std::string script = plot_of(chart_of(distinct::laws()), sheet(format)).script;
    std::smatch width;
    return std::regex_search(script, width, std::regex(" linewidth ([0-9.]+)")) ? std::stod(width[1]) : 0;
  };
  EXPECT_GT(unit(Format::pdf), 0);
  EXPECT_DOUBLE_EQ(unit(Format::tex), 2 * unit(Format::pdf));
}

TEST(PaperFigure, ItHasTheHeightThatWasAskedFor) {
  Sheet wanted = sheet(Format::svg, 174);
  wanted.height = 90;
  EXPECT_THAT(drawn(distinct::laws(), wanted), AllOf(HasSubstr("width=\"658\""), HasSubstr("height=\"340\"")));
  EXPECT_TRUE(has_room(chart_of(distinct::laws()), wanted));
  wanted.height = 20;
  EXPECT_FALSE(has_room(chart_of(distinct::laws()), wanted));
  EXPECT_FALSE(has_own_height(chart_of(distinct::laws())));
  EXPECT_TRUE(has_own_height(chart_of(distinct::limits()))) << "rows";
  EXPECT_TRUE(has_own_height(chart_of(distinct::particles()))) << "to scale";
}

TEST(PaperFigure, LongLabelsAndKeysAreBrokenIntoLines) {
  const std::string svg = drawn(wordy(), sheet(Format::svg));
  for (const char* line :
       {">largest displacement error<", ">over all steps of a period (m)<", ">a series whose name and order are<"})
    EXPECT_NE(svg.find(line), std::string::npos) << line;
}

TEST(PaperFigure, TicsWithoutRoomLoseTheirTexts) {
  Axis axis;
  axis.from = 0, axis.to = 10;
  for (int k = 0; k <= 10; ++k) axis.tics.push_back({static_cast<double>(k), std::to_string(1000 + k)});
  const Axis tight = with_room(axis, 100, 8);
  EXPECT_EQ(tight.tics.size(), axis.tics.size());
  EXPECT_EQ(tight.tics[0].text, "1000");
  EXPECT_EQ(tight.tics[1].text, "");
  EXPECT_EQ(with_room(axis, 500, 8).tics[1].text, "1001");
}

TEST(PaperFigure, UprightTheUpperOfTwoTicsKeepsItsText) {
  Axis axis;
  axis.from = 0, axis.to = 10;
  axis.tics = {{0, "a"}, {5, "b"}, {6, ""}, {5.5, "unstable"}};
  const Axis tight = with_room_upright(axis, 100, 8);
  EXPECT_EQ(tight.tics[0].text, "a");
  EXPECT_EQ(tight.tics[1].text, "") << "5 points below the next";
  EXPECT_EQ(tight.tics[3].text, "unstable");
  EXPECT_EQ(with_room_upright(axis, 200, 8).tics[1].text, "b");
}

TEST(PaperFigure, ALabelLongerThanThePageTakesLinesAndRoomBelowTheAxes) {
  records::StudyResult study = distinct::laws();
  study.figures[0].xlabel = "Courant number, wave speed times time step over the width of a cell of the mesh (-)";
  const std::string svg = drawn(study, sheet(Format::svg));
  EXPECT_THAT(svg,
              AllOf(HasSubstr(">over the width of a cell of the mesh (-)<"), Not(HasSubstr(study.figures[0].xlabel))));
  const Layout one = paper_layout(chart_of(distinct::laws()), 238, 8), more = paper_layout(chart_of(study), 238, 8);
  EXPECT_GT(more.x_label.size(), 1U);
  EXPECT_GT(more.axes_bottom(), one.axes_bottom());
  EXPECT_GT(more.x_label_at(0), more.x_label_at(1));
}

TEST(PaperFigure, ABlankThatDoesNotBreakStaysOneInLatex) {
  records::StudyResult study = distinct::laws();
  study.figures[0].ylabel = "error in a cell of 5\u00A0mm";
  EXPECT_THAT(drawn(study, sheet(Format::tex)), HasSubstr("5~mm"));
}

TEST(PaperFigure, TitlesOfPanelsAreBroken) {
  Chart chart = chart_of(distinct::particles());
  ASSERT_GT(chart.labels.size(), 1U);
  const Layout narrow = paper_layout(chart, 300, 8);
  chart.labels[0].text = "a body that is at rest and keeps still";
  const Layout broken = paper_layout(chart, 300, 8);
  EXPECT_GT(broken.titles[0].size(), 1U);
  EXPECT_GT(broken.top, narrow.top);
  EXPECT_TRUE(broken.has_room());
  chart.labels[0].text = std::string(80, 'm');
  EXPECT_FALSE(paper_layout(chart, 300, 8).has_room());
}

TEST(PaperFigure, TitlesOfPanelsAreBrokenInAReportToo) {
  Chart chart = chart_of(distinct::particles());
  const Layout one = report_layout(chart);
  chart.labels[0].text = "a body that is at rest and keeps as still as a body can keep, with " + chart.labels[0].text;
  const Layout more = report_layout(chart);
  ASSERT_GT(more.titles[0].size(), 1U);
  EXPECT_GT(more.title_above_axes(1), more.title_above_axes(0));
  EXPECT_LT(more.axes_top() + more.title_above_axes(more.titles[0].size() - 1), 1);
  EXPECT_NEAR((more.axes_top() - more.axes_bottom()) * more.height(),
              (one.axes_top() - one.axes_bottom()) * one.height(), 1e-9);
}

TEST(PaperFigure, LettersAreMeasuredByTheSheet) {
  EXPECT_DOUBLE_EQ(letter_on(Sheet{}), paper_letter);
  EXPECT_DOUBLE_EQ(letter_on(sheet(Format::pdf, 168)), paper_letter / 2);
  Sheet large;
  large.font_size = 12;
  EXPECT_DOUBLE_EQ(letter_on(large), 1.5 * paper_letter);
}

TEST(PaperFigure, PanelsOfParticlesAreToScale) {
  const Drawing drawing = read_back::read_drawing(drawn(distinct::particles(), sheet(Format::svg, 174)));
  ASSERT_EQ(drawing.boxes.size(), 4u);
  for (const auto& box : drawing.boxes) EXPECT_EQ(box.path.size(), drawing.boxes[0].path.size());
  const auto& tics = drawing.x.tics;
  const double per_unit_x = (tics[1].pixel - tics[0].pixel) / (std::stod(tics[1].text) - std::stod(tics[0].text));
  const auto& up = drawing.y.tics;
  const double per_unit_y = (up[0].pixel - up[1].pixel) / (std::stod(up[1].text) - std::stod(up[0].text));
  EXPECT_NEAR(per_unit_x, per_unit_y, 0.02 * per_unit_x);
}

/// A word of a PDF with the box around it.
struct Word {
  double left = 0, top = 0, right = 0, bottom = 0;
  std::string text;

  /// Of the same size: a raised number may stand close to what it belongs to.
  bool touches(const Word& other) const {
    if (std::abs((bottom - top) - (other.bottom - other.top)) > 0.5 && !is_upright_beside(other)) return false;
    const double room = 0.25 * std::min(bottom - top, other.bottom - other.top);  ///< above and below most letters
    return left < other.right && other.left < right && top + room < other.bottom && other.top + room < bottom;
  }

  /// One of them is turned, and so its height a length.
  bool is_upright_beside(const Word& other) const {
    return (bottom - top > 2 * (right - left)) != (other.bottom - other.top > 2 * (other.right - other.left));
  }
};

std::vector<Word> words_of(const std::string& boxes) {
  static const std::regex pattern(
      R"|(<word xMin="([-\d.]+)" yMin="([-\d.]+)" xMax="([-\d.]+)" yMax="([-\d.]+)">([^<]*)<)|");
  std::vector<Word> words;
  for (auto it = std::sregex_iterator(boxes.begin(), boxes.end(), pattern); it != std::sregex_iterator(); ++it)
    words.push_back({std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), std::stod((*it)[4]), (*it)[5]});
  return words;
}

TEST(PaperFigureNightly, NoTextTouchesAnotherOrTheEdge) {
  const TempFolder folder;
  for (const auto& study : {distinct::laws(), distinct::brackets(), distinct::curves(), distinct::limits(),
                            distinct::costs(), distinct::particles(), synthetic::convergence(), wordy()})
    for (const double width : {84.0, 174.0}) {
      SCOPED_TRACE(study.figures.at(0).name + " at " + std::to_string(width));
      draw_picture(chart_of(study), sheet(Format::pdf, width), folder / "picture.pdf");
      const auto end =
          support::run_process({"pdftotext", "-bbox", "picture.pdf", "-"}, folder.path(), {}, std::chrono::seconds(60));
      if (end.start_error != 0) GTEST_SKIP() << "no pdftotext";
      const auto words = words_of(end.output);
      ASSERT_GT(words.size(), 5u);
      for (std::size_t i = 0; i < words.size(); ++i) {
        EXPECT_TRUE(words[i].left > 0 && words[i].right < width / 25.4 * 72) << words[i].text;
        EXPECT_GT(words[i].top, -1) << words[i].text;
        for (std::size_t k = 0; k < i; ++k)
          EXPECT_FALSE(words[i].touches(words[k])) << words[i].text << " and " << words[k].text;
      }
    }
}

}  // namespace mpmvv::reports::paper_figure_test
