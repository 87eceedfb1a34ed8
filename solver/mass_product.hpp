#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "solver/stencils/cpdi_stencil_cache.hpp"

namespace mpmvv::solver {

template <int D>
class Step;

/// The consistent mass matrix SᵀMS of N §2.1 times fields of nodes: to the particles and back, many times by the same
/// positions. Where particles have domains their stencils are kept for that.
template <int D>
class MassProduct {
 public:
  using Field = std::vector<Padded<D>>;

  /// For at most so many by the same positions.
  MassProduct(const Step<D>& s, int most);

  /// To be called before some calls of `add` by the same positions.
  void prepare(Step<D>& s);

  /// φ_i += Σ_p N_ip m_p Σ_j N_jp u_j
  void add(Step<D>& s, const Field& u, Field& field) const;

  bool uses_cache() const { return cache_ && cache_->is_complete(); }

 private:
  std::optional<CpdiStencilCache<D>> cache_;
  std::int64_t kept_after_ = -1;  ///< as many moves
};

extern template class MassProduct<1>;
extern template class MassProduct<2>;
extern template class MassProduct<3>;

}  // namespace mpmvv::solver
