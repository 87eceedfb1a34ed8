#pragma once
#include <cstdint>
#include <vector>

#include "solver/boundary/images.hpp"
#include "studies/runs/fill.hpp"

namespace mpmvv::runs {

/// Of a body's fill, the voxels that are kept: the rest is images of them.
template <int D>
class WithoutImages {
 public:
  WithoutImages(solver::Images images, double h) : images_(images), round_off_(1e-9 * h) {}

  /// Takes the next voxel of the fill. Particles that it and its images are; none where another of them is kept. No
  /// particle lies on an axis about which a body turns.
  int take(const Voxel<D>& voxel) {
    const int found = count_of(voxel.X);
    if (images_ != solver::Images::none) counts_.push_back(static_cast<std::uint8_t>(found));
    return found;
  }

  /// Of the volume or the surface of so many particles, that of the one that is kept: one that is its own image is
  /// summed with it.
  double share(int particles) const { return static_cast<double>(particles) / count(images_); }

  /// The patches of the voxels that are kept, by their places among these.
  std::vector<SurfacePatch<D>> patches(const std::vector<SurfacePatch<D>>& all) const {
    if (images_ == solver::Images::none) return all;
    std::vector<std::uint32_t> places;
    std::uint32_t kept = 0;
    for (const std::uint8_t found : counts_) places.push_back(found > 0 ? kept++ : kept);
    std::vector<SurfacePatch<D>> left;
    for (const SurfacePatch<D>& patch : all)
      if (const int found = counts_[patch.voxel]; found > 0)
        left.push_back({places[patch.voxel], patch.X, share(found) * patch.normal});
    return left;
  }

 private:
  int count_of([[maybe_unused]] const solver::Vec<D>& X) const {
    if constexpr (D > 1) {
      if (images_ == solver::Images::quarter_turns) return X[0] > 0 && X[1] > 0 ? 4 : 0;
      if (images_ == solver::Images::diagonal) return count_beyond_plane(X[0] - X[1]);
      if (images_ == solver::Images::middle) return count_beyond_plane(X[1]);
    }
    return 1;
  }
  int count_beyond_plane(double distance) const { return distance > round_off_ ? 2 : distance > -round_off_ ? 1 : 0; }

  solver::Images images_;
  double round_off_;
  std::vector<std::uint8_t> counts_;  ///< by voxel, where there are images
};

}  // namespace mpmvv::runs
