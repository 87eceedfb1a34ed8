#pragma once
#include "solver/boundary/boundary.hpp"

namespace mpmvv::solver {

/// Normal component zero on the plane and, on a ghost node, the negative of its mirror image's; tangential
/// components as computed, S §3.4.2.
struct Symmetry {
  static constexpr std::string_view word = "symmetry";
  static constexpr bool holds = true;

  template <int D, class T>
  void sum_images(Grid<D>&, Face, Array<T>&) const {}

  template <int D>
  void constrain(Grid<D>& grid, Face face, Array<Padded<D>>& field) const {
    const FaceNodes<D> nodes{grid, face};
    const int normal = face.axis;
    grid.for_plane(normal, nodes.plane(), [&](int n) { field[n][normal] = 0; });
    for (int layer = 1; layer <= nodes.layers(); ++layer)
      grid.for_plane(normal, nodes.at(layer), nodes.image(layer),
                     [&](int ghost, int image) { field[ghost][normal] = -field[image][normal]; });
  }

  /// Adds the normal force on a ghost node, reversed, to that on its image. On the plane the normal force becomes zero.
  template <int D>
  void constrain_transposed(Grid<D>& grid, Face face, Array<Padded<D>>& field) const {
    const FaceNodes<D> nodes{grid, face};
    const int normal = face.axis;
    grid.for_plane(normal, nodes.plane(), [&](int n) { field[n][normal] = 0; });
    for (int layer = 1; layer <= nodes.layers(); ++layer)
      grid.for_plane(normal, nodes.at(layer), nodes.image(layer), [&](int ghost, int image) {
        field[image][normal] -= field[ghost][normal];
        field[ghost][normal] = 0;
      });
  }
};

}  // namespace mpmvv::solver
