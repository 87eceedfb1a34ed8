#pragma once
#include <cstdint>
#include <optional>

#include "solver/array.hpp"
#include "solver/mass_matrix.hpp"

namespace mpmvv::solver {

template <int D>
class Step;

/// Multiplies fields of nodes by the consistent mass matrix SᵀMS of N §2.1, many times for the same particle positions.
/// The matrix is assembled where that saves time. Otherwise each product is a sweep over the particles, which gathers
/// the field on them and maps it back.
template <int D>
class MassProduct {
 public:
  using Field = Array<Padded<D>>;

  /// `products` is how many one expansion or solve makes at most. It decides whether the matrix is assembled. That a
  /// step may expand or solve more than once with particles where they are is not counted.
  MassProduct(const Step<D>& s, int products);

  /// The matrix, to which a sweep that maps particles may add their couplings, so that `prepare` need not make a sweep
  /// for them; null where there is none.
  MassMatrix<D>* matrix();

  /// Assembles the matrix, if there is one. To be called before the first call of `add` after particles have moved.
  void prepare(Step<D>& s);

  /// Adds the product to `field`: φ_i += Σ_p N_ip m_p Σ_j N_jp u_j
  void add(Step<D>& s, const Field& u, Field& field);

  bool is_assembled() const { return is_assembled_; }

 private:
  /// Whether a matrix may be assembled: not in space, where rows are long and the nodes that they couple lie far apart
  /// in memory. There 73 products, as many as the solution with the consistent mass takes at most, took 1.0 to 1.9
  /// times as long as by sweeps.
  static constexpr bool may_assemble = D < 3;

  std::optional<MassMatrix<D>> matrix_;
  bool is_assembled_ = false;
  std::int64_t assembled_after_ = -1;  ///< `Step::moves` when the matrix was assembled
};

extern template class MassProduct<1>;
extern template class MassProduct<2>;
extern template class MassProduct<3>;

}  // namespace mpmvv::solver
