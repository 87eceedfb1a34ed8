#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "reports/plot.hpp"
#include "reports/text.hpp"

namespace mpmvv::reports {

namespace {

/// Okabe and Ito's colours, told apart with any colour vision; their yellow is too faint on white.
constexpr std::array<unsigned, 7> palette{0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9, 0x000000};

struct Marker {
  int filled, hollow;
};
constexpr std::array<Marker, 6> markers{{{7, 6}, {5, 4}, {9, 8}, {13, 12}, {11, 10}, {15, 14}}};
constexpr int cross = 2;
constexpr double half_shown = 0.44;  ///< of a box's width, on either side of its centre

std::string colour(int style, double whiteness = 0) {
  const unsigned rgb = style == plain_style ? 0x000000 : palette[static_cast<std::size_t>(style) % palette.size()];
  unsigned mixed = 0;
  for (const int shift : {16, 8, 0}) {
    const double part = (rgb >> shift) & 0xFFu;
    mixed |= static_cast<unsigned>(std::lround(part + (255 - part) * whiteness)) << shift;
  }
  return fmt::format("lc rgb '#{:06X}'", mixed);
}

Marker marker(int style) {
  return markers[static_cast<std::size_t>(style) % markers.size()];
}

int dash(int style) {
  return 1 + static_cast<int>(static_cast<std::size_t>(style) / palette.size()) % 4;
}

/// The text on one line.
std::string one_line(const std::string& text) {
  std::string line = marked_up_text(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return line;
}

/// A text in double quotes, what has a meaning in them or in single ones by its octal code. (In single quotes two of
/// them mean one, but not at the text's beginning nor beside others.)
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : one_line(text))
    result +=
        std::string_view("\"'\\`@").find(c) == std::string_view::npos ? std::string(1, c) : fmt::format("\\{:03o}", c);
  return result + '"';
}

/// A tic's text, which is a format.
std::string quoted_format(const std::string& text) {
  return quoted(replace_all(text, "%", "%%"));
}

std::string number(double v) {
  return std::isnan(v) ? "NaN" : exact(v);
}

/// One block per curve and per rule, and one of the boxes, in the order in which the script counts them. An empty one
/// would not be counted.
std::string data_text(const Chart& chart) {
  std::string text = fmt::format("# {}\n", one_line(chart.name));
  for (const auto& curve : chart.curves) {
    if (curve.dots.empty()) continue;
    text += fmt::format("# {}: x, value, drawn at, mark (1 in a window, 0 outside, -1 unstable, -2 none)\n",
                        one_line(curve.name));
    for (const auto& d : curve.dots) {
      const int mark = d.mark == Mark::inside ? 1 : d.mark == Mark::outside ? 0 : d.mark == Mark::unstable ? -1 : -2;
      text += fmt::format("{} {} {} {}\n", number(d.x), number(d.value), number(d.drawn), mark);
    }
    text += "\n\n";
  }
  for (const auto& rule : chart.rules) {
    text += fmt::format("# {}: x, y\n", one_line(rule.meaning));
    for (const auto& p : rule.path) text += fmt::format("{} {}\n", number(p.x), number(p.y));
    text += "\n\n";
  }
  if (!chart.boxes.empty()) {
    text += "# boxes: x, y, width in x, width in y\n";
    for (const auto& b : chart.boxes)
      text +=
          fmt::format("{} {} {} {}\n", number(b.centre.x), number(b.centre.y), number(b.width_x), number(b.width_y));
    text += "\n\n";
  }
  return text;
}

std::string axis_text(char letter, const Axis& axis) {
  std::string tics;
  for (const auto& tic : axis.tics)
    tics += fmt::format("{}{} {} {}", tics.empty() ? "" : ", ", quoted_format(tic.text), number(tic.at),
                        tic.text.empty() ? 1 : 0);
  return fmt::format("{0}\nset {1}range [{2}:{3}]\nset {1}label {4} noenhanced\nset {1}tics {5} ({6})\n",
                     axis.log ? fmt::format("set logscale {}", letter) : fmt::format("unset logscale {}", letter),
                     letter, number(axis.from), number(axis.to), quoted(axis.label),
                     axis.names ? "nomirror noenhanced" : "mirror enhanced", tics);
}

std::string label_text(const Label& label) {
  static constexpr std::array<std::string_view, 3> sides{"center", "left", "right"};
  return fmt::format("set label {} at {},{} {} front {}\n", quoted(label.text), number(label.at.x), number(label.at.y),
                     sides[static_cast<std::size_t>(label.side)], label.enhanced ? "enhanced" : "noenhanced");
}

std::string rule_style(const Rule& rule) {
  switch (rule.kind) {
    case Rule::Kind::fit:
      return "lines lw 2 " + colour(rule.style);
    case Rule::Kind::reference:
      return "lines lw 1.2 dt 2 lc rgb '#808080'";
    case Rule::Kind::triangle:
      return "lines lw 1 lc rgb '#606060'";
    case Rule::Kind::floor:
      return "lines lw 1.4 dt 3 " + colour(rule.style);
    case Rule::Kind::limit:
      return (rule.style == plain_style ? "lines lw 3 " : "lines lw 1 ") + colour(rule.style);
    case Rule::Kind::front:
      return "points pt 6 ps 1.7 lw 2 lc rgb '#D9B44A'";
    case Rule::Kind::frame:
      return "lines lw 0.8 lc rgb '#909090'";
  }
  return "";
}

std::string joining_line(const Curve& curve) {
  return curve.emphasised ? fmt::format("lw 1.8 dt {} {}", dash(curve.style), colour(curve.style))
                          : fmt::format("lw 1 dt {} {}", dash(curve.style), colour(curve.style, 0.55));
}

/// The elements of the `plot` command: boxes and rings below, lines, marks above, then the key's entries.
class Elements {
 public:
  explicit Elements(const Chart& chart) {
    int index = 0;
    std::vector<std::string> below, lines, fits, marks;
    for (const auto& curve : chart.curves) {
      if (curve.dots.empty()) continue;
      if (curve.joined)
        lines.push_back(fmt::format("data index {} using 1:($4>=0?$2:NaN) with lines {}", index, joining_line(curve)));
      add_marks(marks, curve, index++);
    }
    for (const auto& rule : chart.rules) {
      auto& layer = rule.kind == Rule::Kind::fit ? fits : rule.kind == Rule::Kind::front ? below : lines;
      layer.push_back(fmt::format("data index {} using 1:2 with {}", index++, rule_style(rule)));
    }
    if (!chart.boxes.empty())
      below.push_back(
          fmt::format("data index {0} using 1:2:({1}*$3):({1}*$4) with boxxyerror "
                      "fs solid noborder lc rgb '#A9CCE3'",
                      index, half_shown));
    for (const auto* layer : {&below, &lines, &fits, &marks})
      for (const auto& element : *layer) add(element);
    if (text_.empty()) return;
    for (const auto& curve : chart.curves) add_key(curve);
  }

