#pragma once
#include <Eigen/SparseCore>
#include <cmath>
#include <stdexcept>
#include <variant>
#include <vector>

#include "solver/basis/bspline.hpp"
#include "solver/basis/gimp.hpp"
#include "solver/basis/linear.hpp"
#include "solver/types.hpp"

namespace mpmvv::checks::mapping {

template <int D>
using Points = std::vector<solver::Vec<D>>;

/// The grid laid over the particles: nodes 0, ..., cells along each axis, a cell width h for each axis.
template <int D>
struct OverlayGrid {
  solver::Vec<D> lower, h;
  solver::Index<D> cells;

  int nodes() const {
    int count = 1;
    for (const int n : cells) count *= n + 1;
    return count;
  }
};

using GridBasis = std::variant<solver::Linear, solver::BSpline2, solver::Gimp>;

/// The solver's basis functions of all nodes of a grid, at points whose stencils lie inside it.
template <int D>
class NodalBasis {
 public:
  /// nodes x points
  using Matrix = Eigen::SparseMatrix<double>;

  NodalBasis(const GridBasis& basis, const OverlayGrid<D>& grid) : basis_(basis), grid_(grid) {}

  /// Returns N_i at points, or v_ip of particles with widths, B (16.16). Throws std::out_of_range where a stencil does
  /// not lie inside the grid.
  Matrix weights(const Points<D>& x, const Points<D>& widths = {}) const { return evaluate(x, widths, -1); }

  /// Returns ∂N_i/∂x_axis at the same points or of the same particles.
  Matrix gradients(int axis, const Points<D>& x, const Points<D>& widths = {}) const {
    return evaluate(x, widths, axis);
  }

 private:
  static constexpr double least_weight = 1e-20;  ///< less is round-off, or what Linear puts on a node a cell away

  Matrix evaluate(const Points<D>& x, const Points<D>& widths, int derived_axis) const {
    std::vector<Eigen::Triplet<double>> entries;
    std::visit(
        [&]<class B>(const B& basis) {
          for (std::size_t p = 0; p < x.size(); ++p) {
            double N[D][B::support], dN[D][B::support];
            solver::Index<D> first;
            for (int d = 0; d < D; ++d) {
              const double width = widths.empty() ? 0 : widths[p][d] / grid_.h[d];
              first[d] = basis.evaluate({(x[p][d] - grid_.lower[d]) / grid_.h[d], grid_.cells[d], width}, N[d], dN[d]);
              if (first[d] < 0 || first[d] + B::support > grid_.cells[d] + 1)
                throw std::out_of_range("mapping: a point lies too close to the end of its grid");
              if (d == derived_axis)
                for (int k = 0; k < B::support; ++k) N[d][k] = dN[d][k] / grid_.h[d];
            }
            add_products<B::support>(entries, static_cast<int>(p), first, N);
          }
        },
        basis_);
    Matrix matrix(grid_.nodes(), static_cast<Eigen::Index>(x.size()));
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  /// Adds the tensor products of one point's K functions along each axis.
  template <int K>
  void add_products(std::vector<Eigen::Triplet<double>>& entries, int point, const solver::Index<D>& first,
                    const double (&N)[D][K]) const {
    for (int k = 0; k < (D == 1 ? K : K * K); ++k) {
      double product = 1;
      int node = 0, stride = 1, rest = k;
      for (int d = 0; d < D; ++d, rest /= K) {
        product *= N[d][rest % K];
        node += (first[d] + rest % K) * stride;
        stride *= grid_.cells[d] + 1;
      }
      if (!(std::abs(product) <= least_weight)) entries.emplace_back(node, point, product);
    }
  }

  GridBasis basis_;
  OverlayGrid<D> grid_;
};

}  // namespace mpmvv::checks::mapping
