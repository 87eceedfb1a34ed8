#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include "mms/axis_aligned.hpp"

namespace mpmvv::mms {

/// A motion of the unit cube, S §5.3, C² = E/ρ₀. The phases of the three components are 0, 2π/3 and 4π/3:
///   u_X = A sin 2πX sin Cπt,   u_Y = A sin 2πY sin(2π/3 + Cπt), ...                   S (51)
///   F_XX = 1 + 2Aπ cos 2πX sin Cπt, ...                                               S (52)
///   b_X = π² u_X (4μ/ρ₀ - C² - 4 (λ (K - 1) - μ) / (ρ₀ F_XX²)), ...                   S (53)
///   K = ln F_XX F_YY F_ZZ
/// The motion is periodic, and the normal displacement vanishes on all six faces.
class Cube final : public AxisAligned<3> {
 public:
  Cube(double amplitude, const Elasticity& material)
      : AxisAligned(amplitude, 2, {{{0}, {2 * std::numbers::pi / 3}, {4 * std::numbers::pi / 3}}}, material) {}
};

/// The displacement S (51) alone, for any scalar type.
struct CubeDisplacement {
  double amplitude, wave_speed;

  template <class T>
  std::array<T, 3> operator()(const std::array<T, 3>& X, const T& t) const {
    using std::sin, std::numbers::pi;
    return {amplitude * sin(2 * pi * X[0]) * sin(wave_speed * pi * t),
            amplitude * sin(2 * pi * X[1]) * sin(2 * pi / 3 + wave_speed * pi * t),
            amplitude * sin(2 * pi * X[2]) * sin(4 * pi / 3 + wave_speed * pi * t)};
  }
};

}  // namespace mpmvv::mms
