#pragma once
#include <type_traits>

#include "solver/deformation.hpp"
#include "solver/sweep.hpp"
#include "solver/velocity_update/affine.hpp"

/// What a sweep does on particles and their nodes, one by one or in companies: see node_loop.hpp.
namespace mpmvv::solver {

/// gradient ∇N_ip, for one particle or four
template <int D>
[[gnu::always_inline]] inline auto mapped(const auto& gradient) {
  if constexpr (std::is_same_v<typename std::remove_cvref_t<decltype(gradient)>::Scalar, Four>)
    return FourGradients<D>{gradient};
  else
    return ValueAndGradient<D>{Packed<D>::Zero(), gradient};
}
/// N_ip value + gradient ∇N_ip
template <int D>
[[gnu::always_inline]] inline auto mapped(const auto& value, const auto& gradient) {
  if constexpr (std::is_same_v<typename std::remove_cvref_t<decltype(gradient)>::Scalar, Four>)
    return FourValuesAndGradients<D>{value, gradient};
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
    return packed_alone<D>(who.of(particles.m));
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
    return packed<D>(m * who.of(particles.v), m);
  }
};

/// f_i = -Σ_p V_p σ_p ∇N_ip = -Σ_p V⁰_p τ_p ∇N_ip              S (4), W (14)
template <int D>
struct MapInternalForce {
  static constexpr bool uses_gradients = true;
  const Particles<D>& particles;
  Grid<D>& grid;

  auto& field() const { return grid.f; }
  [[gnu::always_inline]] auto operator()(const auto& who, const auto&, const auto& block) const {
    return mapped<D>(-who.of(particles.V0) * who.of(block.tau));
  }
};

/// f_i = Σ_p (N_ip m_p b_p - V⁰_p τ_p ∇N_ip)                   S (4), (16)
template <int D>
struct MapForces {
  static constexpr bool uses_gradients = true;
  const Particles<D>& particles;
  Grid<D>& grid;

  auto& field() const { return grid.f; }
  [[gnu::always_inline]] auto operator()(const auto& who, const auto&, const auto& block) const {
    return mapped<D>(packed<D>(who.of(particles.m) * who.of(block.b)), -who.of(particles.V0) * who.of(block.tau));
  }
};

/// v_p += Σ_i N_ip a_i Δt                                      S (9), W (18)
template <int D>
struct UpdateVelocity {
  Particles<D>& particles;
  const Grid<D>& grid;
  double dt;

  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    who.add(particles.v, (dt * nodes.gather(grid.a)).eval());
  }
};

/// x_p += Σ_i N_ip v_i Δt                                      S (10), W (17)
template <int D>
struct UpdatePosition {
  Particles<D>& particles;
  const Grid<D>& grid;
  double dt;

  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    who.add(particles.x, (dt * nodes.gather(grid.v)).eval());
  }
};

/// F_p follows L_p = Σ_i v_i ⊗ ∇N_ip                           S (7), (8), W (10), (11)
template <int D>
struct UpdateDeformation {
  static constexpr bool uses_gradients = true;
  Particles<D>& particles;
  const Grid<D>& grid;
  DeformationStep<D> deform;

  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    who.set(particles.F, deform(who.of(particles.F), nodes.gather_with_gradient(grid.v).gradient));
  }
};

/// Position and deformation by the same grid velocity, gathered once.
template <int D>
struct UpdatePositionAndDeformation {
  static constexpr bool uses_gradients = true;
  Particles<D>& particles;
  const Grid<D>& grid;
  double dt;
  DeformationStep<D> deform;

  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    const auto v = nodes.gather_with_gradient(grid.v);
    who.add(particles.x, (dt * v.value).eval());
    who.set(particles.F, deform(who.of(particles.F), v.gradient));
  }
};

}  // namespace mpmvv::solver
