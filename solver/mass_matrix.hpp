#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <vector>

#include "solver/array.hpp"
#include "solver/grid.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

template <int D>
class Step;

/// The consistent mass matrix M_ij = Σ_p m_p N_ip N_jp, SᵀMS of N §2.1, assembled, for D = 1 and 2. Where particles
/// reach W nodes along an axis, a node couples to those up to W - 1 away, at (2W - 1)^D displacements. As M is
/// symmetric, the row of a node holds only couplings along its own line of the first axis and to lines that come later
/// in storage. From the rows, the couplings of eight nodes at all displacements are then put side by side for products.
/// The matrix takes 8 bytes for each displacement and node of the grid, and the rows somewhat more than half as much:
/// 620 bytes a node for cubic splines in the plane.
template <int D>
class MassMatrix {
 public:
  using Field = Array<Padded<D>>;

  explicit MassMatrix(const Step<D>& s);

  /// Forgets the couplings added since the last `assemble`. To be called before a sweep adds those of the particles at
  /// other positions.
  void clear();

  /// Assembles the matrix of the particles at their current positions, from the couplings that a sweep has added since
  /// the last call, or else by a sweep. Returns false, with an incomplete matrix, where the domain of a particle
  /// reaches more than W nodes along an axis.
  bool assemble(Step<D>& s);

  /// Adds M u to `field`: φ_i += Σ_j M_ij u_j on the nodes with mass.
  void add(Step<D>& s, const Field& u, Field& field);

  /// Adds the couplings by a block's particles to the rows; m holds the masses of all particles.
  template <class Shape>
  void add_block(const Shape& block, const Grid<D>& grid, const Array<double>& m);

 private:
  static constexpr std::size_t at_once = 8;  ///< nodes that a product takes together

  template <int W>
  void add_particle(const double* N, double m, std::size_t first, const Grid<D>& grid);
  void complete(std::size_t n);
  double* row_of(std::size_t n) { return &rows_[(margin_ + n) * row_size_]; }
  void add_span(std::size_t first, std::size_t end, Field& field) const;

  std::vector<std::ptrdiff_t> offsets_;     ///< distances in storage, for all displacements
  std::size_t earlier_;                     ///< how many of `offsets_` lead to earlier lines: none for D = 1
  std::size_t row_size_;                    ///< couplings in a row, and one more: lines added may reach past the last
  std::size_t margin_;                      ///< nodes before and after those of the grid, where offsets may lead
  Array<double> rows_;                      ///< `row_size_` numbers for each node, margin included; zero between uses
  Array<double> couplings_;                 ///< by groups of eight nodes, in these by displacement, then by node
  std::array<Array<double>, D> u_;          ///< u by component, margin included, zero on nodes without mass
  std::atomic<bool> has_couplings_{false};  ///< whether some have been added to the rows
  std::atomic<bool> fits_{true};
};

extern template class MassMatrix<1>;
extern template class MassMatrix<2>;

}  // namespace mpmvv::solver
