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
  solver::Mat<D> edges;  ///< columns: edges of the parallelepiped around X, of volume V, that stands for the voxel
};

/// A part of a body's surface.
template <int D>
struct SurfacePatch {
  std::uint32_t voxel;    ///< the voxel that the patch bounds, by its place in the order of the fill
  solver::Vec<D> X;       ///< middle of the patch
  solver::Vec<D> normal;  ///< ∫ N dA over the patch, with N outward; where the patch is flat, its length is the area
};

struct FillDensity {
  double h;  ///< cell width, m
  int ppc;   ///< particles per cell and direction
};

template <int D>
using PlaceVoxel = std::function<void(const Voxel<D>&)>;

/// Fills a body with equal cubes of width h/ppc, in line with the grid: those whose middle lies inside. They fill a
/// cuboid wholly, and leave stairs where an annulus is curved. The first axis is fastest. A `grid_offset` does not move
/// the cubes.
template <int D>
void fill_lattice(const problems::Body<D>& body, FillDensity density, const PlaceVoxel<D>& place);

/// Fills an annulus with rows that follow its surfaces, ppc per h, from the inner one outwards. Along a row the spacing
/// is about the thickness of the row, and the same in every quadrant.
template <int D>
void fill_conforming(const problems::Annulus<D>& annulus, FillDensity density, const PlaceVoxel<D>& place);

/// Returns the surface of a body where its fill follows it: of a cuboid or box on its lattice, and of an annulus in
/// conforming rows; empty for blocks.
template <int D>
std::vector<SurfacePatch<D>> surface(const problems::Body<D>& body, FillDensity density);

}  // namespace mpmvv::runs
