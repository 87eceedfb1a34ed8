#pragma once
#include "solver/boundary/boundary.hpp"

namespace mpmvv::solver {

/// Nodes one period apart are one node: their mapped data is added up on the lower one, and every image gets the
/// sum. Both faces of the axis are periodic; the work is done once, on the lower.
struct Periodic {
  static constexpr std::string_view word = "periodic";
  static constexpr bool holds = false;

  template <int D, class T>
  void sum_images(Grid<D>& grid, Face face, Array<T>& field) const {
    if (face.upper) return;
    const int period = grid.cells()[face.axis];
    for_images(grid, face.axis, period, [&field](int image, int node) { field[node] += field[image]; });
    for_images(grid, face.axis, period, [&field](int image, int node) { field[image] = field[node]; });
  }

  /// Nothing to do: a field made from sums over images is periodic already.
  template <int D>
  void constrain(Grid<D>&, Face, Array<Padded<D>>&) const {}

 private:
  template <int D, class Visit>
  static void for_images(Grid<D>& grid, int axis, int period, const Visit& visit) {
    const auto visit_plane = [&](int i) { grid.for_plane(axis, i, (i % period + period) % period, visit); };
    for (int i = -grid.ghost(); i < 0; ++i) visit_plane(i);
    for (int i = period; i < grid.nodes(axis) - grid.ghost(); ++i) visit_plane(i);
  }
};

}  // namespace mpmvv::solver
