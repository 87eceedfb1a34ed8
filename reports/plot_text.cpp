#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "reports/plot.hpp"
#include "reports/plot_elements.hpp"
#include "reports/plot_layout.hpp"
#include "reports/plot_style.hpp"
#include "reports/text.hpp"

namespace mpmvv::reports {

namespace {

constexpr double mm_per_inch = 25.4;

/// A tic's text in quotes. gnuplot takes it for a format, in which a per cent sign is doubled.
std::string quoted_format(const std::string& text, Notation notation) {
  return replace_all(quoted(text, notation), "%", "%%");
}

/// Whether the plotting program reads its own notation in a text.
const char* reading(Notation notation) {
  return notation == Notation::enhanced ? "enhanced" : "noenhanced";
}

/// The notation of formulas, that is tics and slopes, beside texts in this notation.
Notation of_formulas(Notation texts) {
  return texts == Notation::plain ? Notation::enhanced : texts;
}

std::string axis_text(std::string_view letter, const Axis& axis, Notation texts) {
  const Notation tic_notation = axis.names ? texts : of_formulas(texts);
  std::string tics;
  for (const auto& tic : axis.tics)
    tics += fmt::format("{}{} {} {}", tics.empty() ? "" : ", ", quoted_format(tic.text, tic_notation),
                        plot_number(tic.at), tic.text.empty() ? 1 : 0);
  return fmt::format("{0}\nset {1}range [{2}:{3}]\nset {1}tics {4} {6} ({5})\n",
                     axis.log ? fmt::format("set logscale {}", letter) : fmt::format("unset logscale {}", letter),
                     letter, plot_number(axis.from), plot_number(axis.to), axis.names ? "nomirror" : "mirror", tics,
                     reading(tic_notation));
}

std::string label_text(const Label& label, Notation texts) {
  static constexpr std::array<std::string_view, 3> sides{"center", "left", "right"};
  const Notation notation = label.formula ? of_formulas(texts) : texts;
  return fmt::format("set label {} at {},{} {} front {}\n", quoted(label.text, notation), plot_number(label.at.x),
                     plot_number(label.at.y), sides[static_cast<std::size_t>(label.side)], reading(notation));
}

std::string head_text(const Chart& chart, const std::string& pictures) {
  return fmt::format(R"(# Draws {0} from {1}.dat: run gnuplot on it in its own folder.
reset
set encoding utf8
data = '{1}.dat'
set border 15 lw 0.8 lc rgb '#202020'
set tics in scale 0.8,0.4
set grid xtics ytics back lt 1 lw 0.5 lc rgb '#E4E4E4'
set size {2}
unset key
)",
                     pictures, chart.name, chart.to_scale ? "ratio -1" : "noratio");
}

/// The scale of colours, right of the axes; its label is put there like that of an axis.
std::string shades_text(const Chart& chart, Notation texts, const std::string& placed_label) {
  if (!chart.shades) return "";
  return fmt::format(
      "set palette defined ({})\nset colorbox user origin graph 1.03, graph 0 size graph 0.025, graph 1 noborder\n{}{}",
      shade_stops(), placed_label, axis_text("cb", *chart.shades, texts));
}

std::string report_shades(const Chart& chart) {
  const Notation plain = Notation::plain;
  return shades_text(
      chart, plain,
      fmt::format("set cblabel {} {}\n", quoted(chart.shades.value_or(Axis{}).label, plain), reading(plain)));
}

std::string paper_shades(const Chart& chart, const Layout& layout, Notation texts) {
  return shades_text(
      chart, texts,
      fmt::format("set label {} at screen {:.5f}, graph 0.5 center rotate by 90 {}\n",
                  quoted(chart.shades.value_or(Axis{}).label, texts), layout.shades_label_at(), reading(texts)));
}

/// Titles of panels, whose last lines stand on one line.
std::string titles_text(const Chart& chart, const Layout& layout, Notation texts) {
  std::string text;
  for (std::size_t k = 0; k < layout.titles.size(); ++k)
    for (std::size_t line = 0; line < layout.titles[k].size(); ++line)
      text += fmt::format("set label {} at {},graph 1 center offset 0,screen {:.5f} front {}\n",
                          quoted(layout.titles[k][line], texts), plot_number(chart.labels[k].at.x),
                          layout.title_above_axes(layout.titles[k].size() - 1 - line), reading(texts));
  return text;
}

/// The texts within the axes, and the line below the band of the unstable.
std::string labels_text(const Chart& chart, const Layout& layout, Notation texts) {
  std::string text;
  if (chart.band > 0)
    text += fmt::format("set arrow from graph 0,{0:.5f} to graph 1,{0:.5f} nohead front lw 0.8 lc rgb '#909090'\n",
                        1 - chart.band);
  if (!layout.titles.empty()) return text + titles_text(chart, layout, texts);
  for (const auto& label : chart.labels) text += label_text(label, texts);
  return text;
}

/// A text of several lines, as the plotting program has it.
std::string in_lines(const std::vector<std::string>& lines) {
  std::vector<std::string> texts;
  for (const std::string& line : lines) texts.push_back(quoted(line, Notation::plain));
  return fmt::format("{}", fmt::join(texts, R"(."\n".)"));
}

/// The axes, each with its label where the plotting program puts it.
std::string report_axes(const Chart& chart, const Layout& layout) {
  std::string text = "set xlabel offset 0,0.5\n";
  if (layout.key_rows > 0)
    text += fmt::format("set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n", layout.axes_bottom(),
                        layout.axes_top());
  else if (!layout.titles.empty())
    text += fmt::format("set tmargin at screen {:.5f}\n", layout.axes_top());
  text += fmt::format("set rmargin {}\n", chart.right_margin);
  text += fmt::format("set xlabel {} noenhanced\n", in_lines(layout.x_label));
  // gnuplot sets the lines beyond the second on the tics' texts.
  const double beyond_two = std::max(0.0, static_cast<double>(layout.y_label.size()) - 2);
  text += fmt::format("set ylabel {} noenhanced offset {:g},0\n", in_lines(layout.y_label), 0 - 0.75 * beyond_two);
  return text + axis_text("x", chart.x, Notation::plain) + axis_text("y", chart.y, Notation::plain);
}

/// The axes and their labels where the layout has them, as LaTeX's letters are not the plotting program's.
std::string paper_axes(const Chart& chart, const Layout& layout, Notation texts) {
  const double across = (layout.axes_right() - layout.axes_left()) * layout.page.width;
  const double up = (layout.axes_top() - layout.axes_bottom()) * layout.height(), font = layout.page.font;
  std::string text = fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}\n",
      layout.axes_left(), layout.axes_right(), layout.axes_bottom(), layout.axes_top());
  text += axis_text("x", with_room(chart.x, across, font), texts);
  text += axis_text("y", with_room_upright(chart.y, up, font), texts);
  text += "set xtics offset 0,-0.25\n";  // clear of the lowest text of the other axis
  for (std::size_t line = 0; line < layout.x_label.size(); ++line)
    text += fmt::format("set label {} at graph 0.5, screen {:.5f} center front {}\n",
                        quoted(layout.x_label[line], texts), layout.x_label_at(line), reading(texts));
  for (std::size_t line = 0; line < layout.y_label.size(); ++line)
    text += fmt::format("set label {} at screen {:.5f}, graph 0.5 center rotate by 90 {}\n",
                        quoted(layout.y_label[line], texts), layout.y_label_at(line), reading(texts));
  return text;
}

