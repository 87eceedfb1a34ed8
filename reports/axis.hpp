#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mpmvv::reports {

struct Tic {
  double at = 0;
  std::string text;  ///< a number, powers as `10^-3`, or a name; empty: a minor tic
};

struct Axis {
  std::string label;
  bool log = false;
  bool names = false;  ///< tic texts are names, not numbers
  double from = 0, to = 1;
  std::vector<Tic> tics;

  double fraction(double value) const;  ///< 0 at `from`, 1 at `to`
  double value(double fraction) const;
  bool holds(double value) const { return value >= from && value <= to; }
};

/// What an axis has to do.
struct AxisWish {
  std::string label;
  bool log = false;
  std::optional<double> from, to;  ///< ends that are fixed
  double below = 0, above = 0;     ///< margins as fractions of the values' span, at ends that are not fixed
  bool tics_at_values = false;     ///< if they are few and far enough apart
};

/// An axis that holds all values it can show (a logarithmic one: the positive ones), with tics.
Axis make_axis(const AxisWish& wish, std::span<const double> values);

}  // namespace mpmvv::reports
