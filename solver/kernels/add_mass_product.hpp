#pragma once
#include "solver/array.hpp"
#include "solver/particles.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

/// A node kernel: φ_i += Σ_p N_ip m_p Σ_j N_jp u_j. Gathers u on each particle, and its momentum m_p u_p is mapped back
/// to the nodes.
template <int D, class V = Padded<D>>
struct AddMassProduct {
  const Particles<D>& particles;
  const Array<V>& u;
  Array<V>& product;

  auto& field() const { return product; }
  [[gnu::always_inline]] V operator()(std::size_t p, const auto& nodes, const auto&) const {
    return particles.m[p] * nodes.gather(u);
  }
};

}  // namespace mpmvv::solver
