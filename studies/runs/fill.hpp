#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "studies/problems/body.hpp"

namespace mpmvv::runs {

/// The part of a body that a material point stands for.
template <int D>
struct Voxel {
  solver::Vec<D> X;      ///< centroid
  double V;              ///< volume
  solver::Mat<D> edges;  ///< as columns, of the parallelepiped of that volume around X that stands for it
};

/// A part of a body's surface.
template <int D>
struct SurfacePatch {
  std::uint32_t voxel;    ///< the one that it bounds, by its place in the fill
  solver::Vec<D> X;       ///< middle
  solver::Vec<D> normal;  ///< outward, as long as the patch is large: ∫ N dA
};

struct FillDensity {
  double h;  ///< cell width, m
  int ppc;   ///< particles per cell and direction
};

template <int D>
using PlaceVoxel = std::function<void(const Voxel<D>&)>;

/// Equal cubes of width h/ppc, in line with the grid: all of a cuboid; of an annulus those whose middle lies inside,
/// which leaves stairs where it is curved. First axis fastest.
template <int D>
void fill_lattice(const problems::Body<D>& body, FillDensity density, const PlaceVoxel<D>& place);

/// Rows that follow the surfaces of an annulus, ppc per h, from the inner one outwards; along a row the spacing is
/// about its thickness, and the same in every quadrant.
template <int D>
void fill_conforming(const problems::Annulus<D>& annulus, FillDensity density, const PlaceVoxel<D>& place);

/// The surface of a body that its fill follows: a cuboid on its lattice, an annulus in conforming rows.
template <int D>
std::vector<SurfacePatch<D>> surface(const problems::Body<D>& body, FillDensity density);

}  // namespace mpmvv::runs