std::string plot_command(const Chart& chart, double mark_scale) {
  const std::string elements = plot_elements(chart, mark_scale);
  if (!elements.empty()) return "plot \\\n" + elements + "\n";
  return "set label 'nothing to draw' at graph 0.5,0.5 center\nplot \\\n  NaN notitle\n";
}

constexpr std::string_view svg_output =
    R"(set terminal svg size {1:g},{2:g} dynamic font 'Arial,13' background '#FFFFFF'
set output '{0}.svg'
{3})";

/// The same picture as a PDF, at 96 pixels per inch. The font size is 3/4 of the SVG's, because this terminal draws a
/// font of 3 points 4 points high.
constexpr std::string_view pdf_output =
    R"(set terminal pdfcairo size {1:.3f}in,{2:.3f}in font 'Arial,7.31' fontscale 1 linewidth 1.5 pointscale 1.1
set output '{0}.pdf'
replot
unset output
)";

/// A terminal for a sheet whose size is in inches; a pixel of an SVG is 1/96 of one.
std::string terminal_text(const Sheet& sheet, double width, double height) {
  switch (sheet.format) {
    case Format::pdf:
      return fmt::format("pdfcairo size {:.4f}in,{:.4f}in font '{},{:g}' fontscale 1 linewidth 1.1", width, height,
                         sheet.font, 0.75 * sheet.font_size);
    case Format::svg:
      return fmt::format("svg size {:.0f},{:.0f} font '{},{:g}' linewidth 0.75 background '#FFFFFF'", 96 * width,
                         96 * height, sheet.font, sheet.font_size / 0.75);
    case Format::tex:
      return fmt::format(
          "cairolatex pdf input size {:.4f}in,{:.4f}in font ',{:g}' linewidth 2.2 "
          "header '\\fontsize{{{:g}}}{{{:g}}}\\selectfont'",
          width, height, 0.75 * sheet.font_size, sheet.font_size, 1.2 * sheet.font_size);
  }
  return "";
}

