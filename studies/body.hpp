#pragma once
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>
#include <variant>

#include "solver/types.hpp"

namespace mpmvv {

/// An interval, a square or a cube.
template <int D>
struct Cuboid {
  solver::Vec<D> lower = solver::Vec<D>::Zero();
  double length = 1;  ///< m
  double reach = 0;   ///< how far its motion takes it beyond its faces, m
};

/// What lies between two circles or spheres around the origin, or its part where no coordinate is negative.
template <int D>
struct Annulus {
  double inner, outer;   ///< radii, m
  double reach;          ///< how far from the origin its motion takes it, m
  bool quarter = false;  ///< one quadrant, or octant
};

/// The region that a problem's body fills at rest.
template <int D>
using Body = std::conditional_t<D == 1, std::variant<Cuboid<D>>, std::variant<Cuboid<D>, Annulus<D>>>;

/// The cells of width h of the background grid.
template <int D>
struct Domain {
  solver::Vec<D> lower;
  solver::Index<D> cells;
};

template <int D>
std::string description(const Cuboid<D>& cuboid) {
  return fmt::format("each coordinate within {} m of its lower corner", cuboid.length);
}

template <int D>
std::string description(const Annulus<D>& annulus) {
  return fmt::format("between the radii {} and {} m around the origin", annulus.inner, annulus.outer);
}

template <int D>
double volume(const Cuboid<D>& cuboid) {
  return std::pow(cuboid.length, D);
}

template <int D>
double volume(const Annulus<D>& annulus) {
  const double unit_ball = D == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3;
  return unit_ball * (std::pow(annulus.outer, D) - std::pow(annulus.inner, D)) / (annulus.quarter ? 1 << D : 1);
}

/// Whether X lies in the body or at most `slack` away from it.
template <int D>
bool contains(const Cuboid<D>& cuboid, const solver::Vec<D>& X, double slack = 0) {
  const auto inside = (X - cuboid.lower).array();
  return (inside >= -slack).all() && (inside <= cuboid.length + slack).all();
}

template <int D>
bool contains(const Annulus<D>& annulus, const solver::Vec<D>& X, double slack = 0) {
  if (annulus.quarter && (X.array() < -slack).any()) return false;
  const double R = X.norm();
  return R >= annulus.inner - slack && R <= annulus.outer + slack;
}

/// The fewest cells that hold `length`.
inline int cells_in(double length, double h) {
  return static_cast<int>(std::ceil(length / h - 1e-9));
}

/// Faces of the cuboid lie on nodes.
template <int D>
Domain<D> domain(const Cuboid<D>& cuboid, double h) {
  const int margin = cells_in(cuboid.reach, h);
  Domain<D> d{cuboid.lower - solver::Vec<D>::Constant(margin * h), {}};
  d.cells.fill(static_cast<int>(std::lround(cuboid.length / h)) + 2 * margin);
  return d;
}

/// The origin lies on a node, and a cell is left for errors of the motion.
template <int D>
Domain<D> domain(const Annulus<D>& annulus, double h) {
  const int outward = cells_in(annulus.reach, h) + 1;
  Domain<D> d{solver::Vec<D>::Constant(annulus.quarter ? 0 : -outward * h), {}};
  d.cells.fill(annulus.quarter ? outward : 2 * outward);
  return d;
}

}  // namespace mpmvv
