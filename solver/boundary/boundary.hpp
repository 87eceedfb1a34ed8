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

/// The nodes at and beyond a face: its plane, and per ghost layer the plane and its mirror image inside.
template <int D>
struct FaceNodes {
  const Grid<D>& grid;
  Face face;

  int layers() const { return grid.ghost(); }
  int plane() const { return face.upper ? grid.inside(face.axis) - 1 : 0; }
  int ghost(int layer) const { return face.upper ? plane() + layer : -layer; }
  int image(int layer) const { return face.upper ? plane() - layer : layer; }
};

/// What a boundary treatment must offer, on one face.
///   word                 its name
///   holds                true when it overwrites velocities, so that S (30) has a meaning
///   sum_images           adds up what belongs together in a field mapped from particles: momentum, mass, force
///   constrain            makes a field of vectors (velocity, acceleration) obey the face
/// and one that holds velocities
///   constrain_transposed takes the part of a field of forces that drives what it leaves free
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