Layout layout_on(const Chart& chart, const Sheet& sheet) {
  constexpr double points_per_mm = 72 / mm_per_inch;
  return paper_layout(chart, sheet.width * points_per_mm, sheet.font_size, sheet.height * points_per_mm);
}

}  // namespace

bool has_own_height(const Chart& chart) {
  return chart.to_scale || chart.y.names;
}

bool has_room(const Chart& chart, const Sheet& sheet) {
  return layout_on(chart, sheet).has_room();
}

double height_of(const Chart& chart, const Sheet& sheet) {
  return layout_on(chart, sheet).height() / 72 * mm_per_inch;
}

double letter_on(const Sheet& sheet) {
  const Sheet usual;
  const double height = sheet.height > 0 ? sheet.height : usual_ratio * sheet.width;
  return paper_letter * sheet.font_size / usual.font_size * usual_ratio * usual.width / height;
}

Plot plot_of(const Chart& chart) {
  const Layout layout = report_layout(chart);
  const double width = layout.page.width, height = layout.height();
  const Notation plain = Notation::plain;
  std::string script = head_text(chart, fmt::format("{0}.svg and {0}.pdf", chart.name)) + placed_key(layout, plain, 1) +
                       report_axes(chart, layout) + report_shades(chart) + labels_text(chart, layout, plain);
  script += fmt::format(svg_output, chart.name, width / 0.75, height / 0.75, plot_command(chart, 1));
  script += fmt::format(pdf_output, chart.name, width / 72, height / 72);
  return {chart.name, script, plot_data(chart), {".svg", ".pdf"}};
}

Plot plot_of(const Chart& chart, const Sheet& sheet) {
  constexpr double mark_scale = 0.62;
  const Notation texts = sheet.format == Format::tex ? Notation::latex : Notation::enhanced;
  const Layout layout = layout_on(chart, sheet);
  const std::string picture = chart.name + ending_of(sheet.format);
  std::string script = head_text(chart, picture) + placed_key(layout, texts, mark_scale) +
                       paper_axes(chart, layout, texts) + paper_shades(chart, layout, texts) +
                       labels_text(chart, layout, texts);
  script += fmt::format("set terminal {}\nset output '{}'\n",
                        terminal_text(sheet, sheet.width / mm_per_inch, layout.height() / 72), picture);
  script += plot_command(chart, mark_scale) + "unset output\n";
  Plot plot{chart.name, script, plot_data(chart), {ending_of(sheet.format)}};
  if (sheet.format == Format::tex) plot.endings.push_back(ending_of(Format::pdf));
  return plot;
}

}  // namespace mpmvv::reports
