#pragma once
#include <algorithm>
#include <limits>

#include "solver/array.hpp"
#include "solver/stencils/particle_pack.hpp"

namespace mpmvv::solver {

/// The least and the greatest coordinates of the particles of a block. Coordinates that are NaN do not count.
template <int D>
struct Extent {
  Vec<D> least, most;

  [[gnu::noinline, gnu::flatten]] Extent(const Block<D>& block, const Array<Vec<D>>& x) {
    PackVec<D> low = PackVec<D>::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for_packs(block, [&](const ParticlePack& pack, int) {
      const PackVec<D> x_four = pack.of(x);
      for (int d = 0; d < D; ++d) {
        low[d] = Pack(Double4(x_four[d].of < low[d].of ? x_four[d].of : low[d].of));
        high[d] = Pack(Double4(x_four[d].of > high[d].of ? x_four[d].of : high[d].of));
      }
    });
    for (int d = 0; d < D; ++d) {
      least[d] = std::min({low[d][0], low[d][1], low[d][2], low[d][3]});
      most[d] = std::max({high[d][0], high[d][1], high[d][2], high[d][3]});
    }
  }
};

}  // namespace mpmvv::solver
