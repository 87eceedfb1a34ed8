#pragma once
#include <span>

#include "studies/observed_order.hpp"
#include "studies/result.hpp"

namespace mpmvv {

/// What grids say of a quantity without an exact value: the procedure of Eça and Hoekstra, J. Comput. Phys. 262 (2014)
/// 104-130. On the samples of the window (four or more; e is the quantity, of any sign), in the least-squares sense and
/// both with equal weights and with weights ~ 1/h, it fits
///   φ = φ0 + α h^p,   and where p lies outside [0.5, 2] instead   φ0 + α h,   φ0 + α h²,   or below 0.5 also
///   φ0 + α h + β h²,
/// of which the one with the least standard deviation σ is taken. With ε = |φ - φ0| by the fit at the finest grid,
/// Δ the range of the data over n - 1, and the safety factor F = 1.25 (σ < Δ and p in [0.5, 2.1]), else 3,
///   U = F ε + σ + |φ - φ_fit|   where σ < Δ,   else   U = 3 σ/Δ (ε + σ + |φ - φ_fit|).
/// Beside it Roache's grid convergence index of the three finest grids, 1.25 |φ1 - φ2| / (r^p - 1) with the p that they
/// give, NaN where they do not approach a value monotonically; a remark says so, and where p is an edge of what is
/// searched.
Extrapolation extrapolate(std::span<const ErrorSample> samples, double from, double to);

}  // namespace mpmvv
