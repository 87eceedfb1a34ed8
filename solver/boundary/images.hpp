#pragma once
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
/// F_0 = Σ_k g^-k f_k and F_k = g^k F_0, where g leads to the next image.
template <class T>
void sum_orbit(Images images, T* const (&orbit)[4]) {
  T sum = *orbit[count(images) - 1];
  for (int k = count(images) - 2; k >= 0; --k) sum = *orbit[k] + previous_image(images, sum);
  for (int k = 0; k < count(images); ++k, sum = next_image(images, sum)) *orbit[k] = sum;
}

/// Adds up a field over the mirror images at the middle of the second axis.
template <int D, class T>
void sum_over_middle(const Grid<D>& grid, Array<T>& field) {
  const int last = grid.inside(1) - 1;
  for (int j = -grid.ghost(); j <= last - j; ++j)
    grid.for_plane(1, j, last - j, [&](int n, int image) {
      T* const nodes = field.data();
      sum_orbit<T>(Images::middle, {nodes + n, nodes + image, nullptr, nullptr});
    });
}

/// Adds up a field mapped from particles over their images.
template <int D, class T>
void sum_over(Images images, const Grid<D>& grid, Array<T>& field) {
  if (images == Images::none) return;
  if constexpr (D > 1) {
    if (images == Images::middle) return sum_over_middle(grid, field);
    const bool is_mirrored = images == Images::diagonal;
    const int nodes = grid.nodes(0), half = nodes / 2, rows = is_mirrored ? nodes : nodes - half;
    // One node of each orbit: up to the diagonal, or of a quadrant, to which a node in the middle belongs.
    const auto columns = [=](int j) { return is_mirrored ? j + 1 : j == half ? rows : half; };
    for (std::size_t first = 0; first < field.size(); first += static_cast<std::size_t>(nodes * nodes)) {
      const auto at = [=, plane = &field[first]](int i, int j) { return plane + j * nodes + i; };
      for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns(j); ++i) {
          const int across = nodes - 1 - i, above = nodes - 1 - j;
          if (is_mirrored)
            sum_orbit<T>(images, {at(i, j), at(j, i), nullptr, nullptr});
          else
            sum_orbit<T>(images, {at(i, j), at(above, i), at(across, above), at(j, across)});
        }
    }
  }
}

}  // namespace mpmvv::solver
