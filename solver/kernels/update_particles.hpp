#pragma once
#include "solver/deformation.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/pack_stencil.hpp"
#include "solver/velocity_update/affine.hpp"
#include "solver/velocity_update/velocity_fields.hpp"

/// Node kernels (stencils/kernel.hpp) that update particles from the grid.
namespace mpmvv::solver {

/// V' and (X' - X)/Δt of a particle or a pack, N table 1, task 4; `v` is S v. Where the fields are known to be those of
/// `flip`, that is V' = V + Δt S a and S v, without a look at which there are: most cases are, and in the bar the whole
/// step took 1.25 times as long with it.
template <class Vector, bool is_flip>
struct Advance {
  Vector velocity, rate;

  template <int D>
  [[gnu::always_inline]] Advance(const VelocityFields<D>& fields, double dt, const Grid<D>& grid, const Vector& V,
                                 const auto& v, const auto& nodes)
      : velocity(v.template head<D>()), rate(velocity) {
    if (is_flip || fields.acceleration) velocity = V + (dt * nodes.gather(*fields.acceleration)).template head<D>();
    if constexpr (is_flip) return;
    if (fields.velocity) velocity = nodes.gather(*fields.velocity).template head<D>();
    rate = fields.before * V + fields.after * velocity;
    if (fields.drift == &grid.v)
      rate += v.template head<D>();
    else if (fields.drift)
      rate += nodes.gather(*fields.drift).template head<D>();
  }
};

/// Whether the fields are those of `flip` with positions of first order.
template <int D>
bool are_flip(const VelocityFields<D>& fields, const Grid<D>& grid) {
  return fields.acceleration && !fields.velocity && fields.drift == &grid.v && fields.before == 0 && fields.after == 0;
}

template <bool is_flip, int D, class Vector>
[[gnu::always_inline]] inline auto advance(const VelocityFields<D>& fields, double dt, const Grid<D>& grid,
                                           const Vector& V, const auto& v, const auto& nodes) {
  return Advance<Vector, is_flip>(fields, dt, grid, V, v, nodes);
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
    const auto to = advance<is_flip>(fields, dt, grid, who.of(particles.v), v.value, nodes);
    who.add(particles.x, (dt * to.rate).eval());
    who.set(particles.v, to.velocity);
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
    const auto to = advance<is_flip>(fields, dt, grid, who.of(particles.v), nodes.gather(grid.v), nodes);
    who.add(particles.x, (dt * to.rate).eval());
    who.set(particles.v, to.velocity);
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
    const auto to = advance<false>(fields, dt, grid, who.of(particles.v), nodes.gather(grid.v), nodes);
    who.set(particles.rate, to.rate);
    who.set(particles.v, to.velocity);
  }
};

}  // namespace mpmvv::solver
