#pragma once
#include <cmath>

namespace mpmvv::fits {

/// A declared window of swept values.
struct Window {
  double from = 0, to = 0;

  /// Whether x lies inside, to a relative 1e-9.
  bool holds(double x) const { return x >= from - 1e-9 * std::abs(from) && x <= to + 1e-9 * std::abs(to); }
};

}  // namespace mpmvv::fits
