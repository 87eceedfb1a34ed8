#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include "mms/axis_aligned.hpp"

namespace mpmvv::mms {

/// A motion of the unit square in plane strain, W §5.1, C² = E/ρ₀:
///   u_X = A sin πX cos Cπt,   u_Y = A sin πY sin Cπt                                  W (56)
///   F_XX = 1 + Aπ cos πX cos Cπt,   F_YY = 1 + Aπ cos πY sin Cπt,   F_ZZ = 1          W (57)
///   P_XX = (λK + μ (F_XX² - 1)) / F_XX,   K = ln F_XX F_YY, P_YY alike                W (58)
///   b_X = π² u_X/ρ₀ [λ F_XX⁻² (1 - K) + μ (1 + F_XX⁻²) - E], b_Y alike                W (59)
/// The normal displacement vanishes on all four walls, and nothing is sheared along them.
class Square final : public AxisAligned<2> {
 public:
  Square(double amplitude, const Elasticity& material)
      : AxisAligned(amplitude, 1, {{{std::numbers::pi / 2}, {0}}}, material) {}
};

/// The displacement W (56) alone, for any scalar type.
struct SquareDisplacement {
  double amplitude, wave_speed;

  template <class T>
  std::array<T, 2> operator()(const std::array<T, 2>& X, const T& t) const {
    using std::cos, std::sin, std::numbers::pi;
    return {amplitude * sin(pi * X[0]) * cos(wave_speed * pi * t),
            amplitude * sin(pi * X[1]) * sin(wave_speed * pi * t)};
  }
};

}  // namespace mpmvv::mms
