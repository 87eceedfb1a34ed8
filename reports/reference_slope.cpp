#include "reports/reference_slope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "studies/claims/samples.hpp"

namespace mpmvv::reports {

namespace {

/// The width of a label as a fraction of the chart's: letters are about half as wide as high, and the chart is wider
/// than high. A power's sign is not drawn.
double width_of(const std::string& label, double letter) {
  const auto drawn = static_cast<double>(label.size()) - static_cast<double>(std::ranges::count(label, '^'));
  return 0.37 * letter * drawn;
}

/// How far every place of the chart is from what is drawn already, in fractions of its width and height.
class Clearance {
 public:
  explicit Clearance(const Chart& chart) : chart_(chart) {
    for (const auto& curve : chart.curves) add_curve(curve);
    for (const auto& rule : chart.rules) add_path(rule.path);
    for (const auto& label : chart.labels) add_label(label);
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) field_[index(i, j)] = nearest({at(i), at(j)});
  }

  /// The distance at a place; negative outside the frame and close to it.
  double operator()(const Place& f) const {
    const double frame = 0.75 * chart_.letter;
    if (f.x < frame || f.x > 1 - frame || f.y < frame || f.y > 1 - chart_.band - frame) return -1;
    return field_[index(static_cast<int>(std::lround(f.x * cells)), static_cast<int>(std::lround(f.y * cells)))];
  }

 private:
  static constexpr int cells = 64;
  static double at(int i) { return static_cast<double>(i) / cells; }
  static std::size_t index(int i, int j) { return static_cast<std::size_t>(j * (cells + 1) + i); }

  Place fractions(const Place& p) const { return {chart_.x.fraction(p.x), chart_.y.fraction(p.y)}; }

  void add_label(const Label& label) {
    constexpr int pieces = 4;
    const Place at = fractions(label.at);
    const double width = width_of(label.text, chart_.letter);
    const double left = at.x - (label.side == Label::Side::left    ? 0
                                : label.side == Label::Side::right ? width
                                                                   : width / 2);
    for (int k = 0; k <= pieces; ++k) things_.push_back({left + width * k / pieces, at.y});
  }

  void add_curve(const Curve& curve) {
    std::vector<Place> run;
    for (const auto& dot : curve.dots) {
      if (dot.mark == Mark::absent || dot.mark == Mark::unstable) {
        if (dot.mark == Mark::unstable) things_.push_back(fractions({dot.x, dot.drawn}));
        add_path(std::exchange(run, {}));
      } else {
        run.push_back({dot.x, dot.drawn});
      }
    }
    add_path(run);
  }

  void add_path(const std::vector<Place>& path) {
    constexpr int pieces = 16;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Place b = fractions(path[i]), a = i == 0 ? b : fractions(path[i - 1]);
      for (int k = 1; k <= pieces; ++k)
        things_.push_back({a.x + (b.x - a.x) * k / pieces, a.y + (b.y - a.y) * k / pieces});
    }
  }

  double nearest(const Place& f) const {
    double squared = 4;
    for (const auto& t : things_) squared = std::min(squared, (t.x - f.x) * (t.x - f.x) + (t.y - f.y) * (t.y - f.y));
    return std::sqrt(squared);
  }

  const Chart& chart_;
  std::vector<Place> things_;
  std::array<double, (cells + 1) * (cells + 1)> field_;
};

/// A dashed line, the triangle below it and three texts, in fractions of the chart.
struct SlopeMark {
  Place start, end;
  std::array<Place, 3> triangle;  ///< two corners on the line, the right angle between them
  Place name, rise, run;
  double half_name = 0;  ///< half of the name's width

  SlopeMark(const Place& middle, double width, double slope, double letter, double name_width)
      : half_name(name_width / 2) {
    const auto on_line = [&](double dx) { return Place{middle.x + dx, middle.y + slope * dx}; };
    start = on_line(-width / 2);
    end = on_line(width / 2);
    const Place a = on_line(-0.25 * width), b = on_line(0.25 * width);
    const bool falls = slope < 0;
    triangle = {a, falls ? Place{a.x, b.y} : Place{b.x, a.y}, b};
    const double side = (falls ? -0.375 : 0.375) * letter;
    name = {(falls ? start : end).x, (falls ? start : end).y + letter};
    rise = {triangle[1].x + side, (a.y + b.y) / 2};
    run = {(a.x + b.x) / 2, triangle[1].y - 0.875 * letter};
  }

  double clearance(const Clearance& clear) const {
    double least = std::min({clear({name.x - half_name, name.y}), clear(name), clear({name.x + half_name, name.y}),
                             clear(rise), clear(run), clear(triangle[1])});
    for (int k = 0; k <= 12; ++k)
      least = std::min(least, clear({start.x + (end.x - start.x) * k / 12, start.y + (end.y - start.y) * k / 12}));
    return least;
  }
};

/// The largest mark that is clear of everything, as near to the data as that allows.
std::optional<SlopeMark> best_mark(const Clearance& clear, double slope, double letter, double name_width) {
  constexpr double steps = 50;
  const double enough = 1.125 * letter;
  const double widest = std::min(0.4, 0.45 / std::abs(slope));
  std::optional<SlopeMark> best;
  double best_merit = -1;
  for (const double width : {widest, 0.75 * widest, 0.5 * widest})
    for (double i = 1; i < steps; ++i)
      for (double j = 1; j < steps; ++j) {
        const SlopeMark mark({i / steps, j / steps}, width, slope, letter, name_width);
        const double clearance = mark.clearance(clear);
        if (clearance < 0) continue;
        const double merit = std::min(clearance, enough) / enough + 0.5 * width - 0.5 * clear({i / steps, j / steps});
        if (merit > best_merit) best_merit = merit, best = mark;
      }
  return best;
}

/// "h^2" of a sweep over cells, "ppc^-2" of another one by which errors fall, else "slope 2".
std::string name_of(double p, const std::string& sweep, bool falling) {
  if (!falling) return fmt::format("slope {:g}", p);
  const std::string base = sweep == "cells" ? "h" : sweep;
  const double power = sweep == "cells" ? p : -p;
  return power == 1 ? base : fmt::format("{}^{:g}", base, power);
}

}  // namespace

void add_reference_slope(Chart& chart, double p, const std::string& sweep) {
  const bool falling = claims::step_size(2, sweep) < claims::step_size(1, sweep);
  const double decades_x = std::log10(chart.x.to / chart.x.from);
  const double decades_y = std::log10(chart.y.to / chart.y.from);
  const double slope = (falling ? -p : p) * decades_x / decades_y;
  if (slope == 0) return;  // of a store from when study files might ask for it
  const std::string name = name_of(p, sweep, falling);
  const auto mark = best_mark(Clearance(chart), slope, chart.letter, width_of(name, chart.letter));
  if (!mark) return;

  const auto place = [&](const Place& f) { return Place{chart.x.value(f.x), chart.y.value(f.y)}; };
  const auto& t = mark->triangle;
  chart.rules.push_back(
      {Rule::Kind::reference, 0, fmt::format("reference slope {:g}", p), {place(mark->start), place(mark->end)}});
  chart.rules.push_back(
      {Rule::Kind::triangle, 0, fmt::format("slope triangle {:g}", p), {place(t[0]), place(t[1]), place(t[2])}});
  chart.labels.push_back({place(mark->name), name, Label::Side::centre, true});
  chart.labels.push_back(
      {place(mark->rise), fmt::format("{:g}", p), slope < 0 ? Label::Side::right : Label::Side::left});
  chart.labels.push_back({place(mark->run), "1", Label::Side::centre});
}

}  // namespace mpmvv::reports
