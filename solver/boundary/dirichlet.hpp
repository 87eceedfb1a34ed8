#pragma once
#include "solver/boundary/boundary.hpp"

namespace mpmvv::solver {

/// Every component zero on the boundary nodes and on the ghost nodes alike, S §3.4.
struct Dirichlet {
  static constexpr std::string_view word = "dirichlet";
  static constexpr bool holds = true;

  template <int D, class T>
  void sum_images(Grid<D>&, Face, Array<T>&) const {}

  template <int D>
  void constrain(Grid<D>& grid, Face face, Array<Padded<D>>& field) const {
    const FaceNodes<D> nodes{grid, face};
    for (int layer = 0; layer <= nodes.layers(); ++layer)
      grid.for_plane(face.axis, nodes.at(layer), [&](int n) { field[n].setZero(); });
  }

  template <int D>
  void constrain_transposed(Grid<D>& grid, Face face, Array<Padded<D>>& field) const {
    constrain(grid, face, field);
  }
};

}  // namespace mpmvv::solver