  const std::string& text() const { return text_; }

 private:
  void add(const std::string& element, const std::string& title = "notitle") {
    text_ += fmt::format("{}  {} {}", text_.empty() ? "" : ", \\\n", element, title);
  }

  static bool has(const Curve& curve, Mark mark) {
    for (const auto& d : curve.dots)
      if (d.mark == mark) return true;
    return false;
  }

  static void add_marks(std::vector<std::string>& marks, const Curve& curve, int index) {
    const auto points = [&](int mark, int type, const std::string& look) {
      marks.push_back(
          fmt::format("data index {} using 1:($4=={}?$3:NaN) with points pt {} {}", index, mark, type, look));
    };
    const auto [filled, hollow] = marker(curve.style);
    if (curve.marked && has(curve, Mark::outside)) {
      points(0, filled, fmt::format("ps {:g} lc rgb '#FFFFFF'", curve.size));
      points(0, hollow, fmt::format("ps {:g} lw 1.3 ", curve.size) + colour(curve.style));
    }
    if (curve.marked && has(curve, Mark::inside))
      points(1, filled, fmt::format("ps {:g} ", curve.size) + colour(curve.style));
    if (has(curve, Mark::unstable)) points(-1, cross, "ps 0.85 lw 1.8 " + colour(curve.style));
  }

