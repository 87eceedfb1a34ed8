#pragma once
#include <utility>

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

}  // namespace mpmvv::solver
