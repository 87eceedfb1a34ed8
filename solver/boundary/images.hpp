#pragma once
#include <array>
#include <cstddef>
#include <utility>

#include "solver/array.hpp"
#include "solver/grid.hpp"

namespace mpmvv::solver {

/// How a body goes on beyond the particles that are run, besides at faces: by images that its motion, the grid and the
/// boundaries share. They leave the third axis as it is.
enum class Images {
  none,
  middle,        ///< the mirror image at the plane y = 0, in the middle of the domain
  diagonal,      ///< the mirror image at the plane x = y
  quarter_turns  ///< three, by quarter turns from x to y about the origin, in the middle of the domain
};

/// The particles that are run and their images.
constexpr int count(Images images) {
  return images == Images::none ? 1 : images == Images::quarter_turns ? 4 : 2;
}

/// A vector with its second component the other way, or with its first two exchanged, after quarter turns the one at
/// `reversed` the other way. Further components, such as a mass, stay as they are.
template <class V>
V turned(Images images, V vector, [[maybe_unused]] int reversed) {
  if constexpr (V::SizeAtCompileTime > 1) {
    if (images == Images::middle) vector[1] = -vector[1];
    if (images == Images::diagonal || images == Images::quarter_turns) std::swap(vector[0], vector[1]);
    if (images == Images::quarter_turns) vector[reversed] = -vector[reversed];
  }
  return vector;
}

/// The next image of a vector.
template <class V>
V next_image(Images images, const V& vector) {
  return turned(images, vector, 0);
}

/// The one whose next image it is.
template <class V>
V previous_image(Images images, const V& vector) {
  return turned(images, vector, 1);
}

/// Gives the nodes that are each other's images, `orbit` in this order, the sum of what particles and their images add:
/// F_0 = Σ_k g^-k f_k and F_k = g^k F_0, where g leads to the next image. By component: a processor waits where what
/// was written as single numbers is read as a register of them.
template <std::size_t count, class T>
void sum_orbit(Images images, const std::array<T*, count>& orbit) {
  T sum = *orbit.back();
  for (std::size_t k = count - 1; k-- > 0;) {
    sum = previous_image(images, sum);
    for (int c = 0; c < sum.size(); ++c) sum[c] += (*orbit[k])[c];
  }
  for (T* const node : orbit) {
    for (int c = 0; c < sum.size(); ++c) (*node)[c] = sum[c];
    sum = next_image(images, sum);
  }
}

/// Adds up a field over the mirror images at the middle of the second axis.
template <int D, class T>
void sum_over_middle(const Grid<D>& grid, T* nodes) {
  const int last = grid.inside(1) - 1;
  for (int j = -grid.ghost(); j <= last - j; ++j)
    grid.for_plane(1, j, last - j, [nodes](int n, int image) {
      sum_orbit<2, T>(Images::middle, {nodes + n, nodes + image});
    });
}

/// Adds up a plane of so many nodes along either axis over the mirror images at the diagonal.
template <class T>
void sum_over_diagonal(int nodes, T* plane) {
  for (int j = 0; j < nodes; ++j)
    for (int i = 0; i <= j; ++i) sum_orbit<2, T>(Images::diagonal, {plane + j * nodes + i, plane + i * nodes + j});
}

/// Adds up such a plane over its quarter turns. A node in the middle belongs to the quadrant that is gone through.
template <class T>
void sum_over_quarter_turns(int nodes, T* plane) {
  const auto at = [=](int i, int j) { return plane + j * nodes + i; };
  const int half = nodes / 2, last = nodes - 1;
  for (int j = 0; j < nodes - half; ++j)
    for (int i = 0; i < (j == half ? nodes - half : half); ++i)
      sum_orbit<4, T>(Images::quarter_turns, {at(i, j), at(last - j, i), at(last - i, last - j), at(j, last - i)});
}

/// Adds up a field mapped from particles over their images.
template <int D, class T>
void sum_over(Images images, const Grid<D>& grid, Array<T>& field) {
  if constexpr (D > 1) {
    if (images == Images::middle) return sum_over_middle(grid, field.data());
    const int nodes = grid.nodes(0);
    for (std::size_t first = 0; first < field.size(); first += static_cast<std::size_t>(nodes * nodes)) {
      if (images == Images::diagonal) sum_over_diagonal(nodes, &field[first]);
      if (images == Images::quarter_turns) sum_over_quarter_turns(nodes, &field[first]);
    }
  }
}

}  // namespace mpmvv::solver
