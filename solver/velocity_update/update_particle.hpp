#pragma once
#include "solver/operations.hpp"
#include "solver/velocity_update/velocity_fields.hpp"

namespace mpmvv::solver {

/// V' and (X' - X)/Δt on a particle, N table 1, task 4.
template <int D>
struct Advance {
  Vec<D> velocity, rate;

  Advance(const VelocityFields<D>& fields, const Vec<D>& V, const Vec<D>& v, const auto& nodes) : velocity(v) {
    if (fields.added) velocity = V + nodes.gather(*fields.added).template head<D>();
    if (fields.taken) velocity = nodes.gather(*fields.taken).template head<D>();
    rate = fields.before * V + fields.after * velocity;
    if (fields.drift) rate += nodes.gather(*fields.drift).template head<D>();
  }
};

/// C_p, where particles have one.
template <int D>
void keep_affine(Particles<D>& particles, std::size_t p, const auto& block, int k, const Grid<D>& grid) {
  if constexpr (requires { gather_affine(particles, p, block, k, grid); })
    if (!particles.C.empty()) gather_affine(particles, p, block, k, grid);
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

  void operator()(std::size_t p, const auto& nodes, const auto& block, int k) const {
    const auto v = nodes.gather_with_gradient(grid.v);
    const Advance<D> advance(fields, particles.v[p], v.value.template head<D>(), nodes);
    keep_affine(particles, p, block, k, grid);
    particles.x[p] += dt * advance.rate;
    particles.v[p] = advance.velocity;
    deform(particles.F[p], v.gradient);
  }
};

/// Task 4 alone, where F has gone before.
template <int D>
struct UpdateVelocityAndPosition {
  Particles<D>& particles;
  const Grid<D>& grid;
  VelocityFields<D> fields;
  double dt;

  void operator()(std::size_t p, const auto& nodes, const auto& block, int k) const {
    const Advance<D> advance(fields, particles.v[p], nodes.gather(grid.v).template head<D>(), nodes);
    keep_affine(particles, p, block, k, grid);
    particles.x[p] += dt * advance.rate;
    particles.v[p] = advance.velocity;
  }
};

/// Task 4 but for the positions, whose rates are kept until the step's last sweep.
template <int D>
struct UpdateVelocityAndRate {
  Particles<D>& particles;
  const Grid<D>& grid;
  VelocityFields<D> fields;

  void operator()(std::size_t p, const auto& nodes, const auto& block, int k) const {
    const Advance<D> advance(fields, particles.v[p], nodes.gather(grid.v).template head<D>(), nodes);
    keep_affine(particles, p, block, k, grid);
    particles.rate[p] = advance.rate;
    particles.v[p] = advance.velocity;
  }
};

/// X' = X + Δt `rate`
template <int D>
struct MoveByRate {
  Particles<D>& particles;
  double dt;

  void operator()(std::size_t p, const auto&, const auto&, int) const { particles.x[p] += dt * particles.rate[p]; }
};

}  // namespace mpmvv::solver
