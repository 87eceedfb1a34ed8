#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "solver/array.hpp"
#include "solver/basis/basis.hpp"
#include "solver/grid.hpp"
#include "solver/parallel/thread_pool.hpp"
#include "solver/particles.hpp"

namespace mpmvv::solver {

/// Whether the kernels of a sweep add to nodes. If they do, slabs that share nodes have to take turns.
enum class Adds { nothing, to_nodes };

/// Cuts the domain across its last axis into slabs with about equally many particles. Sorts the particles so that those
/// of a slab are contiguous and, within a slab, those that reach the same nodes: these nodes then stay in the cache,
/// and four particles of a bar can be visited at once (stencils/pack_stencil.hpp). A particle may stray up to
/// three cells out of its slab before the particles must be sorted again (`WrapPosition` finds out). Slabs are so thick
/// that even then two slabs with another one between them share no node, so threads may add to the nodes of every
/// second slab at once. The slabs depend on the grid, the basis, the particles and how many are asked for, not on the
/// number of threads.
template <int D>
class Slabs {
 public:
  static constexpr std::size_t most = 32;

  /// The least thickness of a slab, in cells, where particles may stray so far. Where there are several slabs, they are
  /// on average at least one cell thicker. Particles of the two neighbours of a slab may stray into it from either
  /// side, and their basis is evaluated up to `reach` cells further in. Over the cells between, the first of the
  /// `support` nodes that a point reaches moves on by one node per cell, or by one node fewer in total where round-off
  /// misses an edge. So the neighbours share no node if `support` and one more cells lie between. A basis with fewer
  /// than four nodes takes the slabs of a basis with four.
  template <class B>
  static constexpr std::size_t least_thickness(int stray) {
    return static_cast<std::size_t>(2 * (stray + solver::reach(B::width)) + std::max(B::support, 4) + 1);
  }

  /// Makes as many slabs as their least thickness allows, but no more than `at_most`, and at least one.
  template <class B>
  Slabs(const Grid<D>& grid, const B&, std::size_t at_most = most)
      : stray_(farthest_stray<B>(static_cast<std::size_t>(grid.cells()[D - 1]))),
        least_thickness_(least_thickness<B>(stray_)),
        count_(std::clamp(static_cast<std::size_t>(grid.cells()[D - 1]) / (least_thickness_ + 1), std::size_t{1},
                          std::clamp(at_most, std::size_t{1}, most))),
        offset_(changes_between_nodes<B> ? 0.5 : 0),
        bounds_(count_ + 1),
        first_(count_ + 1) {
    for (int d = 0; d < D; ++d) bins_[d] = grid.cells()[d] + (offset_ > 0 ? 1 : 0);
    bounds_.back() = static_cast<std::size_t>(bins_[D - 1]);
  }

  int count() const { return static_cast<int>(count_); }

  std::pair<std::size_t, std::size_t> particles(int slab) const {
    return {first_[static_cast<std::size_t>(slab)], first_[static_cast<std::size_t>(slab) + 1]};
  }

  /// Returns the positions along the last axis, in m, between which a particle of this slab may lie before the
  /// particles must be sorted again: the bounds of the slab and as far beyond as particles may stray. The outermost
  /// slabs have no outer bound.
  std::pair<double, double> reach(int slab, const Grid<D>& grid) const {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    const auto bound = [this, &grid](int s) {
      return grid.lower()[D - 1] + grid.h() * (static_cast<double>(bounds_[static_cast<std::size_t>(s)]) - offset_);
    };
    return {slab == 0 ? -unbounded : bound(slab) - stray_ * grid.h(),
            slab + 1 == count() ? unbounded : bound(slab + 1) + stray_ * grid.h()};
  }

