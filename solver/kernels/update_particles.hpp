#pragma once
#include <utility>

#include "solver/grid.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/particle_pack.hpp"
#include "solver/stencils/stencil.hpp"
#include "solver/velocity_update/velocity_fields.hpp"

/// Node kernels (stencils/kernel.hpp) that update particles from the grid.
namespace mpmvv::solver {

/// V' and (X' - X)/Δt of a particle, N §2.3, task 4. The constructor takes its V, and S v as `v`.
template <int D>
struct Advance {
  Vec<D> velocity, rate;

  [[gnu::always_inline]] Advance(const VelocityFields<D>& fields, double dt, const Grid<D>& grid, const Vec<D>& V,
                                 const Padded<D>& v, const auto& nodes)
      : velocity(v.template head<D>()) {
    if (fields.acceleration) velocity = V + (dt * nodes.gather(*fields.acceleration)).template head<D>();
    if (fields.velocity) velocity = nodes.gather(*fields.velocity).template head<D>();
    rate = fields.before * V + fields.after * velocity;
    if (fields.drift == &grid.v)
      rate += v.template head<D>();
    else if (fields.drift)
      rate += nodes.gather(*fields.drift).template head<D>();
  }
};
/// Whether the fields are those of `flip` with positions of first order. Most cases have these, and a step of the bar
/// took 1.2 times as long when it was asked for every particle which fields there are.
template <int D>
bool are_flip(const VelocityFields<D>& fields, const Grid<D>& grid) {
  return fields.acceleration && !fields.velocity && fields.drift == &grid.v && fields.before == 0 && fields.after == 0;
}

/// Updates velocity and position, N §2.3, task 4; `v` is S v.
template <bool is_flip, int D>
[[gnu::always_inline]] inline void update_velocity_and_position(Particles<D>& particles, const Grid<D>& grid,
                                                                const VelocityFields<D>& fields, double dt,
                                                                const auto& p, const auto& v, const auto& nodes) {
  if constexpr (is_flip) {
    add((dt * nodes.gather(*fields.acceleration)).template head<D>(), particles.v, p);
    add((dt * v).template head<D>(), particles.x, p);
  } else {
    const Advance<D> advance(fields, dt, grid, particles.v[p], v, nodes);
    particles.x[p] += dt * advance.rate;
    particles.v[p] = advance.velocity;
  }
}

/// Prefetches F_p, which is updated once all particles of the block have their L. The loop that updates it hardly
/// computes: without the prefetch it waits for memory, and large cubes took 1.07 times as long, large squares 1.05.
template <int D>
[[gnu::always_inline]] inline void prefetch_deformation(const Particles<D>& particles, std::size_t p) {
  prefetch(particles.F[p]);
}
template <int D>
[[gnu::always_inline]] inline void prefetch_deformation(const Particles<D>&, const ParticlePack&) {}

/// L_p = Σ_i v_i ⊗ ∇N_ip, for the update of F_p                S (7), W (10)
template <int D>
struct EvaluateVelocityGradient {
  static constexpr bool uses_gradients = true;
  const Particles<D>& particles;
  const Grid<D>& grid;

  [[gnu::always_inline]] void operator()(std::size_t p, const auto& nodes, auto& block) const {
    prefetch_deformation(particles, p);
    write(nodes.gather_with_gradient(grid.v).gradient, block.L, p - block.begin);
  }
};

/// Updates velocity and position, N §2.3, task 4, and evaluates L_p for task 5: S (7), (9), (10).
template <int D, bool is_flip>
struct UpdateParticle {
  static constexpr bool takes_packs = is_flip;
  static constexpr bool uses_gradients = true;
  Particles<D>& particles;
  const Grid<D>& grid;
  VelocityFields<D> fields;
  double dt;

  [[gnu::always_inline]] void operator()(const auto& p, const auto& nodes, auto& block) const {
    prefetch_deformation(particles, p);
    auto v = nodes.gather_with_gradient(grid.v);
    update_velocity_and_position<is_flip>(particles, grid, fields, dt, p, v.value, nodes);
    write(std::move(v.gradient), block.L, p - block.begin);
  }
};

/// Updates velocity and position where F has been updated before: N §2.3, task 4, W (17), (18).
template <int D, bool is_flip>
struct UpdateVelocityAndPosition {
  Particles<D>& particles;
  const Grid<D>& grid;
  VelocityFields<D> fields;
  double dt;

  [[gnu::always_inline]] void operator()(std::size_t p, const auto& nodes, const auto&) const {
    update_velocity_and_position<is_flip>(particles, grid, fields, dt, p, nodes.gather(grid.v), nodes);
  }
};

/// Updates the velocity, and sets the rate at which a later sweep of the step moves the particle.
template <int D>
struct UpdateVelocityAndRate {
  Particles<D>& particles;
  const Grid<D>& grid;
  VelocityFields<D> fields;
  double dt;

  [[gnu::always_inline]] void operator()(std::size_t p, const auto& nodes, const auto&) const {
    const Advance<D> advance(fields, dt, grid, particles.v[p], nodes.gather(grid.v), nodes);
    particles.rate[p] = advance.rate;
    particles.v[p] = advance.velocity;
  }
};

/// v_p += Σ_i N_ip a_i Δt                                      W (18)
template <int D>
struct UpdateVelocity {
  Particles<D>& particles;
  const Grid<D>& grid;
  double dt;

  [[gnu::always_inline]] void operator()(std::size_t p, const auto& nodes, const auto&) const {
    particles.v[p] += (dt * nodes.gather(grid.a)).template head<D>();
  }
};

/// x_p += Σ_i N_ip v_i Δt, and L_p by the same velocity        W (17), (10)
template <int D>
struct UpdatePosition {
  static constexpr bool uses_gradients = true;
  Particles<D>& particles;
  const Grid<D>& grid;
  double dt;

  [[gnu::always_inline]] void operator()(std::size_t p, const auto& nodes, auto& block) const {
    prefetch_deformation(particles, p);
    auto v = nodes.gather_with_gradient(grid.v);
    particles.x[p] += (dt * v.value).template head<D>();
    write(std::move(v.gradient), block.L, p - block.begin);
  }
};

}  // namespace mpmvv::solver
