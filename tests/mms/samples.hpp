#pragma once
#include <cmath>
#include <vector>

#include "mms/at_rest.hpp"
#include "mms/bar.hpp"
#include "mms/cube.hpp"
#include "mms/derived.hpp"
#include "mms/inverse.hpp"
#include "mms/ring.hpp"
#include "mms/shell.hpp"
#include "mms/square.hpp"
#include "mms/vortex.hpp"
#include "tests/mms/balance.hpp"

namespace mpmvv::mms {

/// Points of the unit cell, its corners, edges and symmetry points among them.
template <int D>
std::vector<Vec<D>> points_of_unit_cell() {
  const std::vector<double> coordinates{0, 0.1, 0.25, 0.37, 0.5, 0.75, 0.9, 1};
  std::vector<Vec<D>> points{Vec<D>::Zero()};
  for (int d = 0; d < D; ++d) {
    std::vector<Vec<D>> more;
    for (Vec<D> X : points)
      for (const double coordinate : coordinates) {
        X[d] = coordinate;
        more.push_back(X);
      }
    points = more;
  }
  return points;
}

/// Unit vectors along the axes, between them, and along none.
template <int D>
std::vector<Vec<D>> directions() {
  std::vector<Vec<D>> all;
  for (int d = 0; d < D; ++d) {
    all.push_back(Vec<D>::Unit(d));
    all.push_back(-Vec<D>::Unit(d));
  }
  all.push_back(Vec<D>::Ones().normalized());
  all.push_back(Vec<D>::LinSpaced(0.3, -0.8).normalized());
  all.push_back(Vec<D>::LinSpaced(-0.9, -0.2).normalized());
  return all;
}

/// Points on both surfaces and inside.
template <int D>
std::vector<Vec<D>> points_between(const Radii& radii) {
  std::vector<Vec<D>> points;
  for (const double depth : {0.0, 0.1, 0.25, 0.5, 0.77, 1.0})
    for (const Vec<D>& e_R : directions<D>())
      points.push_back((radii.inner + depth * (radii.outer - radii.inner)) * e_R);
  return points;
}

/// A solution to try the properties with: its closed forms, the displacement alone, its period in time,
/// points, and a piece to balance forces on.
template <class Closed, class Displacement, int D>
struct Sample {
  static constexpr int dimension = D;
  double amplitude;
  Elasticity material;

  double wave_speed() const { return std::sqrt(material.youngs_modulus / material.density); }
  double period() const { return 2 / wave_speed(); }
  Closed closed() const { return {amplitude, material}; }
  Displacement displacement() const { return {amplitude, wave_speed()}; }
  std::vector<Vec<D>> points() const { return points_of_unit_cell<D>(); }
  Piece<D> piece() const { return box<D>(Vec<D>::Constant(0.1), Vec<D>::Constant(0.3)); }
};

template <class Closed, int D>
struct RadialSample {
  static constexpr int dimension = D;
  double amplitude;
  Radii radii;
  Elasticity material;

  double wave_speed() const { return std::sqrt(material.youngs_modulus / material.density); }
  double period() const { return 2 / wave_speed(); }
  Closed closed() const { return {amplitude, radii, material}; }
  RadialDisplacement<D> displacement() const { return {amplitude, radii, wave_speed()}; }
  std::vector<Vec<D>> points() const { return points_between<D>(radii); }
  Piece<D> piece() const { return sector<D>(radii); }
};

using BarSample = Sample<Bar, BarDisplacement, 1>;
using SquareSample = Sample<Square, SquareDisplacement, 2>;
using CubeSample = Sample<Cube, CubeDisplacement, 3>;
using BarAtRestSample = Sample<BarAtRest, AtRestDisplacement<1, 2>, 1>;
using SquareAtRestSample = Sample<SquareAtRest, AtRestDisplacement<2, 1>, 2>;
using CubeAtRestSample = Sample<CubeAtRest, AtRestDisplacement<3, 2>, 3>;
using SquareInverseSample = Sample<SquareInverse, SquareInverseDisplacement, 2>;
using RingSample = RadialSample<Ring, 2>;
using ShellSample = RadialSample<Shell, 3>;

struct VortexSample {
  static constexpr int dimension = 2;
  double amplitude;
  Radii radii;
  double turning_time;
  Elasticity material;

  double period() const { return 2 * turning_time; }
  Vortex closed() const { return {amplitude, radii, turning_time, material}; }
  VortexDisplacement displacement() const { return {amplitude, radii, turning_time}; }
  std::vector<Vec<2>> points() const { return points_between<2>(radii); }
  Piece<2> piece() const { return sector<2>(radii); }
};

/// A new solution adds its own: defaults, other constants, and an amplitude near the largest that keeps det F > 0.
template <class S>
std::vector<S> samples();
template <>
inline std::vector<BarSample> samples() {
  return {{0.02, {1e4, 0, 1}}, {0.05, {1e4, 0, 1}}, {-0.15, {3e5, 0, 7}}};
}
template <>
inline std::vector<SquareSample> samples() {
  return {{0.1, {1e4, 0.3, 1}}, {0.01, {1e4, 0, 1}}, {-0.3, {3e5, 0.45, 7}}};
}
template <>
inline std::vector<CubeSample> samples() {
  return {{0.05, {1e4, 0.3, 1}}, {0.01, {1e4, 0, 1}}, {-0.15, {3e5, 0.45, 7}}};
}
template <>
inline std::vector<BarAtRestSample> samples() {
  return {{0.02, {1e4, 0, 1}}, {0.05, {1e4, 0, 1}}, {-0.15, {3e5, 0, 7}}};
}
template <>
inline std::vector<SquareAtRestSample> samples() {
  return {{0.02, {1e4, 0.3, 1}}, {0.01, {1e4, 0, 1}}, {-0.3, {3e5, 0.45, 7}}};
}
template <>
inline std::vector<CubeAtRestSample> samples() {
  return {{0.05, {1e4, 0.3, 1}}, {0.01, {1e4, 0, 1}}, {-0.15, {3e5, 0.45, 7}}};
}
template <>
inline std::vector<SquareInverseSample> samples() {
  return {{0.02, {1e4, 0.3, 1}}, {0.01, {1e4, 0, 1}}, {-0.2, {3e5, 0.45, 7}}};
}
template <>
inline std::vector<RingSample> samples() {
  return {{0.1, {0.5, 1}, {1e4, 0, 1}}, {0.1, {0.5, 1}, {1e4, 0.3, 1}}, {-0.46, {0.2, 1.1}, {3e5, 0.45, 7}}};
}
template <>
inline std::vector<ShellSample> samples() {
  return {{0.1, {0.5, 1}, {1e4, 0.3, 1}}, {0.1, {0.5, 1}, {1e4, 0, 1}}, {-0.46, {0.2, 1.1}, {3e5, 0.45, 7}}};
}
template <>
inline std::vector<VortexSample> samples() {
  return {
      {1, {0.75, 1.25}, 1, {1000, 0.3, 1000}}, {0.01, {0.5, 2}, 0.1, {1e4, 0, 1}}, {-2, {0.2, 1}, 3, {10, 0.45, 7}}};
}

}  // namespace mpmvv::mms
