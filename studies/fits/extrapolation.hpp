#pragma once
#include <span>
#include <string>

#include "studies/fits/observed_order.hpp"
#include "studies/support/not_measured.hpp"

namespace mpmvv::fits {

using support::not_measured;

/// A quantity without an exact value, extrapolated over the grids of a window.
struct Extrapolation {
  std::string norm;  ///< the quantity
  double from = 0, to = 0;
  int points = 0;
  std::string model;                        ///< the form taken, or why there is none
  double order = not_measured;              ///< p that the free fit finds
  double limit = not_measured;              ///< φ0
  double deviation = not_measured;          ///< σ
  double finest = not_measured;             ///< φ of the finest grid
  double uncertainty = not_measured;        ///< U of `finest`, 95 %
  double convergence_index = not_measured;  ///< Roache's GCI of `finest`, absolute
  std::string remark = {};  ///< why there is no GCI, and whether p is at an edge of the scan; else empty
};

/// Extrapolates a quantity without an exact value from its values on several grids, by the procedure of Eça and
/// Hoekstra, J. Comput. Phys. 262 (2014) 104-130. It needs four samples or more in the window; their e is the quantity,
/// of any sign. It fits by least squares, both with equal weights and with weights ~ 1/h,
///   φ = φ0 + α h^p,   and where p lies outside [0.5, 2] instead   φ0 + α h,   φ0 + α h²,   or below 0.5 also
///   φ0 + α h + β h²,
/// and takes the fit with the least standard deviation σ. With ε = |φ - φ0| by the fit at the finest grid, Δ the range
/// of the data over n - 1, and the safety factor F = 1.25 (σ < Δ and p in [0.5, 2.1]), else 3,
///   U = F ε + σ + |φ - φ_fit|   where σ < Δ,   else   U = 3 σ/Δ (ε + σ + |φ - φ_fit|).
/// Beside U it gives Roache's grid convergence index of the three finest grids, 1.25 |φ1 - φ2| / (r^p - 1) with the p
/// of these grids. The index is NaN where they do not approach a value monotonically. `remark` says so, and whether the
/// p of the fit is at an edge of the range searched. Throws UsageError unless from <= to.
Extrapolation extrapolate(std::span<const ErrorSample> samples, double from, double to);

}  // namespace mpmvv::fits
