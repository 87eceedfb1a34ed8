#include "reports/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mpmvv::reports {

namespace {

constexpr double few_tics = 12;
constexpr double least_gap = 0.055;
constexpr double least_span = 1e-9;   ///< of the larger end, in decades on a logarithmic axis
constexpr double most_drawn = 1e300;  ///< the plotting program takes sizes from 1/most_drawn to this

double unscaled(const Axis& axis, double scaled) {
  return axis.log ? std::pow(10.0, scaled) : scaled;
}
double scaled(const Axis& axis, double value) {
  return axis.log ? std::log10(value) : value;
}

using Ends = std::pair<double, double>;  ///< in decades on a logarithmic axis

/// The ends, or the farthest that can be drawn.
Ends clamped(Ends ends, bool log) {
  const double most = log ? std::log10(most_drawn) : most_drawn;
  return {std::clamp(ends.first, -most, most), std::clamp(ends.second, -most, most)};
}

/// Ends far enough apart for tics between them.
Ends widened(Ends ends, bool log) {
  const auto [low, high] = ends;
  const double size = std::max({std::abs(low), std::abs(high), log ? 1.0 : 0.0});
  if (high - low > std::max(least_span * size, 1 / most_drawn)) return ends;
  const double half = log || std::abs(low) < 1 / most_drawn ? 0.5 : 0.1 * std::abs(low);
  return {low - half, high + half};
}

/// The ends that hold the values.
Ends ends_of(const AxisWish& wish, std::span<const double> values) {
  double low = INFINITY, high = -INFINITY;
  for (const double v : values) {
    if (!std::isfinite(v) || (wish.log && v <= 0)) continue;
    low = std::min(low, wish.log ? std::log10(v) : v);
    high = std::max(high, wish.log ? std::log10(v) : v);
  }
  return low > high ? Ends{0, 1} : widened(clamped({low, high}, wish.log), wish.log);
}

constexpr int usual_digits = 4;  ///< of a tic's text

/// "10^-3", "2·10^-3"
std::string power_text(double v, int digits = usual_digits) {
  const std::string text = fmt::format("{:.{}e}", v, digits - 1);
  const auto e = text.find('e');
  const std::string mantissa = fmt::format("{:.{}g}", std::stod(text.substr(0, e)), digits);
  const std::string power = fmt::format("10^{}", std::stoi(text.substr(e + 1)));
  return mantissa == "1" ? power : mantissa + "·" + power;
}

/// The number, a whole one below 1e5 with all of its digits.
std::string tic_text(double v, int digits = usual_digits) {
  const double size = std::abs(v);
  if (size >= 1e5 || (size < 0.001 && v != 0)) return power_text(v, digits);
  return v == std::trunc(v) ? fmt::format("{:.0f}", v + 0.0) : fmt::format("{:.{}g}", v, digits);
}

/// Decades; on a short axis their halves or all their multiples too. False, and none, when fewer than two get a text.
bool decade_tics(Axis& axis) {
  const double span = std::log10(axis.to / axis.from);
  const int first = static_cast<int>(std::floor(std::log10(axis.from)));
  const int last = static_cast<int>(std::floor(std::log10(axis.to)));
  const int step = 1 + (last - first) / 10;
  const bool plain = axis.from > 0.005 && axis.to < 2000;
  int texts = 0;
  for (int d = first; d <= last; ++d)
    for (int m = 1; m < 10; ++m) {
      const double at = m * std::pow(10.0, d);
      if (!axis.holds(at) || (m > 1 && step > 1)) continue;
      const bool has_text = span < (plain ? 0.95 : 0.5) ? true
                            : span < 2                  ? m == 1 || m == 2 || m == 5
                                                        : m == 1 && d % step == 0;
      axis.tics.push_back({at, !has_text ? "" : plain ? fmt::format("{:g}", at) : power_text(at)});
      texts += has_text ? 1 : 0;
    }
  if (texts < 2) axis.tics.clear();
  return texts >= 2;
}

/// How many digits a number of the axis takes whose last one tells a step from the next.
int digits_of_steps(const Axis& axis, double step) {
  constexpr int most = 15;
  const double largest = std::max(std::abs(axis.from), std::abs(axis.to));
  const double digits = std::floor(std::log10(largest)) - std::floor(std::log10(step)) + 1;
  return static_cast<int>(std::min<double>(digits, most));
}

void even_tics(Axis& axis) {
  const double rough = (axis.to - axis.from) / 6;
  const double unit = std::pow(10.0, std::floor(std::log10(rough)));
  const double step = unit * (rough < 1.5 * unit ? 1 : rough < 3 * unit ? 2 : rough < 7 * unit ? 5 : 10);
  const double first = std::ceil(axis.from / step);
  const int digits = std::max(usual_digits, digits_of_steps(axis, step));
  for (int k = 0; k <= few_tics && (first + k) * step <= axis.to; ++k)
    axis.tics.push_back({(first + k) * step, tic_text((first + k) * step, digits)});
}

/// Ends that the plotting program takes and that tics fit between; those that are so already stay as they are.
void make_drawable(Axis& axis) {
  const Ends wished{scaled(axis, axis.from), scaled(axis, axis.to)};
  const Ends drawn = widened(clamped(wished, axis.log), axis.log);
  if (drawn.first != wished.first) axis.from = unscaled(axis, drawn.first);
  if (drawn.second != wished.second) axis.to = unscaled(axis, drawn.second);
}

/// One tic per distinct value; false, and none, when they are too many or too close.
bool value_tics(Axis& axis, std::span<const double> values) {
  std::vector<double> distinct;
  std::ranges::copy_if(values, std::back_inserter(distinct), [&](double v) { return axis.holds(v); });
  std::ranges::sort(distinct);
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() < 2 || static_cast<double>(distinct.size()) > few_tics) return false;
  for (std::size_t i = 1; i < distinct.size(); ++i)
    if (axis.fraction(distinct[i]) - axis.fraction(distinct[i - 1]) < least_gap) return false;
  for (const double v : distinct) axis.tics.push_back({v, tic_text(v)});
  return true;
}

}  // namespace

double Axis::fraction(double value) const {
  return (scaled(*this, value) - scaled(*this, from)) / (scaled(*this, to) - scaled(*this, from));
}

double Axis::value(double fraction) const {
  return unscaled(*this, scaled(*this, from) + fraction * (scaled(*this, to) - scaled(*this, from)));
}

Axis make_axis(const AxisWish& wish, std::span<const double> values) {
  const auto [low, high] = ends_of(wish, values);
  const auto usable = [&](const std::optional<double>& end) {
    return end && std::isfinite(*end) && (*end > 0 || !wish.log);
  };
  Axis axis;
  axis.label = wish.label;
  axis.log = wish.log;
  axis.from = usable(wish.from) ? *wish.from : unscaled(axis, low - wish.below * (high - low));
  axis.to = usable(wish.to) ? *wish.to : unscaled(axis, high + wish.above * (high - low));
  if (!(axis.from < axis.to)) axis.to = axis.log ? axis.from * 10 : axis.from + 1;
  make_drawable(axis);
  if (wish.tics_at_values && value_tics(axis, values)) return axis;
  if (wish.log && decade_tics(axis)) return axis;
  even_tics(axis);
  return axis;
}

}  // namespace mpmvv::reports
