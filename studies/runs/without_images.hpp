#pragma once
#include <cstdint>
#include <vector>

#include "solver/boundary/images.hpp"
#include "studies/runs/fill.hpp"

namespace mpmvv::runs {

/// Selects the voxels of a body's fill that are kept; the others are images of them.
template <int D>
class WithoutImages {
 public:
  WithoutImages(solver::Images images, double h) : images_(images), round_off_(1e-9 * h) {}

  /// Takes the next voxel of the fill. Returns how many particles it and its images are, or 0 where it is the image of
  /// a voxel that is kept. With quarter turns no voxel may have its middle on x = 0 or y = 0.
  int take(const Voxel<D>& voxel) {
    const int found = count_of(voxel.X);
    if (images_ != solver::Images::none) counts_.push_back(static_cast<std::uint8_t>(found));
    return found;
  }

  /// Returns the share of its volume and surface that a kept voxel gets; `particles` is what `take` returned for it. A
  /// voxel on the mirror plane is its own image and gets half, because the sum over images adds it twice.
  double share(int particles) const { return static_cast<double>(particles) / count(images_); }

  /// Returns the patches of the voxels that are kept. Their `voxel` counts kept voxels alone, and their normals are
  /// multiplied by `share`.
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
  std::vector<std::uint8_t> counts_;  ///< what `take` returned, by voxel of the fill; empty without images
};

}  // namespace mpmvv::runs
