#include "solver/mass_product.hpp"

#include <algorithm>

#include "solver/kernels/add_mass_product.hpp"
#include "solver/stencils/node_loop.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

namespace {

/// Keeps the stencils of particles that have domains: a block kernel.
template <int D>
struct KeepStencils {
  CpdiStencilCache<D>& cache;

  void operator()(const Block<D>&, const Grid<D>&) const {}
  template <int K>
  void operator()(const CpdiBlock<D, K>& block, const Grid<D>& grid) const {
    cache.keep(block, grid);
  }
};

/// As the sweep of `AddMassProduct`, by stencils of W nodes along each axis that are kept.
template <int W, int D>
void add_by_cache(Step<D>& s, const CpdiStencilCache<D>& cache, const AddMassProduct<D>& kernel) {
  s.for_slabs([&](std::size_t begin, std::size_t end) {
    for (; begin < end; begin += cpdi_block_size<D>)
      for_interleaved(static_cast<int>(std::min<std::size_t>(cpdi_block_size<D>, end - begin)), [&](int k) {
        const std::size_t p = begin + static_cast<std::size_t>(k);
        const auto nodes = cache.template stencil<W>(p, s.grid());
        nodes.scatter(kernel(p, nodes, cache), kernel.product);
      });
  });
}

}  // namespace

template <int D>
MassProduct<D>::MassProduct(const Step<D>& s, int most) {
  std::visit(
      [&]<class B>(const B&) {
        if constexpr (B::width == ParticleWidth::domain)
          if (most > 1) cache_.emplace(B::support, s.particles().size());
      },
      s.scene().basis);
}

template <int D>
void MassProduct<D>::prepare(Step<D>& s) {
  if (!cache_ || kept_after_ == s.moves()) return;
  kept_after_ = s.moves();
  cache_->clear();
  s.sweep({KeepStencils<D>{*cache_}}, Adds::nothing);
}

template <int D>
void MassProduct<D>::add(Step<D>& s, const Field& u, Field& field) const {
  const AddMassProduct<D> kernel{s.particles(), u, field};
  if (!uses_cache()) return s.sweep({kernel});
  std::visit(
      [&]<class B>(const B&) {
        if constexpr (B::width == ParticleWidth::domain) add_by_cache<B::support + 1>(s, *cache_, kernel);
      },
      s.scene().basis);
}

template class MassProduct<1>;
template class MassProduct<2>;
template class MassProduct<3>;

}  // namespace mpmvv::solver
