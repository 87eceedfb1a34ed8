#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/types.hpp"

namespace mpmvv::runs {

/// A part of the unit circle (D = 2) or sphere (D = 3): all that the voxels of a shell of any thickness need of it.
/// Here e is the unit vector from the origin.
template <int D>
struct SpherePatch {
  double measure;          ///< ∫ dΩ, angle or solid angle
  solver::Vec<D> moment;   ///< ∫ e dΩ
  solver::Mat<D> tangent;  ///< column 0: e at the middle of the patch; columns 1 to D - 1: its edges
};

/// Returns how many parts of about `spacing` a quarter of the unit circle has.
inline int parts_of_quarter(double spacing) {
  return std::max(1, static_cast<int>(std::lround(std::numbers::pi / 2 / spacing)));
}

/// Visits the arcs of the circle, or of its first quarter: equal ones of about `spacing`, anticlockwise from the x
/// axis.
template <class Visit>
void for_circle(double spacing, bool quarter, const Visit& visit) {
  const int parts = parts_of_quarter(spacing);
  const double arc = std::numbers::pi / 2 / parts;
  for (int k = 0; k < (quarter ? 1 : 4) * parts; ++k) {
    const double phi = (k + 0.5) * arc;
    const solver::Vec<2> e{std::cos(phi), std::sin(phi)};
    SpherePatch<2> patch{arc, 2 * std::sin(arc / 2) * e, {}};
    patch.tangent << e, arc * solver::Vec<2>{-e[1], e[0]};
    visit(patch);
  }
}

/// Visits the patches of the sphere, or of its first octant: bands of latitude, each in equal parts of about `spacing`,
/// from the north pole down.
template <class Visit>
void for_sphere(double spacing, bool quarter, const Visit& visit) {
  const int bands = parts_of_quarter(spacing);
  const double height = std::numbers::pi / 2 / bands;
  for (int band = 0; band < (quarter ? 1 : 2) * bands; ++band) {
    const double north = band * height, south = north + height;  // polar angles θ
    const double cap = std::cos(north) - std::cos(south);        // ∫ sin θ dθ
    const double axial =
        (std::sin(south) * std::sin(south) - std::sin(north) * std::sin(north)) / 2;  // ∫ cos θ sin θ dθ
    const double radial = (height - std::sin(height) * std::cos(north + south)) / 2;  // ∫ sin² θ dθ
    for_circle(spacing / std::sin((north + south) / 2), quarter, [&](const SpherePatch<2>& arc) {
      SpherePatch<3> patch{cap * arc.measure, {}, {}};
      patch.moment << radial * arc.moment, axial * arc.measure;
      const solver::Vec<3> e = patch.moment.normalized();
      const solver::Vec<3> east{-arc.tangent(1, 0), arc.tangent(0, 0), 0};
      patch.tangent << e, height * east.cross(e), patch.measure / height * east;
      visit(patch);
    });
  }
}

template <int D, class Visit>
void for_sphere_patches(double spacing, bool quarter, const Visit& visit) {
  if constexpr (D == 2)
    for_circle(spacing, quarter, visit);
  else
    for_sphere(spacing, quarter, visit);
}

}  // namespace mpmvv::runs
