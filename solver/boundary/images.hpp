#pragma once
#include <array>
#include <cstddef>
#include <utility>

#include "solver/array.hpp"
#include "solver/grid.hpp"

namespace mpmvv::solver {

/// The images by which a body continues beyond the particles that are run, besides those that boundaries make at faces.
/// The body's motion, the grid and the boundaries must be unchanged by them. They leave the third axis as it is.
enum class Images {
  none,
  middle,        ///< the mirror image in the plane y = 0, which is in the middle of the domain
  diagonal,      ///< the mirror image in the plane x = y
  quarter_turns  ///< three images, by quarter turns from x to y about the origin, the middle of the domain
};

/// Returns how many particles of the body each particle that is run stands for: itself and its images.
constexpr int count(Images images) {
  return images == Images::none ? 1 : images == Images::quarter_turns ? 4 : 2;
}

/// Returns the vector with its second component reversed (`middle`), or with its first two exchanged. For
/// `quarter_turns` the component at `reversed` is reversed afterwards. Further components, such as a mass, stay as they
/// are.
template <class V>
V turned(Images images, V vector, [[maybe_unused]] int reversed) {
  if constexpr (V::SizeAtCompileTime > 1) {
    if (images == Images::middle) vector[1] = -vector[1];
    if (images == Images::diagonal || images == Images::quarter_turns) std::swap(vector[0], vector[1]);
    if (images == Images::quarter_turns) vector[reversed] = -vector[reversed];
  }
  return vector;
}

/// Returns the next image of a vector.
template <class V>
V next_image(Images images, const V& vector) {
  return turned(images, vector, 0);
}

/// Returns the vector whose next image is `vector`.
template <class V>
V previous_image(Images images, const V& vector) {
  return turned(images, vector, 1);
}

/// Gives nodes that are each other's images the sum of what particles and their images add. `orbit` has these nodes in
/// the order of the images: F_0 = Σ_k g^-k f_k and F_k = g^k F_0, where g leads to the next image. Components are added
/// one by one: a processor has to wait where a register is read from memory that was written as single numbers.
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

/// Adds up a plane, with the same number of nodes along both axes, over the mirror images at the diagonal.
template <class T>
void sum_over_diagonal(int nodes, T* plane) {
  for (int j = 0; j < nodes; ++j)
    for (int i = 0; i <= j; ++i) sum_orbit<2, T>(Images::diagonal, {plane + j * nodes + i, plane + i * nodes + j});
}

/// Adds up such a plane over its quarter turns. The quadrant visited includes the node in the middle, if there is one.
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
    if (images == Images::none) return;
    if (images == Images::middle) return sum_over_middle(grid, field.data());
    const int nodes = grid.nodes(0);
    const auto plane = static_cast<std::size_t>(nodes) * static_cast<std::size_t>(nodes);
    for (std::size_t first = 0; first < field.size(); first += plane) {
      if (images == Images::diagonal) sum_over_diagonal(nodes, &field[first]);
      if (images == Images::quarter_turns) sum_over_quarter_turns(nodes, &field[first]);
    }
  }
}

}  // namespace mpmvv::solver
