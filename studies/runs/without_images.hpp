#pragma once
#include <cstdint>
#include <vector>

#include "solver/boundary/images.hpp"
#include "studies/runs/fill.hpp"

namespace mpmvv::runs {

/// What is left of a body's fill where the rest is images of it.
template <int D>
class WithoutImages {
 public:
  WithoutImages(solver::Images images, double h) : images_(images), round_off_(1e-9 * h) {}

  /// Particles that one at X and its images are; none where another of them is run. No particle lies on an axis about
  /// which a body turns.
  int count_of([[maybe_unused]] const solver::Vec<D>& X) const {
    if constexpr (D > 1) {
      if (images_ == solver::Images::quarter_turns) return X[0] > 0 && X[1] > 0 ? 4 : 0;
      if (images_ == solver::Images::diagonal) return X[0] > X[1] + round_off_ ? 2 : X[0] > X[1] - round_off_ ? 1 : 0;
    }
    return 1;
  }

  /// Of the volume or the surface at X, as one that is its own image is summed with it.
  double share_of(const solver::Vec<D>& X) const { return static_cast<double>(count_of(X)) / count(images_); }

  /// The patches of those voxels that are run, by their places among these. Takes the fill's voxels in their order.
  std::vector<SurfacePatch<D>> patches(const std::vector<SurfacePatch<D>>& all, const auto& fill) const {
    std::vector<std::uint32_t> places;
    std::uint32_t run = 0;
    fill([&](const Voxel<D>& voxel) { places.push_back(count_of(voxel.X) > 0 ? run++ : run); });
    std::vector<SurfacePatch<D>> left;
    for (const SurfacePatch<D>& patch : all)
      if (const double share = share_of(patch.X); share > 0)
        left.push_back({places[patch.voxel], patch.X, share * patch.normal});
    return left;
  }

 private:
  solver::Images images_;
  double round_off_;
};

}  // namespace mpmvv::runs
