#pragma once
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "solver/basis/basis.hpp"
#include "solver/grid.hpp"
#include "solver/parallel/thread_pool.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/stencil_groups.hpp"

namespace mpmvv::solver {

/// Whether the stages of a sweep add to nodes: slabs that share some then have to take turns.
enum class Adds { nothing, to_nodes };

/// The domain cut into slabs across its last axis with about as many particles each, and the particles sorted so that
/// each slab's are contiguous, and in it those that reach the same nodes. A particle may stray one cell out of its slab
/// before it must be sorted again; slabs are so thick that even then two with one between them share no node. Depends
/// on the grid, the basis and the particles alone.
template <int D>
class Slabs {
 public:
  static constexpr int most = 32;

  /// Of any slab, in cells; on average they have one more at least. A particle may stray into it by a cell on either
  /// side and is evaluated up to `reach` cells further in. Between there the first of the `support` nodes that a point
  /// reaches moves on by one a cell, or by one less in all where an edge is missed by round-off. A basis of less than
  /// four nodes takes the slabs of one that has four.
  template <class B>
  static constexpr int least_thickness = 2 * (1 + solver::reach(B::width)) + std::max(B::support, 4) + 1;

  template <class B>
  Slabs(const Grid<D>& grid, const B&)
      : least_thickness_(static_cast<std::size_t>(least_thickness<B>)),
        count_(static_cast<std::size_t>(std::clamp(grid.cells()[D - 1] / (least_thickness<B> + 1), 1, most))),
        offset_(changes_between_nodes<B> ? 0.5 : 0),
        bounds_(count_ + 1),
        first_(count_ + 1),
        first_tile_(count_ + 1) {
    for (int d = 0; d < D; ++d) bins_[d] = grid.cells()[d] + (offset_ > 0 ? 1 : 0);
    bounds_.back() = static_cast<std::size_t>(bins_[D - 1]);
  }

  int count() const { return static_cast<int>(count_); }

  std::pair<std::size_t, std::size_t> particles(int slab) const {
    return {first_[static_cast<std::size_t>(slab)], first_[static_cast<std::size_t>(slab) + 1]};
  }

  /// Between which positions along the last axis a particle of this slab is near enough to it. The outermost slabs
  /// have no outer bound.
  std::pair<double, double> reach(int slab, const Grid<D>& grid) const {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    const auto bound = [this, &grid](int s) {
      return grid.lower()[D - 1] + grid.h() * (static_cast<double>(bounds_[static_cast<std::size_t>(s)]) - offset_);
    };
    return {slab == 0 ? -unbounded : bound(slab) - grid.h(),
            slab + 1 == count() ? unbounded : bound(slab + 1) + grid.h()};
  }

