#pragma once
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>
#include <variant>

#include "solver/types.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::problems {

/// An interval, a square or a cube.
template <int D>
struct Cuboid {
  solver::Vec<D> lower = solver::Vec<D>::Zero();
  double length = 1;  ///< m
  double reach = 0;   ///< how far its motion takes it beyond its faces, m
};

/// The region between two circles or spheres around the origin, or the part of it where no coordinate is negative.
template <int D>
struct Annulus {
  double inner, outer;   ///< radii, m
  double reach;          ///< how far from the origin its motion takes it, m
  bool quarter = false;  ///< whether it is only that part, a quadrant or octant
};

/// Two equal blocks beside each other along x, with free room around them. The lower corner of the first one is the
/// origin.
template <int D>
struct Blocks {
  solver::Vec<D> size;   ///< of each block, m; a whole number of cells
  int gap_cells;         ///< number of cells between the blocks
  double room;           ///< free room beyond the outer faces of the blocks, m
  double gap = 0;        ///< distance between the blocks, `gap_cells` h, m
  bool quarter = false;  ///< whether it is only the lower half of the first block
};

/// A box whose ends along x may move.
template <int D>
struct Box {
  solver::Vec<D> lower, size;  ///< m; `size` is a whole number of cells
  double end_speed = 0;        ///< largest outward speed of an end, as far as the grid has to make room for it, m/s
  double reach = 0;            ///< how far each end gets until the end time at this speed, m
};

/// The region that a problem's body fills at rest.
template <int D>
using Body =
    std::conditional_t<D == 1, std::variant<Cuboid<D>, Box<D>>, std::variant<Cuboid<D>, Annulus<D>, Blocks<D>, Box<D>>>;

/// The background grid: its lower corner and the number of its cells, of width h, along each axis.
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

template <int D>
std::string description(const Blocks<D>& blocks) {
  return fmt::format("in one of two blocks, {} m along x with {} m between them", blocks.size[0], blocks.gap);
}

template <int D>
double volume(const Blocks<D>& blocks) {
  return 2 * blocks.size.prod() / (blocks.quarter ? 4 : 1);
}

template <int D>
std::string description(const Box<D>& box) {
  std::string text;
  for (int d = 0; d < D; ++d)
    text += fmt::format("{}{} from {} to {} m", d == 0 ? "" : ", ", "xyz"[d], box.lower[d], box.lower[d] + box.size[d]);
  return text;
}

template <int D>
double volume(const Box<D>& box) {
  return box.size.prod();
}

/// Whether X lies in the body or at most `slack` away from it.
template <int D>
bool contains(const Box<D>& box, const solver::Vec<D>& X, double slack = 0) {
  const auto inside = (X - box.lower).array();
  return (inside >= -slack).all() && (inside <= box.size.array() + slack).all();
}

template <int D>
bool contains(const Blocks<D>& blocks, const solver::Vec<D>& X, double slack = 0) {
  const auto in_first = [&](const solver::Vec<D>& Y) {
    return (Y.array() >= -slack).all() && (Y.array() <= blocks.size.array() + slack).all();
  };
  if (blocks.quarter) return in_first(X) && X[1] <= blocks.size[1] / 2 + slack;
  return in_first(X) || in_first(X - (blocks.size[0] + blocks.gap) * solver::Vec<D>::Unit(0));
}

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

/// Returns the fewest cells that hold `length`. Throws UsageError above 1e8, which grids cannot number.
inline int cells_in(double length, double h) {
  const double cells = std::ceil(length / h - 1e-9);
  if (!(cells <= 1e8))
    throw support::UsageError(
        fmt::format("the body reaches {:.3g} m far, {:.3g} cells of {:.3g} m (at most 1e8)", length, cells, h));
  return static_cast<int>(cells);
}

/// Returns a grid with nodes on the faces of the cuboid.
template <int D>
Domain<D> domain(const Cuboid<D>& cuboid, double h) {
  const int margin = cells_in(cuboid.reach, h);
  Domain<D> d{cuboid.lower - solver::Vec<D>::Constant(margin * h), {}};
  d.cells.fill(static_cast<int>(std::lround(cuboid.length / h)) + 2 * margin);
  return d;
}

/// Returns a grid with nodes on the faces of the blocks.
template <int D>
Domain<D> domain(const Blocks<D>& blocks, double h) {
  const int margin = cells_in(blocks.room, h);
  Domain<D> d{solver::Vec<D>::Constant(-margin * h), {}};
  for (std::size_t k = 0; k < D; ++k)
    d.cells[k] = static_cast<int>(std::lround(blocks.size[static_cast<int>(k)] / h)) + 2 * margin;
  d.cells[0] += d.cells[0] - 2 * margin + blocks.gap_cells;
  if (blocks.quarter)
    for (int& n : d.cells) n /= 2;
  return d;
}

/// Returns a grid with nodes on the faces of the box. The sides of the box are faces of the grid. Beyond the reach of
/// its ends one cell is left for errors of the motion.
template <int D>
Domain<D> domain(const Box<D>& box, double h) {
  const int margin = cells_in(box.reach, h) + 1;
  Domain<D> d{box.lower - margin * h * solver::Vec<D>::Unit(0), {}};
  for (std::size_t k = 0; k < D; ++k) d.cells[k] = static_cast<int>(std::lround(box.size[static_cast<int>(k)] / h));
  d.cells[0] += 2 * margin;
  return d;
}

/// Returns a grid with a node at the origin. Beyond the reach of the body one cell is left for errors of the motion.
template <int D>
Domain<D> domain(const Annulus<D>& annulus, double h) {
  const int outward = cells_in(annulus.reach, h) + 1;
  Domain<D> d{solver::Vec<D>::Constant(annulus.quarter ? 0 : -outward * h), {}};
  d.cells.fill(annulus.quarter ? outward : 2 * outward);
  return d;
}

}  // namespace mpmvv::problems
