#include "solver/stencils/stencil_bins.hpp"

#include "solver/stencils/evaluate_points.hpp"

namespace mpmvv::solver {

namespace {

/// The storage indices of the first nodes that particles of a slab may have: from the first to before the second.
template <class B, int D>
std::pair<int, int> first_nodes(const Slabs<D>& slabs, int slab, const Grid<D>& grid) {
  const auto [least, most] = slabs.reach(slab, grid);
  const int layers = grid.nodes(D - 1);
  const auto layer = [&](double x, int beyond, int unbounded) {
    if (!std::isfinite(x)) return unbounded;
    return std::clamp(static_cast<int>(std::floor((x - grid.lower()[D - 1]) / grid.h())) + grid.ghost() + beyond, 0,
                      layers);
  };
  return {layer(least, -B::support, 0) * grid.stride(D - 1), layer(most, 2, layers) * grid.stride(D - 1)};
}

/// Particles with domains have no first node of their own: all of a slab are in one bin.
template <class B>
inline constexpr bool has_first_node = B::width != ParticleWidth::domain;

/// Calls visit(p, first) for the particles of a slab with their first nodes, the last in storage first: what a bin takes
/// last is visited first.
template <class B, int D, class Visit>
void for_first_nodes(const B& basis, const Particles<D>& particles, const Grid<D>& grid, std::size_t begin,
                     std::size_t end, const Visit& visit) {
  PackList<D> block;
  block.packs = block.most_packs;
  std::fill_n(block.filled, block.packs, lanes);
  int first[block_size<D>];
  while (begin < end) {
    const std::size_t count = std::min<std::size_t>(end - begin, block_size<D>);
    for (std::size_t k = 0; k < block_size<D>; ++k)
      block.particle[k] = static_cast<std::uint32_t>(end - 1 - std::min(k, count - 1));
    find_first_nodes(basis, particles, grid, block, first);
    for (std::size_t k = 0; k < count; ++k) visit(block.particle[k], first[k]);
    end -= count;
  }
}

}  // namespace

template <int D>
void StencilBins<D>::fill(const Particles<D>& particles, const Slabs<D>& slabs, ThreadPool& pool) {
  slabs_.resize(static_cast<std::size_t>(slabs.count()));
  pool.run(slabs.count(), [&](int slab) {
    SlabBins& bins = slabs_[static_cast<std::size_t>(slab)];
    const auto [begin, end] = slabs.particles(slab);
    std::visit(
        [&, begin = begin, end = end]<class B>(const B& basis) {
          if constexpr (has_first_node<B>) {
            const auto [lowest, highest] = first_nodes<B>(slabs, slab, grid_);
            bins.clear(lowest, highest, end - begin);
            for_first_nodes(basis, particles, grid_, begin, end,
                            [&](std::uint32_t p, int first) { bins.add(p, first); });
          } else {
            bins.clear(0, 1, end - begin);
            for (std::size_t p = end; p > begin; --p) bins.add(static_cast<std::uint32_t>(p - 1), 0);
          }
        },
        basis_);
  });
}

template <int D>
void StencilBins<D>::update(const Particles<D>& particles, ThreadPool& pool) {
  std::visit(
      [&]<class B>(const B& basis) {
        if constexpr (has_first_node<B>)
          pool.run(static_cast<int>(slabs_.size()), [&](int slab) {
            slabs_[static_cast<std::size_t>(slab)].template update<D>([&](const PackList<D>& block, int* first) {
              find_first_nodes(basis, particles, grid_, block, first);
            });
          });
      },
      basis_);
}

template class StencilBins<1>;
template class StencilBins<2>;
template class StencilBins<3>;

}  // namespace mpmvv::solver