  /// Sorts the particles slab by slab and tile by tile, in a tile by bin, keeping the order of those in one.
  void sort(Particles<D>& particles, const Grid<D>& grid, ThreadPool& pool) {
    const std::size_t n = particles.size();
    bin_.resize(n);
    for_chunks(pool, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) bin_[p] = bin_of(particles.x[p], grid);
    });
    place_.assign(static_cast<std::size_t>(number_of_bins()), 0);
    for (const std::uint32_t b : bin_) ++place_[b];
    cut();
    find_places();
    order_.resize(n);
    for (std::uint32_t p = 0; p < n; ++p) order_[place_[bin_[p]]++] = p;
    if (!std::is_sorted(order_.begin(), order_.end())) particles.permute(order_, pool);
    std::iota(order_.begin(), order_.end(), 0U);
    grouped_.assign(tiles_.size() - 1, 0);
    wasted_ = least_ = 0;
  }

  // For a sweep.

  /// The tiles of a slab: the first, and the one after the last.
  std::pair<std::size_t, std::size_t> tiles(int slab) const {
    return {first_tile_[static_cast<std::size_t>(slab)], first_tile_[static_cast<std::size_t>(slab) + 1]};
  }
  /// The particles of a tile in the order in which they are visited.
  std::span<const std::uint32_t> order(std::size_t tile) const {
    return {&order_[tiles_[tile]], tiles_[tile + 1] - tiles_[tile]};
  }

  /// These particles, in the order in which they are stored.
  std::span<const std::uint32_t> stored(std::size_t begin, std::size_t end) const { return {&order_[begin], end - begin}; }

  /// Brings those of the tile that reach the same nodes together where some have changed theirs, and keeps the order for
  /// the next sweep.
  int group(std::size_t t, Tile<D>& tile) {
    const int visits = count_visits(tile);
    if (16 * visits <= 17 * grouped_[t]) return visits;
    group_by_stencil(tile);
    std::copy_n(tile.particle, tile.count, &order_[tiles_[t]]);
    return grouped_[t] = count_visits(tile);
  }
  /// Those of a slab.
  void add(std::int64_t visits) { std::atomic_ref(visits_).fetch_add(visits, std::memory_order_relaxed); }
  void end_sweep() {
    least_ = least_ == 0 ? visits_ : std::min(least_, visits_);
    wasted_ += visits_ - least_;
    visits_ = 0;
  }
  /// Whether the sweeps since the last sort have lost as much as another sort takes.
  bool are_scattered() const { return static_cast<double>(wasted_) > sort_in_visits * static_cast<double>(order_.size()); }

 private:
  /// What sorting a particle takes, as a part of a visit to a pack or to the nodes of a group.
  static constexpr double sort_in_visits = D == 1 ? 2 : D == 2 ? 1 : 0.3;

  int number_of_bins() const {
    int bins = 1;
    for (const int along_axis : bins_) bins *= along_axis;
    return bins;
  }

  /// Sets the bounds where the particles, counted by bin, are divided most evenly.
  void cut() {
    const std::size_t layers = bounds_.back(), layer = place_.size() / layers;
    std::vector<std::size_t> before(layers + 1);  // particles in the layers before each
    for (std::size_t b = 0; b < place_.size(); ++b) before[b / layer + 1] += place_[b];
    std::partial_sum(before.begin(), before.end(), before.begin());
    for (std::size_t s = 1; s < count_; ++s) {
      const std::size_t lowest = bounds_[s - 1] + least_thickness_;
      const std::size_t highest = layers - (count_ - s) * least_thickness_;
      const std::size_t target = s * before.back() / count_;
      std::size_t z = lowest;
      while (z < highest && before[z + 1] <= target) ++z;
      if (z < highest && target > before[z] && before[z + 1] - target < target - before[z]) ++z;
      bounds_[s] = z;
      first_[s] = before[z];
    }
    first_.back() = before.back();
  }

  /// Cells along each edge of a tile, so that one holds about as many particles as it should.
  int tile_edge() const {
    const auto occupied = place_.size() - static_cast<std::size_t>(std::ranges::count(place_, 0U));
    const double per_bin = static_cast<double>(bin_.size()) / static_cast<double>(std::max<std::size_t>(occupied, 1));
    return std::max(1, static_cast<int>(std::pow(tile_size / per_bin, 1.0 / D) + 1e-9));
  }

  /// From the counts by bin, where the first particle of each goes, and the tiles.
  void find_places() {
    const int edge = tile_edge();
    std::uint32_t next = 0;
    tiles_.assign(1, 0);
    for (std::size_t s = 0; s < count_; ++s) {
      first_tile_[s] = tiles_.size() - 1;
      Index<D> begin{}, end = bins_;
      begin[D - 1] = static_cast<int>(bounds_[s]), end[D - 1] = static_cast<int>(bounds_[s + 1]);
      for_box<D>(begin, end, edge, [&](const Index<D>& corner) {
        Index<D> opposite;
        for (int d = 0; d < D; ++d) opposite[d] = std::min(corner[d] + edge, end[d]);
        for_box<D>(corner, opposite, 1, [&](const Index<D>& bin) {
          std::size_t b = 0;
          for (int d = D - 1; d >= 0; --d) b = b * static_cast<std::size_t>(bins_[d]) + static_cast<std::size_t>(bin[d]);
          next += std::exchange(place_[b], next);
        });
        end_tile(next);
      });
    }
    first_tile_.back() = tiles_.size() - 1;
  }

  /// A tile, or several that are as large, of the particles from the last one's end to before this one.
  void end_tile(std::size_t end) {
    const std::size_t begin = tiles_.back(), parts = (end - begin + most_in_tile - 1) / most_in_tile;
    for (std::size_t k = 1; k <= parts; ++k) tiles_.push_back(begin + k * (end - begin) / parts);
  }

  /// Calls visit(i) for every so many-th index of a box, the first axis fastest.
  template <int axes, class Visit>
  static void for_box(const Index<D>& begin, const Index<D>& end, int step, const Visit& visit) {
    Index<D> i = begin;
    const auto along = [&](const auto& self, int axis) -> void {
      if (axis < 0) return visit(i);
      const auto a = static_cast<std::size_t>(axis);
      for (i[a] = begin[a]; i[a] < end[a]; i[a] += step) self(self, axis - 1);
    };
    along(along, axes - 1);
  }

  /// Bins are cells, or where the nodes that a particle reaches change half-way between nodes, what lies between there.
  std::uint32_t bin_of(const Vec<D>& x, const Grid<D>& grid) const {
    std::uint32_t bin = 0;
    for (int d = D - 1; d >= 0; --d) {
      const double xi = (x[d] - grid.lower()[d]) / grid.h() + offset_;
      const double inside = xi > 0 ? std::min(std::floor(xi), bins_[d] - 1.0) : 0.0;  // 0 for NaN, too
      bin = bin * static_cast<std::uint32_t>(bins_[d]) + static_cast<std::uint32_t>(inside);
    }
    return bin;
  }

  std::size_t least_thickness_, count_;
  double offset_;                    ///< of the bins from the cells, in cells
  Index<D> bins_;                    ///< along each axis
  std::vector<std::size_t> bounds_;  ///< layer of bins where each slab begins, and the end
  std::vector<std::size_t> first_;   ///< first particle of each slab, and the end

  std::vector<std::size_t> first_tile_;  ///< of each slab, and the end
  std::vector<std::size_t> tiles_;       ///< first particle of each tile, and the end
  std::vector<int> grouped_;             ///< visits to each tile when it was last grouped
  std::vector<std::uint32_t> order_;     ///< in which the particles are visited

  std::vector<std::uint32_t> bin_;    ///< of each particle, before the last sort
  std::vector<std::uint32_t> place_;  ///< how many particles each bin has, then where the next of them goes

  std::int64_t visits_ = 0;  ///< in this sweep
  std::int64_t least_ = 0;   ///< in one since the last sort
  std::int64_t wasted_ = 0;  ///< beyond these since the last sort
};

/// Visits all slabs. Where that adds to nodes, those of one colour, which share none, run at once: the order of
/// additions on a node does not depend on the number of threads.
template <int D>
void for_slabs(Adds adds, const Slabs<D>& slabs, ThreadPool& pool, const Task& visit) {
  const int colours = adds == Adds::to_nodes ? 2 : 1;
  for (int colour = 0; colour < colours; ++colour)
    pool.run((slabs.count() - colour + colours - 1) / colours, [&](int task) { visit(colours * task + colour); });
}

}  // namespace mpmvv::solver