  void add_key(const Curve& curve) {
    if (curve.key.empty() || curve.dots.empty()) return;
    const bool only_crosses = has(curve, Mark::unstable) && !has(curve, Mark::inside) && !has(curve, Mark::outside);
    const std::string mark =
        fmt::format("pt {} ps {:g}", only_crosses ? cross : marker(curve.style).filled, curve.size);
    const std::string line = fmt::format("lw {} dt {}", curve.joined ? 1.8 : 1.0, dash(curve.style));
    const std::string with = !curve.joined  ? "points " + mark
                             : curve.marked ? "linespoints " + line + " " + mark
                                            : "lines " + line;
    add(fmt::format("keyentry with {} {}", with, colour(curve.style)), "title " + quoted(curve.key));
  }

  std::string text_;
};

std::size_t characters(const std::string& utf8) {
  return static_cast<std::size_t>(std::ranges::count_if(utf8, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Rows of the key, which stands below the axes in one or two columns.
struct KeyShape {
  int columns = 1, rows = 0;
};

KeyShape key_shape(const Chart& chart) {
  constexpr std::size_t widest_half = 40;
  int entries = 0;
  std::size_t widest = 0;
  for (const auto& curve : chart.curves) {
    entries += curve.key.empty() ? 0 : 1;
    widest = std::max(widest, characters(curve.key));
  }
  const int columns = entries > 1 && widest <= widest_half ? 2 : 1;
  return {columns, (entries + columns - 1) / columns};
}

constexpr std::string_view head = R"(# Draws {0}.svg and {0}.pdf from {0}.dat: run gnuplot on it in its own folder.
reset
set encoding utf8
data = '{0}.dat'
set border 15 lw 0.8 lc rgb '#202020'
set tics in scale 0.8,0.4
set grid xtics ytics back lt 1 lw 0.5 lc rgb '#E4E4E4'
set rmargin {1}
set size {4}
set xlabel offset 0,0.5
set key outside below center vertical maxcols {2} maxrows {3} Left reverse noenhanced samplen 2.5 spacing 1.2
)";

constexpr std::string_view svg_output = R"(set key font ',11.5'
set terminal svg size {1:g},{2:g} dynamic font 'Arial,13' background '#FFFFFF'
set output '{0}.svg'
plot \
{3}
)";

/// The same picture at 96 pixels per inch: a pixel is 3/4 of a point.
constexpr std::string_view pdf = R"(set key font ',8'
set terminal pdfcairo size {1:.3f}in,{2:.3f}in font 'Arial,9' fontscale 1 linewidth 1.5 pointscale 1.1
set output '{0}.pdf'
replot
unset output
)";

std::string script_text(const Chart& chart) {
  const auto key = key_shape(chart);
  const double height = chart.height + 18.0 * key.rows;
  std::string text = fmt::format(head, chart.name, chart.right_margin, key.columns, std::max(1, key.rows),
                                 chart.to_scale ? "ratio -1" : "noratio");
  text += axis_text('x', chart.x) + axis_text('y', chart.y);
  for (const auto& label : chart.labels) text += label_text(label);
  std::string elements = Elements(chart).text();
  if (elements.empty()) {
    text += "set label 'nothing to draw' at graph 0.5,0.5 center\n";
    elements = "  NaN notitle";
  }
  text += fmt::format(svg_output, chart.name, chart.width, height, elements);
  text += fmt::format(pdf, chart.name, chart.width / 96, height / 96);
  return text;
}

}  // namespace

Plot plot_of(const Chart& chart) {
  return {chart.name, script_text(chart), data_text(chart)};
}

}  // namespace mpmvv::reports
