#pragma once
#include <algorithm>
#include <vector>

namespace mpmvv::fits {

/// The median of at least one value.
inline double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

}  // namespace mpmvv::fits
