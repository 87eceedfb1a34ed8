#include "reports/plot_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "reports/plot_style.hpp"

namespace mpmvv::reports {

namespace {

constexpr int cross = 2;
constexpr double half_shown = 0.44;  ///< of a box's width, on either side of its centre
constexpr double behind = 1.3;       ///< of a square's width: of one behind it that closes gaps to its neighbours

std::string rule_style(const Rule& rule) {
  switch (rule.kind) {
    case Rule::Kind::fit:
      return fmt::format("lines lw 2 {} {}", dash_of(rule.style), colour_of(rule.style));
    case Rule::Kind::reference:
      return "lines lw 1.2 dt 2 lc rgb '#808080'";
    case Rule::Kind::triangle:
      return "lines lw 1 lc rgb '#606060'";
    case Rule::Kind::floor:
      return "lines lw 1.4 dt (1,2) " + colour_of(rule.style);
    case Rule::Kind::limit:
      return (rule.style == plain_style ? "lines lw 3 " : "lines lw 1 ") + colour_of(rule.style);
    case Rule::Kind::front:
      return "points pt 6 lw 2 lc rgb '#B08A2E' ";
    case Rule::Kind::frame:
      return "lines lw 0.8 lc rgb '#909090'";
  }
  return "";
}

std::string joining_line(const Curve& curve) {
  return curve.emphasised ? fmt::format("lw 1.8 {} {}", dash_of(curve.style), colour_of(curve.style))
                          : fmt::format("lw 1 {} {}", dash_of(curve.style), colour_of(curve.style, 0.55));
}

bool has(const Curve& curve, Mark mark) {
  return std::ranges::find(curve.dots, mark, &Dot::mark) != curve.dots.end();
}

class Elements {
 public:
  Elements(const Chart& chart, double mark_scale) : mark_scale_(mark_scale) {
    int index = 0;
    std::vector<std::string> below, lines, fits, marks, top;
    for (const auto& curve : chart.curves) {
      if (curve.dots.empty()) continue;
      if (curve.joined)
        lines.push_back(fmt::format("data index {} using 1:($4>=0?$2:NaN) with lines {}", index, joining_line(curve)));
      if (has(curve, Mark::unstable)) top.push_back(crosses(curve, index));
      add_marks(marks, curve, index++);
    }
    for (const auto& rule : chart.rules) {
      auto& layer = rule.kind == Rule::Kind::fit ? fits : rule.kind == Rule::Kind::front ? below : lines;
      layer.push_back(fmt::format("data index {} using 1:2 with {}", index++, look_of(rule)));
    }
    if (!chart.boxes.empty())
      below.push_back(
          fmt::format("data index {0} using 1:2:({1}*$3):({1}*$4) with boxxyerror "
                      "fs solid noborder lc rgb '#A9CCE3'",
                      index++, half_shown));
    if (chart.band > 0)
      marks.push_back(
          fmt::format("data index {} using 1:2:3:4:5:6 with boxxyerror fs solid noborder lc rgb '#F0F0F0'", index));
    for (const auto* layer : {&below, &lines, &fits, &marks, &top})
      for (const auto& element : *layer) add(element);
  }

  const std::string& text() const { return text_; }

 private:
  void add(const std::string& element) {
    text_ += fmt::format("{}  {} notitle", text_.empty() ? "" : ", \\\n", element);
  }

  std::string look_of(const Rule& rule) const {
    return rule_style(rule) + (rule.kind == Rule::Kind::front ? size(1.7) : "");
  }

  std::string size(double marker) const { return fmt::format("ps {:g} ", marker * mark_scale_); }

  static std::string points_text(int index, int mark, int type, const std::string& look,
                                 const std::string& thinning = {}) {
    return fmt::format("data index {} {}using 1:($4=={}?$3:NaN) with points pt {} {}", index, thinning, mark, type,
                       look);
  }

  static std::string thinning(const Curve& curve) {
    if (curve.every == 1) return {};
    return fmt::format("every {}::{} ", curve.every, (curve.dots.size() - 1) % curve.every);
  }

  std::string crosses(const Curve& curve, int index) const {
    return points_text(index, -1, cross, size(0.85) + "lw 1.8 " + colour_of(curve.style));
  }

  void add_marks(std::vector<std::string>& marks, const Curve& curve, int index) {
    const auto points = [&](int mark, int type, const std::string& look) {
      marks.push_back(points_text(index, mark, type, look, mark == 1 ? thinning(curve) : ""));
    };
    if (curve.square > 0) {
      for (const double part : {behind, 1.0})
        marks.push_back(
            fmt::format("data index {0} using 1:3:({1}):({1}):5 with boxxyerror fs solid noborder lc palette", index,
                        plot_number(0.5 * part * curve.square)));
      return;
    }
    if (has_ranges(curve))
      marks.push_back(
          fmt::format("data index {} using 1:3:5:6 with xerrorbars pt -1 lw 1 {}", index, colour_of(curve.style)));
    const auto [filled, hollow] = marker_of(curve.style);
    const auto add_hollow = [&, filled = filled, hollow = hollow](int mark) {
      points(mark, filled, size(curve.size) + "lc rgb '#FFFFFF'");
      points(mark, hollow, size(curve.size) + "lw 1.3 " + colour_of(curve.style));
    };
    if (curve.marked && has(curve, Mark::outside)) add_hollow(0);
    if (curve.marked && has(curve, Mark::inside)) {
      if (is_hollow(curve.style))
        add_hollow(1);
      else
        points(1, filled, size(curve.size) + colour_of(curve.style));
    }
  }

  double mark_scale_;
  std::string text_;
};

}  // namespace

/// A text for gnuplot, in double quotes. Characters with a meaning in double or in single quotes are written as octal
/// codes. (In single quotes two of them mean one, but not at the text's beginning nor beside others.) Before a bracket
/// at the beginning of LaTeX stands a command that does nothing: gnuplot would take the bracket for the text's
/// alignment.
std::string quoted(const std::string& text, Notation notation) {
  std::string set = typeset(one_line(text), notation);
  if (notation == Notation::latex && set.starts_with('[')) set.insert(0, "\\relax");
  std::string result = "\"";
  for (const char c : set)
    result +=
        std::string_view("\"'\\`@").find(c) == std::string_view::npos ? std::string(1, c) : fmt::format("\\{:03o}", c);
  return result + '"';
}

std::string plot_elements(const Chart& chart, double mark_scale) {
  return Elements(chart, mark_scale).text();
}

int key_marker(const Curve& curve) {
  const bool only_crosses = has(curve, Mark::unstable) && !has(curve, Mark::inside) && !has(curve, Mark::outside);
  if (only_crosses) return cross;
  const auto [filled, hollow] = marker_of(curve.style);
  return is_hollow(curve.style) ? hollow : filled;
}

}  // namespace mpmvv::reports
