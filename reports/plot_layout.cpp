#include "reports/plot_layout.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace mpmvv::reports {

namespace {

constexpr double points_per_pixel = 0.75;

/// Lengths in sizes of the font.
constexpr double letter_width = 0.52;   ///< on average, of DejaVu Sans: the widest font of those in use
constexpr double capital_width = 0.75;  ///< of LaTeX's fonts, too
constexpr double digit_width = 0.66;
constexpr double sample_width = 3.2;  ///< of a key's line and marker
constexpr double sample_gap = 0.7;    ///< from there to the text
constexpr double key_gap = 1.2;
constexpr double row_height = 1.4;  ///< of the key
constexpr double line_height = 1.25;

double characters(const std::string& utf8) {
  return static_cast<double>(std::ranges::count_if(utf8, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The width of a text, in points.
double text_width(const std::string& text, double font) {
  const auto capitals = static_cast<double>(std::ranges::count_if(text, [](char c) { return c >= 'A' && c <= 'Z'; }));
  return font * (letter_width * characters(text) + (capital_width - letter_width) * capitals);
}

/// Digits and signs are wider than letters are on average.
double tic_width(const Tic& tic, double font) {
  const bool is_word = std::ranges::all_of(tic.text, [](char c) { return c >= 'a' && c <= 'z'; });
  return is_word ? text_width(tic.text, font) : digit_width * font * characters(tic.text);
}

double widest_tic(const Axis& axis, double font) {
  double widest = 0;
  for (const Tic& tic : axis.tics) widest = std::max(widest, tic_width(tic, font));
  return widest;
}

/// Where a text too long for its line is cut: at a gap, or else at the space nearest to its middle; npos without one.
std::size_t cut_of(const std::string& text) {
  if (const auto gap = text.find("   "); gap != std::string::npos) return gap;
  const auto distance = [&](std::size_t cut) {
    return std::abs(2 * static_cast<double>(cut) - static_cast<double>(text.size()));
  };
  std::size_t best = std::string::npos;
  for (std::size_t cut = text.find(' '); cut != std::string::npos; cut = text.find(' ', cut + 1))
    if (best == std::string::npos || distance(cut) < distance(best)) best = cut;
  return best;
}

/// The text in as many lines as it takes.
std::vector<std::string> lines_of(const std::string& text, double font, double room) {
  const std::size_t cut = text_width(text, font) <= room ? std::string::npos : cut_of(text);
  const std::size_t next = cut == std::string::npos ? cut : text.find_first_not_of(' ', cut);
  if (next == std::string::npos) return {text};
  auto lines = lines_of(text.substr(0, cut), font, room);
  for (auto& line : lines_of(text.substr(next), font, room)) lines.push_back(std::move(line));
  return lines;
}

/// The label of the vertical axis in lines that are no longer than the axis.
std::vector<std::string> y_label_lines(const Chart& chart, const Layout& layout) {
  return lines_of(chart.y.label, layout.page.font, layout.page.height - layout.label_room());
}

/// Breaks the titles of panels, which stand beside one another above the axes.
void set_titles(Layout& layout, const Chart& chart) {
  const double font = layout.page.font, across = layout.page.width - layout.left - layout.right;
  std::size_t most = 1;
  for (const Label& title : chart.labels) {
    layout.titles.push_back(lines_of(title.text, font, across / static_cast<double>(chart.labels.size()) - font));
    most = std::max(most, layout.titles.back().size());
  }
  layout.top = (0.55 + line_height * static_cast<double>(most)) * font;
}

/// The key below the axes, in as many columns as fit beside one another; what fits into none is broken into lines.
void set_key(Layout& layout, const Chart& chart) {
  const double font = layout.page.font, beside = (sample_width + sample_gap + key_gap) * font;
  const double room = layout.page.width - beside;
  double widest = 0;
  int rows = 0;
  for (const auto& curve : chart.curves) {
    if (!has_key(curve)) continue;
    layout.key.push_back({&curve, lines_of(curve.key, font, room)});
    rows += static_cast<int>(layout.key.back().lines.size());
    for (const auto& line : layout.key.back().lines) widest = std::max(widest, text_width(line, font));
  }
  if (layout.key.empty()) return;
  layout.key_column = widest + beside;
  const int entries = static_cast<int>(layout.key.size());
  const int fitting = static_cast<int>(layout.page.width / layout.key_column);
  layout.key_columns = rows > entries ? 1 : std::clamp(fitting, 1, std::min(entries, 3));
  layout.key_rows = (rows + layout.key_columns - 1) / layout.key_columns;
}

/// Sets the margins at the sides: on the left room for the axis' label and tics, on the right for labels where the
/// chart asks for it.
void set_sides(Layout& layout, const Chart& chart) {
  const double font = layout.page.font;
  const double label = chart.y.label.empty() ? 0 : line_height * font * static_cast<double>(layout.y_label.size());
  layout.left = 0.4 * font + label + 0.9 * font + widest_tic(chart.y, font);
  const bool labelled = chart.right_margin > Chart{}.right_margin;
  layout.right = 1.2 * font + (labelled ? digit_width * font * static_cast<double>(chart.right_margin) : 0);
}

/// The height of axes on which a unit is as long upwards as across, with their labels and titles.
double height_to_scale(const Layout& layout, const Chart& chart) {
  const double shape = (chart.y.to - chart.y.from) / (chart.x.to - chart.x.from);
  return shape * (layout.page.width - layout.left - layout.right) + layout.label_room() + layout.top;
}

}  // namespace

double Layout::key_height() const {
  return key_rows == 0 ? 0 : (row_height * key_rows + 0.3) * page.font;
}

double Layout::label_room() const {
  return (4.1 + line_height * static_cast<double>(x_label.size() - 1)) * page.font;
}

double Layout::axes_bottom() const {
  return (key_height() + label_room()) / height();
}

double Layout::axes_top() const {
  return 1 - top / height();
}

double Layout::x_label_at(std::size_t line) const {
  const auto lines_below = static_cast<double>(x_label.size() - 1 - line);
  return (key_height() + (1 + line_height * lines_below) * page.font) / height();
}

double Layout::y_label_at(std::size_t line) const {
  return (0.9 + line_height * static_cast<double>(line)) * page.font / page.width;
}

double Layout::title_above_axes(std::size_t lines_below) const {
  return (0.9 + line_height * static_cast<double>(lines_below)) * page.font / height();
}

double Layout::shades_label_at() const {
  return 1 - 0.9 * page.font / page.width;
}

bool Layout::has_room() const {
  constexpr double least = 8;  ///< in sizes of the font
  double widest_title = 0;
  for (const auto& lines : titles)
    for (const std::string& line : lines) widest_title = std::max(widest_title, text_width(line, page.font));
  const double across = (axes_right() - axes_left()) * page.width, up = (axes_top() - axes_bottom()) * height();
  return across >= std::max(least * page.font, static_cast<double>(titles.size()) * widest_title) &&
         (has_named_rows || up >= least * page.font);
}

KeyPlace Layout::key_place(int row) const {
  const double font = page.font;
  const double block = key_columns * key_column - key_gap * font;
  const int column = row / key_rows;
  const double start = std::max(0.4 * font, (page.width - block) / 2) + column * key_column;
  const double y = (row_height * (key_rows - row % key_rows - 0.5) + 0.2) * font;
  return {start / page.width, (start + sample_width * font) / page.width,
          (start + (sample_width + sample_gap) * font) / page.width, y / height()};
}

Layout report_layout(const Chart& chart) {
  Layout layout;
  layout.page.width = chart.width * points_per_pixel;
  layout.page.height = chart.height * points_per_pixel;
  layout.top = 0.8 * layout.page.font;
  layout.x_label = lines_of(chart.x.label, layout.page.font, 0.8 * layout.page.width);
  layout.y_label = y_label_lines(chart, layout);
  set_key(layout, chart);
  if (chart.to_scale && !chart.labels.empty()) {
    set_sides(layout, chart);
    set_titles(layout, chart);
    layout.page.height = std::min(layout.page.height + layout.top, height_to_scale(layout, chart));
  }
  return layout;
}

Layout paper_layout(const Chart& chart, double width, double font, double height) {
  Layout layout;
  layout.page = {width, font, usual_ratio * width};
  set_key(layout, chart);
  if (height > 0) layout.page.height = height - layout.key_height();
  layout.has_named_rows = chart.y.names;
  if (chart.y.names) layout.page.height = chart.height * points_per_pixel * font / PageSize{}.font;
  layout.top = 0.8 * font;
  for (int k = 0; k < 2; ++k) {  // how many lines one label takes depends on the other's
    layout.y_label = y_label_lines(chart, layout);
    set_sides(layout, chart);
    const double centre = (layout.left + width - layout.right) / 2;
    layout.x_label = lines_of(chart.x.label, font, 2 * std::min(centre, width - centre) - font);
  }
  if (chart.to_scale) {
    set_titles(layout, chart);
    layout.page.height = height_to_scale(layout, chart);
  }
  return layout;
}

Axis with_room(Axis axis, double length, double font) {
  double taken = -length;
  for (Tic& tic : axis.tics) {
    const double at = axis.fraction(tic.at) * length, half = (tic_width(tic, font) + 0.4 * font) / 2;
    if (at - half < taken)
      tic.text.clear();
    else if (!tic.text.empty())
      taken = at + half;
  }
  return axis;
}

Axis with_room_upright(Axis axis, double length, double font) {
  constexpr double apart = 1.1;  ///< of two lines' middles, in sizes of the font
  std::vector<Tic*> named;
  for (Tic& tic : axis.tics)
    if (!tic.text.empty()) named.push_back(&tic);
  std::ranges::sort(named, std::greater{}, [](const Tic* tic) { return tic->at; });
  double taken = 2;
  for (Tic* tic : named) {
    const double at = axis.fraction(tic->at);
    if ((taken - at) * length < apart * font)
      tic->text.clear();
    else
      taken = at;
  }
  return axis;
}

}  // namespace mpmvv::reports
