#pragma once
#include "solver/grid.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/particle_pack.hpp"
#include "solver/stencils/stencil.hpp"

/// Node kernels (stencils/kernel.hpp) that map from particles to the grid. Each returns what one particle gives.
/// `visit` (stencils/node_loop.hpp) hands that to `scatter` (stencils/stencil.hpp), which multiplies it by the weights
/// and adds it to the nodes.
namespace mpmvv::solver {

/// p_i = Σ_p N_ip m_p v_p with m_i = Σ_p N_ip m_p             S (1), (2), W (8), (9)
template <int D>
struct MapMomentum {
  static constexpr bool takes_packs = true;
  const Particles<D>& particles;
  Grid<D>& grid;

  auto& field() const { return grid.p; }
  [[gnu::always_inline]] auto operator()(const auto& p, const auto&, const auto&) const {
    const auto m = read(particles.m, p);
    return padded<D>(m * read(particles.v, p), m);
  }
};

/// f_i = Σ_p (N_ip m_p b_p - V_p σ_p ∇N_ip) = Σ_p (N_ip m_p b_p - V⁰_p τ_p ∇N_ip)     S (4), (16), W (14)
template <int D>
struct MapForces {
  static constexpr bool takes_packs = true;
  static constexpr bool uses_gradients = true;
  const Particles<D>& particles;
  Grid<D>& grid;

  auto& field() const { return grid.f; }
  [[gnu::always_inline]] auto operator()(const auto& p, const auto&, const auto& block) const {
    const auto k = p - block.begin;
    return ValueAndGradient{padded<D>(read(particles.m, p) * read(block.b, k)),
                            -read(particles.V0, p) * read(block.tau, k)};
  }
};

}  // namespace mpmvv::solver
