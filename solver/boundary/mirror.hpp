#pragma once
#include "solver/boundary/boundary.hpp"

namespace mpmvv::solver {

/// The body continued by its mirror image. Ghost nodes are added to their images (mass, tangential momentum and
/// force as they are, normal ones reversed); afterwards the ghosts carry the mirrored field. A node on the plane is its
/// own image, with the mass that it has within the whole body.
struct Mirror {
  static constexpr std::string_view word = "mirror";
  static constexpr bool holds = false;

  template <int D, class T>
  void sum_images(Grid<D>& grid, Face face, std::vector<T>& field) const {
    const FaceNodes<D> nodes{grid, face};
    for (int layer = 1; layer <= nodes.layers(); ++layer)
      grid.for_plane(face.axis, nodes.ghost(layer), nodes.image(layer), [&](int ghost, int image) {
        field[image] += mirrored(field[ghost], face.axis);
        field[ghost] = mirrored(field[image], face.axis);
      });
    grid.for_plane(face.axis, nodes.plane(), nodes.plane(),
                   [&](int n, int) { field[n] += mirrored(field[n], face.axis); });
  }

  /// Nothing to do: a field made from sums over images is mirrored already.
  template <int D>
  void constrain(Grid<D>&, Face, std::vector<Padded<D>>&) const {}

 private:
  template <class V>
  static V mirrored(V value, int normal) {
    value[normal] = -value[normal];
    return value;
  }
};

}  // namespace mpmvv::solver
