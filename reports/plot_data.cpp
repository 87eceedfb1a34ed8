#include <fmt/format.h>

#include <cmath>

#include "reports/plot_elements.hpp"
#include "reports/text.hpp"
#include "reports/unstable_band.hpp"

namespace mpmvv::reports {

std::string plot_number(double v) {
  return std::isnan(v) ? "NaN" : exact(v);
}

std::string one_line(const std::string& text) {
  std::string line = marked_up_text(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return line;
}

std::string plot_data(const Chart& chart) {
  std::string text = fmt::format("# {}\n", one_line(chart.name));
  for (const auto& curve : chart.curves) {
    if (curve.dots.empty()) continue;
    const bool has_bars = has_ranges(curve);
    text += fmt::format("# {}: x, value, drawn at, mark (1 in a window, 0 outside, -1 unstable, -2 none){}\n",
                        one_line(curve.name),
                        curve.square > 0 ? ", error"
                        : has_bars       ? ", smallest and largest x"
                                         : "");
    for (const auto& d : curve.dots) {
      const int mark = d.mark == Mark::inside ? 1 : d.mark == Mark::outside ? 0 : d.mark == Mark::unstable ? -1 : -2;
      text += fmt::format("{} {} {} {}{}\n", plot_number(d.x), plot_number(d.value), plot_number(d.drawn), mark,
                          curve.square > 0 ? " " + plot_number(d.shade)
                          : has_bars       ? fmt::format(" {} {}", plot_number(d.least_x), plot_number(d.most_x))
                                           : "");
    }
    text += "\n\n";
  }
  for (const auto& rule : chart.rules) {
    text += fmt::format("# {}: x, y\n", one_line(rule.meaning));
    for (const auto& p : rule.path) text += fmt::format("{} {}\n", plot_number(p.x), plot_number(p.y));
    text += "\n\n";
  }
  if (!chart.boxes.empty()) {
    text += "# boxes: x, y, width in x, width in y\n";
    for (const auto& b : chart.boxes)
      text += fmt::format("{} {} {} {}\n", plot_number(b.centre.x), plot_number(b.centre.y), plot_number(b.width_x),
                          plot_number(b.width_y));
    text += "\n\n";
  }
  if (chart.band > 0) {
    const double low = top_of_values(chart), middle = chart.y.value(1 - chart.band / 2);
    text += fmt::format("# band of the unstable: x, y, from and to in x, from and to in y\n{} {} {} {} {} {}\n\n\n",
                        plot_number(chart.x.value(0.5)), plot_number(middle), plot_number(chart.x.from),
                        plot_number(chart.x.to), plot_number(low), plot_number(chart.y.to));
  }
  return text;
}

}  // namespace mpmvv::reports
