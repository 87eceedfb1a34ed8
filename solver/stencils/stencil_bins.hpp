#pragma once
#include <vector>

#include "solver/basis/bases.hpp"
#include "solver/grid.hpp"
#include "solver/parallel/slabs.hpp"
#include "solver/stencils/slab_bins.hpp"

namespace mpmvv::solver {

/// In which order a sweep takes the particles of each slab: those that reach the same nodes one after the other.
template <int D>
class StencilBins {
 public:
  StencilBins(const AnyBasis& basis, const Grid<D>& grid) : basis_(basis), grid_(grid) {}

  /// To be called when the particles have been sorted into slabs.
  void fill(const Particles<D>& particles, const Slabs<D>& slabs, ThreadPool& pool);

  /// To be called when they have moved. Without it sweeps give the same results, to round-off, but take longer.
  void update(const Particles<D>& particles, ThreadPool& pool);

  const SlabBins& of(int slab) const { return slabs_[static_cast<std::size_t>(slab)]; }

 private:
  const AnyBasis& basis_;
  const Grid<D>& grid_;
  std::vector<SlabBins> slabs_;
};

extern template class StencilBins<1>;
extern template class StencilBins<2>;
extern template class StencilBins<3>;

}  // namespace mpmvv::solver
