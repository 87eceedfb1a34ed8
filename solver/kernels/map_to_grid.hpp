#pragma once
#include <type_traits>

#include "solver/particles.hpp"
#include "solver/stencils/pack_stencil.hpp"
#include "solver/velocity_update/affine.hpp"

/// Node kernels (stencils/kernel.hpp) that map from particles to the grid.
namespace mpmvv::solver {

/// N_ip value + gradient ∇N_ip, for one particle or a pack
template <int D>
[[gnu::always_inline]] inline auto mapped(const auto& value, const auto& gradient) {
  if constexpr (std::is_same_v<typename std::remove_cvref_t<decltype(gradient)>::Scalar, Pack>)
    return PackValuesAndGradients<D>{value, gradient};
  else
    return ValueAndGradient<D>{value, gradient};
}

/// m_i = Σ_p N_ip m_p                                          S (1), W (8)
template <int D>
struct MapMass {
  const Particles<D>& particles;
  Grid<D>& grid;

  auto& field() const { return grid.p; }
  [[gnu::always_inline]] auto operator()(const auto& who, const auto&, const auto&) const {
    return padded_alone<D>(who.of(particles.m));
  }
};

/// p_i = Σ_p N_ip m_p v_p with m_i = Σ_p N_ip m_p             S (1), (2), W (8), (9); with `apic` of affine fields
template <int D>
struct MapMomentum {
  const Particles<D>& particles;
  Grid<D>& grid;

  auto& field() const { return grid.p; }
  void prepare(const auto& block, const Grid<D>&) const {
    if constexpr (requires { scatter_affine(particles, block, grid); })
      if (!particles.C.empty()) scatter_affine(particles, block, grid);
  }
  [[gnu::always_inline]] auto operator()(const auto& who, const auto&, const auto&) const {
    const auto m = who.of(particles.m);
    return padded<D>(m * who.of(particles.v), m);
  }
};

/// f_i = Σ_p (N_ip m_p b_p - V_p σ_p ∇N_ip) = Σ_p (N_ip m_p b_p - V⁰_p τ_p ∇N_ip)     S (4), (16), W (14)
template <int D>
struct MapForces {
  static constexpr bool uses_gradients = true;
  const Particles<D>& particles;
  Grid<D>& grid;

  auto& field() const { return grid.f; }
  [[gnu::always_inline]] auto operator()(const auto& who, const auto&, const auto& block) const {
    return mapped<D>(padded<D>(who.of(particles.m) * who.of(block.b)), -who.of(particles.V0) * who.of(block.tau));
  }
};

}  // namespace mpmvv::solver
