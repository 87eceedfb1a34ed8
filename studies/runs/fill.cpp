#include "studies/runs/fill.hpp"

#include <Eigen/Geometry>

#include "studies/runs/sphere_patch.hpp"

namespace mpmvv::runs {

using problems::Annulus;

using solver::Mat;
using solver::Vec;

namespace {

/// Visits the middles of a lattice of cubes of the given width, `count` along each axis, the first axis fastest.
template <int D, class Visit>
void for_lattice(const Vec<D>& lower, double width, const solver::Index<D>& count, const Visit& visit) {
  std::size_t cubes = 1;
  for (const int n : count) cubes *= static_cast<std::size_t>(n);
  for (std::size_t k = 0; k < cubes; ++k) {
    Vec<D> X = lower;
    std::size_t rest = k;
    for (std::size_t d = 0; d < D; ++d) {
      const auto n = static_cast<std::size_t>(count[d]);
      X[static_cast<int>(d)] += width * (static_cast<double>(rest % n) + 0.5);
      rest /= n;
    }
    visit(X);
  }
}

/// The rows of a conforming fill.
template <int D>
struct Rows {
  int count;
  double inner, thickness;

  Rows(const Annulus<D>& annulus, FillDensity density)
      : count(std::max(1, static_cast<int>(std::lround(density.ppc * (annulus.outer - annulus.inner) / density.h)))),
        inner(annulus.inner),
        thickness((annulus.outer - annulus.inner) / count) {}

  double bottom(int row) const { return inner + row * thickness; }
  /// Returns the spacing along a row as an angle, so that at the middle of the row it is about the thickness of the
  /// row.
  double spacing(int row) const { return thickness / (bottom(row) + thickness / 2); }
};

template <int D>
std::vector<SurfacePatch<D>> annulus_surface(const Annulus<D>& annulus, FillDensity density) {
  std::vector<SurfacePatch<D>> patches;
  const Rows<D> rows(annulus, density);
  std::uint32_t voxel = 0;
  for (int row = 0; row < rows.count; ++row)
    for_sphere_patches<D>(rows.spacing(row), annulus.quarter, [&](const SpherePatch<D>& patch) {
      const auto add = [&](double R, double outward) {
        patches.push_back({voxel, R * patch.tangent.col(0), outward * std::pow(R, D - 1) * patch.moment});
      };
      if (row == 0) add(annulus.inner, -1);
      if (row == rows.count - 1) add(annulus.outer, 1);
      ++voxel;
    });
  return patches;
}

/// Returns the surface of a body whose faces are planes of the lattice.
template <int D>
std::vector<SurfacePatch<D>> flat_surface(const auto& body, FillDensity density) {
  std::vector<SurfacePatch<D>> patches;
  const double width = density.h / density.ppc;
  std::uint32_t voxel = 0;
  fill_lattice<D>(body, density, [&](const Voxel<D>& v) {
    for (int d = 0; d < D; ++d)
      for (const double outward : {-1.0, 1.0}) {
        const Vec<D> step = outward * width * Vec<D>::Unit(d);
        if (!problems::contains<D>(body, v.X + step))
          patches.push_back({voxel, v.X + step / 2, std::pow(width, D - 1) * outward * Vec<D>::Unit(d)});
      }
    ++voxel;
  });
  return patches;
}

}  // namespace

template <int D>
void fill_lattice(const problems::Body<D>& body, FillDensity density, const PlaceVoxel<D>& place) {
  const double width = density.h / density.ppc;
  Voxel<D> voxel{{}, std::pow(width, D), width * Mat<D>::Identity()};
  const problems::Domain<D> all =
      std::visit([&](const auto& shape) { return problems::domain(shape, density.h); }, body);
  solver::Index<D> count = all.cells;
  for (int& n : count) n *= density.ppc;
  for_lattice<D>(all.lower, width, count, [&](const Vec<D>& X) {
    if (!std::visit([&X](const auto& shape) { return problems::contains<D>(shape, X); }, body)) return;
    voxel.X = X;
    place(voxel);
  });
}

template <int D>
void fill_conforming(const Annulus<D>& annulus, FillDensity density, const PlaceVoxel<D>& place) {
  const Rows<D> rows(annulus, density);
  for (int row = 0; row < rows.count; ++row) {
    const double r = rows.bottom(row), R = rows.bottom(row + 1);
    const double volume = (std::pow(R, D) - std::pow(r, D)) / D;                // ∫ R^(D-1) dR
    const double moment = (std::pow(R, D + 1) - std::pow(r, D + 1)) / (D + 1);  // ∫ R^D dR
    const double scale = std::pow(volume / rows.thickness, 1.0 / (D - 1));
    for_sphere_patches<D>(rows.spacing(row), annulus.quarter, [&](const SpherePatch<D>& patch) {
      Voxel<D> voxel{moment / volume / patch.measure * patch.moment, patch.measure * volume, scale * patch.tangent};
      voxel.edges.col(0) = rows.thickness * patch.tangent.col(0);
      place(voxel);
    });
  }
}

template <int D>
std::vector<SurfacePatch<D>> surface(const problems::Body<D>& body, FillDensity density) {
  if (const auto* cuboid = std::get_if<problems::Cuboid<D>>(&body)) return flat_surface<D>(*cuboid, density);
  if (const auto* box = std::get_if<problems::Box<D>>(&body)) return flat_surface<D>(*box, density);
  if constexpr (D > 1)
    if (const auto* annulus = std::get_if<Annulus<D>>(&body)) return annulus_surface(*annulus, density);
  return {};
}

template void fill_lattice<1>(const problems::Body<1>&, FillDensity, const PlaceVoxel<1>&);
template void fill_lattice<2>(const problems::Body<2>&, FillDensity, const PlaceVoxel<2>&);
template void fill_lattice<3>(const problems::Body<3>&, FillDensity, const PlaceVoxel<3>&);
template void fill_conforming<2>(const Annulus<2>&, FillDensity, const PlaceVoxel<2>&);
template void fill_conforming<3>(const Annulus<3>&, FillDensity, const PlaceVoxel<3>&);
template std::vector<SurfacePatch<1>> surface<1>(const problems::Body<1>&, FillDensity);
template std::vector<SurfacePatch<2>> surface<2>(const problems::Body<2>&, FillDensity);
template std::vector<SurfacePatch<3>> surface<3>(const problems::Body<3>&, FillDensity);

}  // namespace mpmvv::runs
