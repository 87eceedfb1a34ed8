#pragma once
#include <vector>

#include "solver/particles.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

/// φ_i += Σ_p N_ip m_p Σ_j N_jp u_j, a node kernel: to the particles, and their momenta back to the nodes.
template <int D>
struct AddMassProduct {
  const Particles<D>& particles;
  const std::vector<Padded<D>>& u;
  std::vector<Padded<D>>& product;

  auto& field() const { return product; }
  [[gnu::always_inline]] auto operator()(const auto& who, const auto& nodes, const auto&) const {
    return (who.of(particles.m) * nodes.gather(u)).eval();
  }
};

/// The same of a number on each node, to where boundaries expect a mass.
template <int D>
struct AddScalarMassProduct {
  const Particles<D>& particles;
  const std::vector<double>& c;
  std::vector<Padded<D + 1>>& product;

  auto& field() const { return product; }
  [[gnu::always_inline]] auto operator()(const auto& who, const auto& nodes, const auto&) const {
    return padded_alone<D>(who.of(particles.m) * nodes.gather(c));
  }
};

}  // namespace mpmvv::solver
