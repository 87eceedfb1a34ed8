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
/// reach W nodes along an axis a node couples to those up to W - 1 away, at (2W - 1)^D displacements. As M is symmetric
/// a node's row has those along its own line of the first axis and those to lines that come later in storage; from the
/// rows, all displacements of eight nodes are then put side by side for products. Takes 8 bytes for each displacement
/// and node of the grid, and half as many for the rows: 620 bytes a node for cubic splines in the plane.
template <int D>
class MassMatrix {
 public:
  using Field = Array<Padded<D>>;

  explicit MassMatrix(const Step<D>& s);

  /// Of the particles where they are. False where a particle's domain reaches more than W nodes along an axis.
  bool assemble(Step<D>& s);

  /// φ_i += Σ_j M_ij u_j on the nodes with mass.
  void add(Step<D>& s, const Field& u, Field& field);

  /// Adds the couplings by a block's particles, of these masses.
  template <class Shape>
  void add_block(const Shape& block, const Grid<D>& grid, const Array<double>& m);

 private:
  static constexpr std::size_t at_once = 8;  ///< nodes in a product

  template <int W>
  void add_particle(const double* N, double m, std::size_t first, const Grid<D>& grid);
  void complete(std::size_t n);
  void add_span(std::size_t first, std::size_t end, Field& field) const;

  std::vector<std::ptrdiff_t> offsets_;  ///< along storage, of all displacements
  std::size_t earlier_;                  ///< how many of them lead to earlier lines: none for D = 1
  std::size_t row_size_;                 ///< one more than couplings: what is added to a line may reach past the last
  std::size_t margin_;                   ///< nodes before and after those of the grid
  Array<double> rows_;                   ///< with the margin
  Array<double> couplings_;              ///< of eight nodes for each displacement, and so on
  std::array<Array<double>, D> u_;       ///< by component, with the margin, zero where there is no mass
  std::atomic<bool> fits_{true};
};

extern template class MassMatrix<1>;
extern template class MassMatrix<2>;

}  // namespace mpmvv::solver
