#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include "mms/axis_aligned.hpp"

/// Motions that start at rest from the undeformed body, for codes that take no initial velocity and deformation:
///   u_d = A sin kπX_d sin²(Cπt/2),   C² = E/ρ₀,
/// with a, F, P and b of `AxisAligned`. At t = 2/C the body is at rest and undeformed again.
namespace mpmvv::mms {

namespace detail {

template <int D>
constexpr std::array<Course, D> from_rest() {
  std::array<Course, D> courses;
  courses.fill(Course::from_rest());
  return courses;
}

}  // namespace detail

/// The motion from rest of the periodic bar on [0, 1]: k = 2, ν = 0.
class BarAtRest final : public AxisAligned<1> {
 public:
  BarAtRest(double amplitude, const Elasticity& material)
      : AxisAligned(amplitude, 2, detail::from_rest<1>(), material) {}
};

/// The motion from rest of the unit square in plane strain: k = 1. The normal displacement is zero on the walls, and
/// nothing is sheared along them.
class SquareAtRest final : public AxisAligned<2> {
 public:
  SquareAtRest(double amplitude, const Elasticity& material)
      : AxisAligned(amplitude, 1, detail::from_rest<2>(), material) {}
};

/// The motion from rest of the periodic unit cube: k = 2.
class CubeAtRest final : public AxisAligned<3> {
 public:
  CubeAtRest(double amplitude, const Elasticity& material)
      : AxisAligned(amplitude, 2, detail::from_rest<3>(), material) {}
};

/// The displacement alone, for any scalar type.
template <std::size_t D, int wave_number>
struct AtRestDisplacement {
  double amplitude, wave_speed;

  template <class T>
  std::array<T, D> operator()(const std::array<T, D>& X, const T& t) const {
    using std::sin, std::numbers::pi;
    const T half = sin(wave_speed * pi / 2 * t);
    std::array<T, D> u;
    for (std::size_t d = 0; d < D; ++d) u[d] = amplitude * sin(wave_number * pi * X[d]) * half * half;
    return u;
  }
};

}  // namespace mpmvv::mms
