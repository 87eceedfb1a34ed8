#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "solver/types.hpp"
#include "studies/codes/case_particles.hpp"
#include "studies/codes/output_fault.hpp"

namespace mpmvv::codes {

/// Returns the factor between units that differs from the ratio by a factor below `band`: 1000, 100, 0.01 or 0.001; 1
/// if none does.
inline double unit_factor(double ratio, double band = 1.05) {
  for (const double factor : {1000.0, 100.0, 0.01, 0.001})
    if (ratio < factor * band && ratio * band > factor) return factor;
  return 1;
}

/// Throws an OutputFault that names the factor.
[[noreturn]] inline void fail_units(const char* what, double factor, const std::string& file) {
  fail_output("{} in {} are {:g} times those of the case (another unit? --length-unit {:g}, or units of the adapter)",
              what, file, factor, 1 / factor);
}

/// Whether the RMS over the particles of a quantity of the exact solution is more at the end than a quarter of the
/// largest one until then. Else an error of the method may be many times the quantity. `square(X, t)` is its square.
template <int D, class Square>
bool is_large_at_end(const CaseParticles<D>& particles, const Square& square) {
  constexpr int times = 20;
  const std::size_t stride = particles.size() / 500 + 1;
  double squares = 0, largest = 0;
  for (int k = 0; k <= times; ++k) {
    squares = 0;
    for (std::size_t p = 0; p < particles.size(); p += stride)
      squares += square(particles.X[p], particles.end_time * k / times);
    largest = std::max(largest, squares);
  }
  return squares > largest / 16;
}

/// Returns the points relative to their mean.
template <int D>
std::vector<solver::Vec<D>> from_middle(std::vector<solver::Vec<D>> points) {
  solver::Vec<D> middle = solver::Vec<D>::Zero();
  for (const auto& point : points) middle += point / static_cast<double>(points.size());
  for (auto& point : points) point -= middle;
  return points;
}

/// Returns the RMS distance of the points from their mean.
template <int D>
double extent(const std::vector<solver::Vec<D>>& points) {
  double squares = 0;
  for (const auto& way : from_middle(points)) squares += way.squaredNorm();
  return std::sqrt(squares / static_cast<double>(points.size()));
}

/// Returns the factor between units by which vectors differ from those that they should be, if they are nearly
/// proportional to these; else 1.
template <int D>
double factor_between(const std::vector<solver::Vec<D>>& found, const std::vector<solver::Vec<D>>& wanted,
                      double band = 1.05) {
  double ours = 0, both = 0, theirs = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    ours += wanted[k].squaredNorm();
    both += wanted[k].dot(found[k]);
    theirs += found[k].squaredNorm();
  }
  const bool is_alike = both > 0 && both * both > 0.9 * ours * theirs;
  return is_alike ? unit_factor(both / ours, band) : 1;
}

/// Throws an OutputFault if the RMS distance of the places from their mean is about 1000, 100, 0.01 or 0.001 times what
/// it should be.
template <int D>
void require_units(const std::vector<solver::Vec<D>>& places, const std::vector<solver::Vec<D>>& wanted,
                   const std::string& file) {
  if (const double factor = unit_factor(extent(places) / extent(wanted)); factor != 1)
    fail_units("positions", factor, file);
}

}  // namespace mpmvv::codes
