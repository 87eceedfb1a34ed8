#pragma once
#include <cstdint>
#include <optional>

#include "solver/array.hpp"
#include "solver/mass_matrix.hpp"

namespace mpmvv::solver {

template <int D>
class Step;

/// The consistent mass matrix SᵀMS of N §2.1 times fields of nodes, many times by the same positions: assembled where
/// that is worth it, and else by a sweep over the particles each, to them and back.
template <int D>
class MassProduct {
 public:
  using Field = Array<Padded<D>>;

  /// `most` is how many products there are at most while particles stay where they are: it decides whether assembling
  /// is worth it.
  MassProduct(const Step<D>& s, int most);

  /// To be called before the first call of `add` after particles have moved.
  void prepare(Step<D>& s);

  /// φ_i += Σ_p N_ip m_p Σ_j N_jp u_j
  void add(Step<D>& s, const Field& u, Field& field);

  bool is_assembled() const { return is_assembled_; }

 private:
  /// In space rows are long and what they couple lies far apart in memory: 73 products took 1.0 to 1.9 times the
  /// sweeps.
  static constexpr bool may_assemble = D < 3;

  std::optional<MassMatrix<D>> matrix_;
  bool is_assembled_ = false;
  std::int64_t assembled_after_ = -1;  ///< `Step::moves` when the matrix was assembled
};

extern template class MassProduct<1>;
extern template class MassProduct<2>;
extern template class MassProduct<3>;

}  // namespace mpmvv::solver
