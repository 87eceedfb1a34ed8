#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "solver/types.hpp"
#include "studies/codes/output_fault.hpp"

namespace mpmvv::codes {

/// The factor between units that the ratio of two sizes is, within 5 per cent: 1000, 100, 0.01 or 0.001; else 1.
inline double unit_factor(double ratio) {
  for (const double factor : {1000.0, 100.0, 0.01, 0.001})
    if (std::abs(ratio / factor - 1) < 0.05) return factor;
  return 1;
}

/// OutputFault that names the factor.
[[noreturn]] inline void fail_units(const char* what, double factor, const std::string& file) {
  fail_output("{} in {} are {:g} times those of the case (another unit? --length-unit {:g}, or units of the adapter)",
              what, file, factor, 1 / factor);
}

/// RMS distance from their middle.
template <int D>
double extent(const std::vector<solver::Vec<D>>& points) {
  solver::Vec<D> middle = solver::Vec<D>::Zero();
  for (const auto& point : points) middle += point / static_cast<double>(points.size());
  double squares = 0;
  for (const auto& point : points) squares += (point - middle).squaredNorm();
  return std::sqrt(squares / static_cast<double>(points.size()));
}

/// OutputFault where the places are spread a thousand times as far as they should be, or the like.
template <int D>
void require_units(const std::vector<solver::Vec<D>>& places, const std::vector<solver::Vec<D>>& wanted,
                   const std::string& file) {
  if (const double factor = unit_factor(extent(places) / extent(wanted)); factor != 1)
    fail_units("positions", factor, file);
}

}  // namespace mpmvv::codes
