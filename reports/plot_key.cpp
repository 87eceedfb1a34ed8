#include <fmt/format.h>

#include <algorithm>

#include "reports/plot_elements.hpp"
#include "reports/plot_style.hpp"

namespace mpmvv::reports {

namespace {

/// The width of a sample's line. It differs a little within a group, because gnuplot's SVG gives a sample the dash of
/// the one before it where colour and width are the same.
double sample_line(const Curve& curve) {
  return 1.8 + 0.01 * std::max(0, curve.style.member);
}

/// A line and a marker on it, as the curve has them, at a height of the sheet.
std::string sample_text(const Curve& curve, const KeyPlace& place, double mark_scale) {
  std::string text;
  if (curve.joined)
    text += fmt::format("set arrow from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} nohead front lw {:g} {} {}\n",
                        place.sample_left, place.y, place.sample_right, place.y, sample_line(curve),
                        dash_of(curve.style), colour_of(curve.style));
  if (curve.marked)
    text += fmt::format("set label '' at screen {:.5f},{:.5f} front point pt {} ps {:g} {}\n",
                        (place.sample_left + place.sample_right) / 2, place.y, key_marker(curve),
                        curve.size * mark_scale, colour_of(curve.style));
  return text;
}

}  // namespace

std::string placed_key(const Layout& layout, Notation notation, double mark_scale) {
  std::string text;
  int row = 0;
  for (const KeyEntry& entry : layout.key) {
    text += sample_text(*entry.curve, layout.key_place(row), mark_scale);
    for (const std::string& line : entry.lines) {
      const KeyPlace place = layout.key_place(row++);
      text += fmt::format("set label {} at screen {:.5f},{:.5f} left front {}\n", quoted(line, notation),
                          place.text_left, place.y, notation == Notation::enhanced ? "enhanced" : "noenhanced");
    }
  }
  return text;
}

}  // namespace mpmvv::reports
