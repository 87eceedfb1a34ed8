#pragma once
#include <cmath>

namespace mpmvv::fits {

/// Relative difference up to which two swept values are the same: the round-off of a number on its way through a study
/// file, a division and a store.
inline constexpr double level_slack = 1e-9;

/// Whether `x` is the swept value `level`.
inline bool same_level(double x, double level) {
  return std::abs(x - level) <= level_slack * std::abs(level);
}

/// A declared window of swept values.
struct Window {
  double from = 0, to = 0;

  /// Whether x lies inside, its ends included.
  bool holds(double x) const {
    return x >= from - level_slack * std::abs(from) && x <= to + level_slack * std::abs(to);
  }
};

}  // namespace mpmvv::fits
