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

/// The domain cut into slabs across its last axis, at least `thickness` cells each and twice the distance `reach` from
/// a particle to where its basis is evaluated, and the particles sorted so that each slab's are contiguous. A particle
/// may stray one cell out of its slab before it must be sorted again; even so two slabs with one between them share no
/// node (a basis reaches two cells from where it is evaluated). Depends on the grid and the basis alone.
template <int D>
class Slabs {
 public:
  static constexpr int thickness = 8;
  static constexpr int most = 32;

  explicit Slabs(const Grid<D>& grid, int reach) {
    const int cells = grid.cells()[D - 1];
    const int count = std::clamp(cells / (thickness + 2 * reach), 1, most);
    for (int s = 0; s <= count; ++s) bounds_.push_back(static_cast<int>(std::int64_t{s} * cells / count));
    first_.assign(bounds_.size(), 0);
  }

  int count() const { return static_cast<int>(bounds_.size()) - 1; }

  std::pair<std::size_t, std::size_t> particles(int slab) const {
    return {first_[static_cast<std::size_t>(slab)], first_[static_cast<std::size_t>(slab) + 1]};
  }

  /// Between which positions along the last axis a particle of this slab is near enough to it. The outermost slabs
  /// have no outer bound.
  std::pair<double, double> reach(int slab, const Grid<D>& grid) const {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    const auto position = [&grid](int cell) { return grid.lower()[D - 1] + grid.h() * cell; };
    return {slab == 0 ? -unbounded : position(bounds_[static_cast<std::size_t>(slab)] - 1),
            slab + 1 == count() ? unbounded : position(bounds_[static_cast<std::size_t>(slab) + 1] + 1)};
  }

  /// The slab with the cell at this distance; strays and NaN fall to the outermost ones.
  int of(double xi) const {
    const auto above = std::upper_bound(bounds_.begin() + 1, bounds_.end() - 1, xi);
    return static_cast<int>(above - bounds_.begin()) - 1;
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
    std::size_t p = 0;
    for (int s = 0; s < count(); ++s) {
      first_[static_cast<std::size_t>(s)] = p;
      while (p < n && of((particles.x[p][D - 1] - grid.lower()[D - 1]) / grid.h()) == s) ++p;
    }
    first_.back() = n;
  }

 private:
  static std::size_t cells_of(const Grid<D>& grid) {
    std::size_t cells = 1;
    for (const int along_axis : grid.cells()) cells *= static_cast<std::size_t>(along_axis);
    return cells;
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

  std::vector<int> bounds_;         ///< cell where each slab begins, and the end
  std::vector<std::size_t> first_;  ///< first particle of each slab, and the end
};

}  // namespace mpmvv::solver
