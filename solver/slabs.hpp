#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "solver/grid.hpp"
#include "solver/particles.hpp"

namespace mpmvv::solver {

/// Whether the stages of a sweep add to nodes: slabs that share some then have to take turns.
enum class Adds { nothing, to_nodes };

/// The domain cut into slabs across its last axis with about as many particles each, and the particles sorted so that
/// each slab's are contiguous. A particle may stray one cell out of its slab before it must be sorted again; slabs are
/// so thick that even then two with one between them share no node: a basis reaches three nodes at most from where it
/// is evaluated, which is up to `reach` cells from its particle. Depends on the grid, the basis and the particles
/// alone.
template <int D>
class Slabs {
 public:
  static constexpr int thickness = 8;        ///< on average, at least
  static constexpr int least_thickness = 7;  ///< of any
  static constexpr int most = 32;

  Slabs(const Grid<D>& grid, int reach)
      : least_thickness_(static_cast<std::size_t>(least_thickness + 2 * reach)),
        count_(static_cast<std::size_t>(std::clamp(grid.cells()[D - 1] / (thickness + 2 * reach), 1, most))),
        bounds_(count_ + 1),
        first_(count_ + 1) {
    bounds_.back() = static_cast<std::size_t>(grid.cells()[D - 1]);
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
      return grid.lower()[D - 1] + grid.h() * static_cast<double>(bounds_[static_cast<std::size_t>(s)]);
    };
    return {slab == 0 ? -unbounded : bound(slab) - grid.h(),
            slab + 1 == count() ? unbounded : bound(slab + 1) + grid.h()};
  }

  /// Sorts the particles by cell (the last axis slowest, so by slab), keeping the order of those in one cell.
  void sort(Particles<D>& particles, const Grid<D>& grid) {
    const std::size_t n = particles.size();
    std::vector<std::uint32_t> cell(n), order(n);
    for (std::size_t p = 0; p < n; ++p) cell[p] = cell_of(particles.x[p], grid);
    if (!std::is_sorted(cell.begin(), cell.end())) {
      std::vector<std::uint32_t> place(cells_of(grid) + 1);  // where the next particle of each cell goes
      for (const std::uint32_t c : cell) ++place[c + 1];
      std::partial_sum(place.begin(), place.end(), place.begin());
      for (std::uint32_t p = 0; p < n; ++p) order[place[cell[p]]++] = p;
      particles.permute(order);
    }
    cut(cell, cells_of(grid) / bounds_.back());
  }

 private:
  static std::size_t cells_of(const Grid<D>& grid) {
    std::size_t cells = 1;
    for (const int along_axis : grid.cells()) cells *= static_cast<std::size_t>(along_axis);
    return cells;
  }

  /// Sets the bounds where the particles of these cells, so many to a layer, are divided most evenly.
  void cut(const std::vector<std::uint32_t>& cell, std::size_t layer) {
    std::vector<std::size_t> before(bounds_.back() + 1);  // particles in the layers before each
    for (const std::uint32_t c : cell) ++before[c / layer + 1];
    std::partial_sum(before.begin(), before.end(), before.begin());
    for (std::size_t s = 1; s < count_; ++s) {
      const std::size_t lowest = bounds_[s - 1] + least_thickness_;
      const std::size_t highest = bounds_.back() - (count_ - s) * least_thickness_;
      const std::size_t target = s * cell.size() / count_;
      std::size_t z = lowest;
      while (z < highest && before[z + 1] <= target) ++z;
      if (z < highest && target > before[z] && before[z + 1] - target < target - before[z]) ++z;
      bounds_[s] = z;
      first_[s] = before[z];
    }
    first_.back() = cell.size();
  }

  static std::uint32_t cell_of(const Vec<D>& x, const Grid<D>& grid) {
    std::uint32_t cell = 0;
    for (int d = D - 1; d >= 0; --d) {
      const double xi = (x[d] - grid.lower()[d]) / grid.h();
      const double inside = xi > 0 ? std::min(std::floor(xi), grid.cells()[d] - 1.0) : 0.0;  // 0 for NaN, too
      cell = cell * static_cast<std::uint32_t>(grid.cells()[d]) + static_cast<std::uint32_t>(inside);
    }
    return cell;
  }

  std::size_t least_thickness_, count_;
  std::vector<std::size_t> bounds_;  ///< layer of cells where each slab begins, and the end
  std::vector<std::size_t> first_;   ///< first particle of each slab, and the end
};

}  // namespace mpmvv::solver