  /// Sorts the particles by bin, keeping the order of those in one bin, and sets the bounds of the slabs. The number of
  /// a bin changes slowest along the last axis, so the particles are sorted by slab, too.
  void sort(Particles<D>& particles, const Grid<D>& grid, ThreadPool& pool) {
    const std::size_t n = particles.size();
    bin_.resize(n);
    for_chunks(pool, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) bin_[p] = bin_of(particles.x[p], grid);
    });
    if (!std::is_sorted(bin_.begin(), bin_.end())) {
      place_.assign(count_of_bins() + 1, 0);
      for (const std::uint32_t b : bin_) ++place_[b + 1];
      std::partial_sum(place_.begin(), place_.end(), place_.begin());
      order_.resize(n);
      for (std::uint32_t p = 0; p < n; ++p) order_[place_[bin_[p]]++] = p;
      particles.permute(order_, pool);
    }
    cut(count_of_bins() / bounds_.back());
  }

 private:
  /// How far particles may stray, in cells. On a line and in the plane it is up to three cells, as long as `enough`
  /// slabs remain, of which two may add to nodes at once: the farther, the more seldom particles are sorted, and a step
  /// in the plane takes 0.93 to 0.97 of the time that it takes with one cell on one thread. On more threads than slabs
  /// of a colour it takes longer, but bodies of so few cells have work for few. In space sorting is hardly any part of
  /// a step.
  template <class B>
  static int farthest_stray(std::size_t cells) {
    constexpr std::size_t enough = 4;
    int stray = 1;
    while (D < 3 && stray < 3 && cells >= enough * (least_thickness<B>(stray + 1) + 1)) ++stray;
    return stray;
  }

  std::size_t count_of_bins() const {
    std::size_t bins = 1;
    for (const int along_axis : bins_) bins *= static_cast<std::size_t>(along_axis);
    return bins;
  }

  /// Sets the bounds of the slabs where they divide the particles most evenly, as far as the least thickness allows.
  /// `layer` is the number of bins in a layer.
  void cut(std::size_t layer) {
    std::vector<std::size_t> before(bounds_.back() + 1);  // for each layer, how many particles lie before it
    for (const std::uint32_t b : bin_) ++before[b / layer + 1];
    std::partial_sum(before.begin(), before.end(), before.begin());
    for (std::size_t s = 1; s < count_; ++s) {
      const std::size_t lowest = bounds_[s - 1] + least_thickness_;
      const std::size_t highest = bounds_.back() - (count_ - s) * least_thickness_;
      const std::size_t target = s * bin_.size() / count_;
      std::size_t z = lowest;
      while (z < highest && before[z + 1] <= target) ++z;
      if (z < highest && target > before[z] && before[z + 1] - target < target - before[z]) ++z;
      bounds_[s] = z;
      first_[s] = before[z];
    }
    first_.back() = bin_.size();
  }

  /// Returns the bin of a position. Bins are cells. If the nodes that a particle reaches change half-way between nodes
  /// (`changes_between_nodes`), bins are shifted by half a cell, so that they lie between the places of change.
  std::uint32_t bin_of(const Vec<D>& x, const Grid<D>& grid) const {
    std::uint32_t bin = 0;
    for (int d = D - 1; d >= 0; --d) {
      const double xi = (x[d] - grid.lower()[d]) / grid.h() + offset_;
      const double inside = xi > 0 ? std::min(std::floor(xi), bins_[d] - 1.0) : 0.0;  // 0 for NaN, too
      bin = bin * static_cast<std::uint32_t>(bins_[d]) + static_cast<std::uint32_t>(inside);
    }
    return bin;
  }

  int stray_;  ///< how far, in cells, a particle may stray out of its slab
  std::size_t least_thickness_, count_;
  double offset_;                    ///< by how much the bins lie below the cells, in cells
  Index<D> bins_;                    ///< number of bins along each axis
  std::vector<std::size_t> bounds_;  ///< the layer of bins where each slab begins, and the number of layers
  std::vector<std::size_t> first_;   ///< the first particle of each slab, and the number of particles

  Array<std::uint32_t> bin_;          ///< the bin of each particle, in the order before the last sort
  std::vector<std::uint32_t> place_;  ///< the place where the next particle of each bin goes
  Array<std::uint32_t> order_;        ///< the old index of the particle in each new place
};

/// Visits all slabs. If the visits add to nodes, the slabs with even numbers run first and those with odd numbers after
/// them. Slabs of such a colour share no node and may run at once, so the order of additions on a node does not depend
/// on the number of threads.
template <int D>
void for_slabs(Adds adds, const Slabs<D>& slabs, ThreadPool& pool, const Task& visit) {
  const int colours = adds == Adds::to_nodes ? 2 : 1;
  for (int colour = 0; colour < colours; ++colour)
    pool.run((slabs.count() - colour + colours - 1) / colours, [&](int task) { visit(colours * task + colour); });
}

}  // namespace mpmvv::solver
