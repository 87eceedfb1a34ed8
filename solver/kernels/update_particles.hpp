#pragma once
#include "solver/deformation.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/pack_stencil.hpp"
#include "solver/velocity_update/affine.hpp"
#include "solver/velocity_update/velocity_fields.hpp"

/// Node kernels (stencils/kernel.hpp) that update particles from the grid.
namespace mpmvv::solver {

/// V' and (X' - X)/Δt of a particle or a pack, N table 1, task 4; `v` is S v.
template <class Vector>
struct Advance {
  Vector velocity, rate;

  template <int D>
  [[gnu::always_inline]] Advance(const VelocityFields<D>& fields, double dt, const Grid<D>& grid, const Vector& V,
                                 const auto& v, const auto& nodes)
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
template <int D, class Vector>
Advance(const VelocityFields<D>&, double, const Grid<D>&, const Vector&, const auto&, const auto&) -> Advance<Vector>;

/// Whether the fields are those of `flip` with positions of first order: most cases have these, and a step of the bar
/// took 1.2 times as long where every particle asked which there are.
template <int D>
bool are_flip(const VelocityFields<D>& fields, const Grid<D>& grid) {
  return fields.acceleration && !fields.velocity && fields.drift == &grid.v && fields.before == 0 && fields.after == 0;
}

/// Task 4 of N table 1; `v` is S v.
template <bool is_flip, int D>
[[gnu::always_inline]] inline void update_velocity_and_position(Particles<D>& particles, const Grid<D>& grid,
                                                                const VelocityFields<D>& fields, double dt,
                                                                const auto& who, const auto& v, const auto& nodes) {
  if constexpr (is_flip) {
    who.add(particles.v, (dt * nodes.gather(*fields.acceleration)).eval());
    who.add(particles.x, (dt * v).eval());
  } else {
    const Advance advance(fields, dt, grid, who.of(particles.v), v, nodes);
    who.add(particles.x, (dt * advance.rate).eval());
    who.set(particles.v, advance.velocity);
  }
}

/// C_p, where particles have one.
template <int D>
void keep_affine(Particles<D>& particles, const auto& block, const Grid<D>& grid) {
  if constexpr (requires { gather_affine(particles, block, grid); })
    if (!particles.C.empty()) gather_affine(particles, block, grid);
}

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

/// Velocity, position and F: tasks 4 and 5 of N table 1, S (7) to (10).
template <int D, bool is_flip>
struct UpdateParticle {
  static constexpr bool uses_gradients = true;
  Particles<D>& particles;
  const Grid<D>& grid;
  VelocityFields<D> fields;
  double dt;
  DeformationStep<D> deform;

  void prepare(const auto& block, const Grid<D>&) const { keep_affine(particles, block, grid); }
  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    const auto v = nodes.gather_with_gradient(grid.v);
    update_velocity_and_position<is_flip>(particles, grid, fields, dt, who, v.value, nodes);
    who.set(particles.F, deform(who.of(particles.F), v.gradient));
  }
};

/// Velocity and position, where F has gone before: task 4 of N table 1, W (17), (18).
template <int D, bool is_flip>
struct UpdateVelocityAndPosition {
  Particles<D>& particles;
  const Grid<D>& grid;
  VelocityFields<D> fields;
  double dt;

  void prepare(const auto& block, const Grid<D>&) const { keep_affine(particles, block, grid); }
  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    update_velocity_and_position<is_flip>(particles, grid, fields, dt, who, nodes.gather(grid.v), nodes);
  }
};

/// Velocity, and the rate at which the position will follow in a later sweep of the step.
template <int D>
struct UpdateVelocityAndRate {
  Particles<D>& particles;
  const Grid<D>& grid;
  VelocityFields<D> fields;
  double dt;

  void prepare(const auto& block, const Grid<D>&) const { keep_affine(particles, block, grid); }
  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    const Advance advance(fields, dt, grid, who.of(particles.v), nodes.gather(grid.v), nodes);
    who.set(particles.rate, advance.rate);
    who.set(particles.v, advance.velocity);
  }
};

/// v_p += Σ_i N_ip a_i Δt                                      W (18)
template <int D>
struct UpdateVelocity {
  Particles<D>& particles;
  const Grid<D>& grid;
  double dt;

  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    who.add(particles.v, (dt * nodes.gather(grid.a)).eval());
  }
};

/// x_p += Σ_i N_ip v_i Δt, and F_p by the same velocity        W (17), (10), (11)
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
