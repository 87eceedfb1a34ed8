#pragma once
#include "solver/operations.hpp"
#include "solver/velocity_update/velocity_fields.hpp"

namespace mpmvv::solver {

/// V' and (X' - X)/Δt on a particle or a company, N table 1, task 4.
template <class Vector>
struct Advance {
  Vector velocity, rate;

  template <int D>
  [[gnu::always_inline]] Advance(const VelocityFields<D>& fields, const Vector& V, const auto& v, const auto& nodes)
      : velocity(v.template head<D>()) {
    if (fields.added) velocity = V + nodes.gather(*fields.added).template head<D>();
    if (fields.taken) velocity = nodes.gather(*fields.taken).template head<D>();
    rate = fields.before * V + fields.after * velocity;
    if (fields.drift) rate += nodes.gather(*fields.drift).template head<D>();
  }
};
template <int D, class Vector>
Advance(const VelocityFields<D>&, const Vector&, const auto&, const auto&) -> Advance<Vector>;

/// C_p, where particles have one.
template <int D>
void keep_affine(Particles<D>& particles, const auto& block, const Grid<D>& grid) {
  if constexpr (requires { gather_affine(particles, block, grid); })
    if (!particles.C.empty()) gather_affine(particles, block, grid);
}

/// Tasks 4 and 5 of N table 1.
template <int D>
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
    const Advance advance(fields, who.of(particles.v), v.value, nodes);
    who.add(particles.x, (dt * advance.rate).eval());
    who.set(particles.v, advance.velocity);
    who.set(particles.F, deform(who.of(particles.F), v.gradient));
  }
};

/// Task 4 alone, where F has gone before.
template <int D>
struct UpdateVelocityAndPosition {
  Particles<D>& particles;
  const Grid<D>& grid;
  VelocityFields<D> fields;
  double dt;

  void prepare(const auto& block, const Grid<D>&) const { keep_affine(particles, block, grid); }
  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    const Advance advance(fields, who.of(particles.v), nodes.gather(grid.v), nodes);
    who.add(particles.x, (dt * advance.rate).eval());
    who.set(particles.v, advance.velocity);
  }
};

/// Task 4 but for the positions, whose rates are kept until the step's last sweep.
template <int D>
struct UpdateVelocityAndRate {
  Particles<D>& particles;
  const Grid<D>& grid;
  VelocityFields<D> fields;

  void prepare(const auto& block, const Grid<D>&) const { keep_affine(particles, block, grid); }
  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    const Advance advance(fields, who.of(particles.v), nodes.gather(grid.v), nodes);
    who.set(particles.rate, advance.rate);
    who.set(particles.v, advance.velocity);
  }
};

/// X' = X + Δt `rate`
template <int D>
struct MoveByRate {
  Particles<D>& particles;
  double dt;

  [[gnu::always_inline]] void operator()(const auto& who, const auto&, const auto&) const {
    who.add(particles.x, (dt * who.of(particles.rate)).eval());
  }
};

}  // namespace mpmvv::solver
