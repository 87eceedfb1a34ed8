#pragma once
#include "studies/checks/mapping/nodal_basis.hpp"

namespace mpmvv::checks::mapping {

/// A lattice of points in all cells of a grid but the outermost, `per_cell` to a cell along each axis. Nodes are among
/// them.
template <int D>
class SampleLattice {
 public:
  static constexpr int per_cell = D == 1 ? 24 : 4;

  explicit SampleLattice(const OverlayGrid<D>& grid) {
    std::size_t count = 1;
    for (int d = 0; d < D; ++d) {
      side_[d] = (grid.cells[d] - 2) * per_cell + 1;
      count *= static_cast<std::size_t>(side_[d]);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto i = index(k);
      solver::Vec<D> at;
      for (int d = 0; d < D; ++d) at[d] = grid.lower[d] + grid.h[d] * (1 + static_cast<double>(i[d]) / per_cell);
      points_.push_back(at);
    }
  }

  const Points<D>& points() const { return points_; }
  bool holds(const solver::Index<D>& i) const {
    bool inside = true;
    for (int d = 0; d < D; ++d) inside = inside && i[d] >= 0 && i[d] < side_[d];
    return inside;
  }

  Eigen::Index number(const solver::Index<D>& i) const { return D == 1 ? i[0] : i[0] + i[D - 1] * side_[0]; }
  solver::Index<D> index(std::size_t number) const {
    solver::Index<D> i;
    i[D - 1] = static_cast<int>(number) / (D == 1 ? 1 : side_[0]);
    if (D > 1) i[0] = static_cast<int>(number) % side_[0];
    return i;
  }

  /// Returns the element that holds a point in its interior; -1 for points on the sides of elements.
  int element(std::size_t number) const {
    const auto i = index(number);
    int element = 0;
    for (int d = D - 1; d >= 0; --d) {
      if (i[d] % per_cell == 0) return -1;
      element = element * (side_[d] / per_cell) + i[d] / per_cell;
    }
    return element;
  }
  int elements() const {
    int count = 1;
    for (const int points : side_) count *= points / per_cell;
    return count;
  }

 private:
  solver::Index<D> side_{};  ///< number of points along each axis
  Points<D> points_;
};

}  // namespace mpmvv::checks::mapping
