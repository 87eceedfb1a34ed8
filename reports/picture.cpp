#include "reports/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "reports/text.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::reports {

namespace {

constexpr std::size_t most_described = 8;  ///< curves or rows

std::string axis_words(const Axis& axis) {
  return axis.label.empty() ? "rows" : axis.label + (axis.log ? " (logarithmic)" : "");
}

bool is_outline(const std::vector<Dot>& dots) {
  return dots.size() > 2 && dots.front().x == dots.back().x && dots.front().value == dots.back().value;
}

/// "bspline2, 4 PPC   2.01 ± 0.03: from 0.0067 at 8 to 0.00015 at 512, unstable at 1 point"
std::string curve_words(const Curve& curve) {
  std::vector<Dot> dots;
  std::ranges::copy_if(curve.dots, std::back_inserter(dots),
                       [](const Dot& d) { return d.mark == Mark::inside || d.mark == Mark::outside; });
  const auto unstable = std::ranges::count(curve.dots, Mark::unstable, &Dot::mark);
  std::string text = curve.key.empty() ? curve.name : curve.key;
  if (is_outline(dots)) {
    const auto [left, right] = std::ranges::minmax(dots, {}, &Dot::x);
    const auto [low, high] = std::ranges::minmax(dots, {}, &Dot::value);
    text += fmt::format(": an outline from {} to {}, and from {} to {} upwards", brief(left.x), brief(right.x),
                        brief(low.value), brief(high.value));
  } else if (!dots.empty()) {
    text += fmt::format(": from {} at {} to {} at {}", brief(dots.front().value), brief(dots.front().x),
                        brief(dots.back().value), brief(dots.back().x));
  }
  if (unstable > 0) text += fmt::format(", unstable at {} of {} points", unstable, curve.dots.size());
  return text;
}

/// "2 PPC: limit 0.439, stable at 7 of 12 values": a row of a stability map.
std::string row_words(const Chart& chart, const Tic& row) {
  std::size_t stable = 0, all = 0;
  for (const Curve& curve : chart.curves)
    for (const Dot& dot : curve.dots)
      if (dot.drawn == row.at) ++all, stable += dot.mark == Mark::inside ? 1 : 0;
  std::string limit;
  for (const Label& label : chart.labels)
    if (label.at.y == row.at) limit = label.text;
  return fmt::format("{}: limit {}, stable at {} of {} values", row.text, limit, stable, all);
}

/// What each curve, or each row of a stability map, shows.
std::vector<std::string> parts_in_words(const Chart& chart) {
  std::vector<std::string> parts;
  if (chart.y.names)
    for (const Tic& row : chart.y.tics) parts.push_back(row_words(chart, row));
  else
    for (const Curve& curve : chart.curves) parts.push_back(curve_words(curve));
  return parts;
}

/// Width and height in the SVG's own unit.
void read_size(const std::string& svg, Picture& picture) {
  const auto at = svg.find("viewBox=\"0 0 ");
  if (at == std::string::npos) return;
  std::istringstream numbers(svg.substr(at + 13, 40));
  numbers >> picture.width >> picture.height;
}

/// ", errors from 1.2e-06 to 0.00031"
std::string shades_words(const Curve& curve) {
  if (curve.square == 0) return "";
  const auto [least, most] = std::ranges::minmax_element(curve.dots, {}, &Dot::shade);
  return fmt::format(", errors from {} to {}", brief(least->shade), brief(most->shade));
}

Picture picture_of(const Chart& chart, const std::string& folder, const std::string& svg) {
  const std::string caption = chart.trial.empty() ? chart.caption : chart.caption + " " + chart.trial;
  Picture picture{chart.name, folder, caption, chart.notes, description_of(chart)};
  picture.notes.insert(picture.notes.end(), chart.omissions.begin(), chart.omissions.end());
  read_size(svg, picture);
  return picture;
}

std::string svg_of(const Chart& chart, const std::filesystem::path& folder) {
  return support::read_file(folder / (chart.name + ".svg")).value_or("");
}

}  // namespace

std::string description_of(const Chart& chart) {
  std::string text =
      fmt::format("{} against {}.", chart.y.names ? "Stable and unstable runs of each series" : axis_words(chart.y),
                  axis_words(chart.x));
  if (chart.of_particles) {
    text = "Particles, to scale:";
    for (const auto& curve : chart.curves)
      text += fmt::format(" {} of {}{};", curve.dots.size(), curve.name, shades_words(curve));
    text.back() = '.';
    return text;
  }
  const std::vector<std::string> parts = parts_in_words(chart);
  for (std::size_t i = 0; i < std::min(most_described, parts.size()); ++i) text += " " + parts[i] + ".";
  if (parts.size() > most_described)
    text += fmt::format(" And {} more {}.", parts.size() - most_described, chart.y.names ? "rows" : "curves");
  return text;
}

std::vector<Picture> pictures_of(const std::vector<Chart>& charts, const std::filesystem::path& out_dir,
                                 const std::string& folder) {
  std::vector<Picture> pictures;
  for (const auto& chart : charts) pictures.push_back(picture_of(chart, folder, svg_of(chart, out_dir / folder)));
  return pictures;
}

std::vector<Picture> pictures_of(const std::vector<Chart>& charts, const std::filesystem::path& out_dir,
                                 const std::string& folder, const records::StudyResult& study,
                                 const std::vector<SeriesCommand>& commands) {
  std::vector<Picture> pictures;
  for (const auto& chart : charts) {
    const std::string svg = svg_of(chart, out_dir / folder);
    pictures.push_back(picture_of(chart, folder, svg));
    pictures.back().points = points_of(chart, svg, study, commands);
  }
  return pictures;
}

}  // namespace mpmvv::reports
