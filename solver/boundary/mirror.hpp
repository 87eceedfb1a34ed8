#pragma once
#include "solver/boundary/boundary.hpp"

namespace mpmvv::solver {

/// The body continued by its mirror image. Ghost nodes are added to their images (mass, tangential momentum and
/// force as they are, normal ones reversed); afterwards the ghosts carry the mirrored field. A node on the plane is its
/// own image, and gets the mass that it has within the whole body.
struct Mirror {
  static constexpr std::string_view word = "mirror";
  static constexpr bool holds = false;

  template <int D, class T>
  void sum_images(Grid<D>& grid, Face face, Array<T>& field) const {
    const FaceNodes<D> nodes{grid, face};
    const T reversed = reversed_along<T>(face.axis);
    for (int layer = 1; layer <= nodes.layers(); ++layer)
      grid.for_plane(face.axis, nodes.at(layer), nodes.image(layer), [&](int ghost, int image) {
        field[image] += reversed.cwiseProduct(field[ghost]);
        field[ghost] = reversed.cwiseProduct(field[image]);
      });
    const T doubled = T::Ones() + reversed;
    grid.for_plane(face.axis, nodes.plane(), [&](int n) { field[n] = doubled.cwiseProduct(field[n]); });
  }

  /// Nothing to do: a field made from sums over images is mirrored already.
  template <int D>
  void constrain(Grid<D>&, Face, Array<Padded<D>>&) const {}

 private:
  /// Returns the factors of the components in a mirror image: -1 for the normal one, 1 for the others. All components
  /// are multiplied at once: when only one was changed in place, every node waited for memory (6 % of a step of the
  /// shell).
  template <class V>
  static V reversed_along(int normal) {
    V signs = V::Ones();
    signs[normal] = -1;
    return signs;
  }
};

}  // namespace mpmvv::solver
