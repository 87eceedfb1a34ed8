#pragma once
#include <algorithm>
#include <limits>
#include <vector>

#include "solver/stencils/particle_pack.hpp"

namespace mpmvv::solver {

/// Between which coordinates the particles of a block lie; those that are NaN do not count.
template <int D>
struct Extent {
  Vec<D> least, most;

  [[gnu::noinline, gnu::flatten]] Extent(const PackList<D>& block, const std::vector<Vec<D>>& x) {
    PackVec<D> low, high;
    low.setConstant(std::numeric_limits<double>::infinity());
    high = -low;
    for_packs(block, [&](const ParticlePack<D>& pack, int) {
      const PackVec<D> place = pack.of(x);
      for (int d = 0; d < D; ++d) {
        low[d] = Pack(Lanes(place[d].of < low[d].of ? place[d].of : low[d].of));
        high[d] = Pack(Lanes(place[d].of > high[d].of ? place[d].of : high[d].of));
      }
    });
    for (int d = 0; d < D; ++d) {
      least[d] = low[d][0], most[d] = high[d][0];
      for (std::size_t lane = 1; lane < lanes; ++lane)
        least[d] = std::min(least[d], low[d][lane]), most[d] = std::max(most[d], high[d][lane]);
    }
  }
};

}  // namespace mpmvv::solver
