#pragma once
#include <array>
#include <atomic>
#include <variant>

#include "solver/body_force.hpp"
#include "solver/deformation.hpp"
#include "solver/material/materials.hpp"
#include "solver/sweep.hpp"
#include "solver/velocity_update/affine.hpp"

/// What a sweep can do. Scatter operations map particles to nodes, gather operations nodes to particles, stages act on
/// a block of particles at once.
namespace mpmvv::solver {

/// m_i = Σ_p N_ip m_p                                          S (1), W (8)
template <int D>
struct MapMass {
  const Particles<D>& particles;
  Grid<D>& grid;

  void operator()(std::size_t p, const auto& nodes, const auto&, int) const {
    nodes.scatter(packed<D>(Vec<D>::Zero(), particles.m[p]), grid.p);
  }
};

/// p_i = Σ_p N_ip m_p v_p with m_i = Σ_p N_ip m_p             S (1), (2), W (8), (9); with `apic` of affine fields
template <int D>
struct MapMomentum {
  const Particles<D>& particles;
  Grid<D>& grid;

  void operator()(std::size_t p, const auto& nodes, const auto& block, int k) const {
    if constexpr (requires { scatter_affine(particles, p, block, k, grid); })
      if (!particles.C.empty()) return scatter_affine(particles, p, block, k, grid);
    nodes.scatter(packed<D>(particles.m[p] * particles.v[p], particles.m[p]), grid.p);
  }
};

/// f_i = -Σ_p V_p σ_p ∇N_ip = -Σ_p V⁰_p τ_p ∇N_ip              S (4), W (14)
template <int D>
struct MapInternalForce {
  static constexpr bool uses_gradients = true;
  const Particles<D>& particles;
  Grid<D>& grid;

  void operator()(std::size_t p, const auto& nodes, const auto& block, int k) const {
    nodes.scatter(ValueAndGradient<D>{Packed<D>::Zero(), -particles.V0[p] * block.tau[k]}, grid.f);
  }
};

/// f_i = Σ_p (N_ip m_p b_p - V⁰_p τ_p ∇N_ip)                   S (4), (16)
template <int D>
struct MapForces {
  static constexpr bool uses_gradients = true;
  const Particles<D>& particles;
  Grid<D>& grid;

  void operator()(std::size_t p, const auto& nodes, const auto& block, int k) const {
    const ValueAndGradient<D> force{packed<D>(particles.m[p] * block.b[k]), -particles.V0[p] * block.tau[k]};
    nodes.scatter(force, grid.f);
  }
};

/// v_p += Σ_i N_ip a_i Δt                                      S (9), W (18)
template <int D>
struct UpdateVelocity {
  Particles<D>& particles;
  const Grid<D>& grid;
  double dt;

  void operator()(std::size_t p, const auto& nodes, const auto&, int) const {
    particles.v[p] += dt * nodes.gather(grid.a).template head<D>();
  }
};

/// x_p += Σ_i N_ip v_i Δt                                      S (10), W (17)
template <int D>
struct UpdatePosition {
  Particles<D>& particles;
  const Grid<D>& grid;
  double dt;

  void operator()(std::size_t p, const auto& nodes, const auto&, int) const {
    particles.x[p] += dt * nodes.gather(grid.v).template head<D>();
  }
};

/// F_p follows L_p = Σ_i v_i ⊗ ∇N_ip                           S (7), (8), W (10), (11)
template <int D>
struct UpdateDeformation {
  static constexpr bool uses_gradients = true;
  Particles<D>& particles;
  const Grid<D>& grid;
  DeformationStep<D> deform;

  void operator()(std::size_t p, const auto& nodes, const auto&, int) const {
    deform(particles.F[p], nodes.gather_with_gradient(grid.v).gradient);
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

  void operator()(std::size_t p, const auto& nodes, const auto&, int) const {
    const auto v = nodes.gather_with_gradient(grid.v);
    particles.x[p] += dt * v.value.template head<D>();
    deform(particles.F[p], v.gradient);
  }
};

/// τ_p = τ(F_p)                                                S (3), W (12); with a history, of Δt since the last time
template <int D>
struct EvaluateStress {
  Particles<D>& particles;
  const AnyMaterial& material;
  double dt;

  void operator()(Block<D>& block, const Grid<D>& grid) const {
    const Mat<D>* F = &particles.F[block.begin];
    const auto count = static_cast<std::size_t>(block.count);
    std::visit(
        [&]<class M>(const M& m) {
          if constexpr (has_history<M>)
            m.kirchhoff(F, &particles.thermal[block.begin], StressStep{dt, grid.h()}, block.tau, count);
          else
            m.kirchhoff(F, block.tau, count);
        },
        material);
  }
};

/// b_p = b(X_p, t)
template <int D>
struct EvaluateBodyForce {
  const Particles<D>& particles;
  const BodyForce<D>& body_force;
  double t;

  void operator()(Block<D>& block, const Grid<D>&) const {
    body_force.on_particles(t, {&particles.id[block.begin], static_cast<std::size_t>(block.count)}, block.b);
  }
};

/// Finds inverted particles: det F <= 0, or not a number.
template <int D>
struct CheckDeformation {
  const Particles<D>& particles;

  Fault operator()(Block<D>& block, const Grid<D>&) const {
    const Mat<D>* F = &particles.F[block.begin];
    int inverted = 0;
    for (int k = 0; k < block.count; ++k) inverted += F[k].determinant() > 0 ? 0 : 1;
    return inverted > 0 ? Fault::inverted : Fault::none;
  }
};

/// l_p = l_p⁰ diag F, R_p = F R_p⁰                             W (63), N §2.1
template <int D>
struct UpdateWidth {
  Particles<D>& particles;

  void operator()(Block<D>& block, const Grid<D>&) const {
    particles.update_widths(block.begin, block.begin + static_cast<std::size_t>(block.count));
  }
};

/// Brings particles that left through a periodic face back in on the other side.
template <int D>
struct WrapPosition {
  Particles<D>& particles;
  const std::array<bool, D>& periodic;

  void operator()(Block<D>& block, const Grid<D>& grid) const {
    Vec<D>* x = &particles.x[block.begin];
    for (int d = 0; d < D; ++d) {
      if (!periodic[static_cast<std::size_t>(d)]) continue;
      const double lower = grid.lower()[d], period = grid.h() * grid.cells()[d], upper = lower + period;
      for (int k = 0; k < block.count; ++k) {
        const double x_d = x[k][d];
        x[k][d] = x_d < lower ? x_d + period : x_d >= upper ? x_d - period : x_d;
      }
    }
  }
};

/// Notes whether a particle has strayed so far from its slab that the particles must be sorted.
template <int D>
struct WatchSlab {
  const Particles<D>& particles;
  const Slabs<D>& slabs;
  std::atomic<bool>& must_sort;

  void operator()(Block<D>& block, const Grid<D>& grid) const {
    const Vec<D>* x = &particles.x[block.begin];
    const auto [least, most] = slabs.reach(block.slab, grid);
    int strays = 0;
    for (int k = 0; k < block.count; ++k) strays += x[k][D - 1] >= least && x[k][D - 1] <= most ? 0 : 1;
    if (strays > 0) must_sort = true;
  }
};

}  // namespace mpmvv::solver
