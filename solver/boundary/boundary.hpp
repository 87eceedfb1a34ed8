#pragma once
#include <concepts>
#include <string_view>

#include "solver/grid.hpp"

namespace mpmvv::solver {

/// One face of the domain.
struct Face {
  int axis;
  bool upper;
};

/// The planes of nodes at and beyond a face, by index along its axis: layer 0 is the face itself, and the others are
/// the ghost layers beyond it. The image of a layer lies as far inside the domain.
template <int D>
struct FaceNodes {
  const Grid<D>& grid;
  Face face;

  int layers() const { return grid.ghost(); }
  int plane() const { return face.upper ? grid.inside(face.axis) - 1 : 0; }
  int at(int layer) const { return face.upper ? plane() + layer : -layer; }
  int image(int layer) const { return at(-layer); }
};

/// What a boundary treatment must offer, on one face.
///   word                 its name
///   holds                true when it overwrites velocities, so that S (30) has a meaning
///   sum_images           adds up the nodes that it makes one, in a field mapped from particles: momentum, mass, force
///   constrain            makes a field of vectors (velocity, acceleration) obey the face
/// A boundary that holds velocities also offers
///   constrain_transposed reduces a field of forces to those that drive what it leaves free
template <class B>
concept Boundary = requires(const B boundary, Grid<2>& grid, Face face, Array<Padded<3>>& momentum,
                            Array<Padded<2>>& vectors) {
  { B::word } -> std::convertible_to<std::string_view>;
  { B::holds } -> std::convertible_to<bool>;
  boundary.sum_images(grid, face, momentum);
  boundary.sum_images(grid, face, vectors);
  boundary.constrain(grid, face, vectors);
  requires !B::holds || requires {
    boundary.constrain_transposed(grid, face, vectors);
  };
};

}  // namespace mpmvv::solver
