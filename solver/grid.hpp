#pragma once
#include <climits>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "solver/array.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

/// The background grid: a Cartesian lattice of cells of width h over the domain, and along each axis a line of degrees
/// of freedom ("nodes"). Of these, `inside` belong to the domain, and `ghost` more lie beyond each face. Node-centred
/// bases have cells + 1 inside; an open-knot spline of degree q has cells + q and no ghosts.
template <int D>
class Grid {
 public:
  /// Throws std::length_error if there are more nodes than an int counts.
  Grid(const Vec<D>& lower, double h, const Index<D>& cells, int extra_inside, int ghost)
      : lower_(lower), h_(h), cells_(cells), ghost_(ghost) {
    std::size_t count = 1;
    for (int d = 0; d < D; ++d) {
      const std::size_t along = static_cast<std::size_t>(cells[d]) + static_cast<std::size_t>(extra_inside + 2 * ghost);
      if (along > INT_MAX / count) throw std::length_error("more nodes than indices can count (fewer cells)");
      inside_[d] = cells[d] + extra_inside;
      stride_[d] = static_cast<int>(count);
      count *= along;
    }
    p.resize(count, Padded<D + 1>::Zero());
    f.resize(count, Padded<D>::Zero());
    v.resize(count, Padded<D>::Zero());
    a.resize(count, Padded<D>::Zero());
  }

  const Vec<D>& lower() const { return lower_; }
  double h() const { return h_; }
  const Index<D>& cells() const { return cells_; }
  int ghost() const { return ghost_; }
  int inside(int axis) const { return inside_[axis]; }
  int stride(int axis) const { return stride_[axis]; }
  int nodes(int axis) const { return inside_[axis] + 2 * ghost_; }
  std::size_t size() const { return p.size(); }

  /// Returns the storage index of the node with indices `i`, which on ghosts are negative or from inside(axis) on.
  int node(const Index<D>& i) const {
    int n = 0;
    for (int d = 0; d < D; ++d) n += (i[d] + ghost_) * stride_[d];
    return n;
  }

  /// Returns the indices of the node at a storage index: the inverse of `node`.
  Index<D> index(std::size_t n) const {
    Index<D> i;
    for (int d = 0; d < D; ++d) i[d] = static_cast<int>(n) / stride_[d] % nodes(d) - ghost_;
    return i;
  }

  /// Calls visit(n, m) for every node n whose index along `axis` is i. The node m has the index `partner` along `axis`,
  /// and the other indices of n.
  template <class Visit>
  void for_plane(int axis, int i, int partner, const Visit& visit) const {
    const int step = stride_[axis];
    const std::int64_t total = static_cast<std::int64_t>(size()), planes = nodes(axis);
    const int offset = (partner - i) * step;
    for (std::int64_t outer = (i + ghost_) * step; outer < total; outer += planes * step)
      for (int n = static_cast<int>(outer), end = n + step; n < end; ++n) visit(n, n + offset);
  }

  /// Calls visit(n) for every node n whose index along `axis` is i.
  template <class Visit>
  void for_plane(int axis, int i, const Visit& visit) const {
    for_plane(axis, i, i, [&visit](int n, int) { visit(n); });
  }

  double m(std::size_t n) const { return p[n][D]; }  ///< mass

  Array<Padded<D + 1>> p;  ///< momentum, kg m/s, and in component D the mass, kg: they are mapped together
  Array<Padded<D>> f;      ///< force, N
  Array<Padded<D>> v;      ///< velocity, m/s
  Array<Padded<D>> a;      ///< acceleration, m/s²

 private:
  Vec<D> lower_;
  double h_;
  Index<D> cells_;
  Index<D> inside_{};
  Index<D> stride_{};
  int ghost_;
};

}  // namespace mpmvv::solver
