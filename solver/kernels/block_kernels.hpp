#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <span>
#include <variant>

#include "solver/body_force.hpp"
#include "solver/deformation.hpp"
#include "solver/fault.hpp"
#include "solver/material/materials.hpp"
#include "solver/parallel/slabs.hpp"
#include "solver/particles.hpp"
#include "solver/simd/padded.hpp"
#include "solver/stencils/extent.hpp"
#include "solver/stencils/particle_pack.hpp"

/// Block kernels (stencils/kernel.hpp): stress, body force, the update of F, moves, and what has to follow a move.
namespace mpmvv::solver {

/// τ_p = τ(F_p)                                                S (3), W (12)
/// A material with a history is advanced by `dt`, the time since its last evaluation.
template <int D>
struct EvaluateStress {
  Particles<D>& particles;
  const AnyMaterial& material;
  double dt;

  void operator()(Block<D>& block, const Grid<D>& grid) const {
    std::visit(
        [&]<class M>(const M& m) {
          if constexpr (has_history<M>)
            evaluate_each(m, block, StressStep{dt, grid.h()});
          else
            evaluate_packs(m, block);
        },
        material);
  }

 private:
  [[gnu::noinline, gnu::flatten]] void evaluate_packs(const auto& m, Block<D>& block) const {
    for_packs(
        block, [&](const ParticlePack& pack, int) __attribute__((always_inline)) {
          Eigen::Matrix<Pack, padded_size<D>, D> tau = Eigen::Matrix<Pack, padded_size<D>, D>::Zero();
          tau.template topRows<D>() = m.kirchhoff(pack.of(particles.F));
          (pack - block.begin).write(tau, block.tau);
        });
  }
  void evaluate_each(const auto& m, Block<D>& block, const StressStep& step) const {
    for (int k = 0; k < block.count; ++k) {
      const std::size_t p = block.begin + static_cast<std::size_t>(k);
      block.tau[k].setZero();
      block.tau[k].template topRows<D>() = m.kirchhoff(particles.F[p], particles.thermal[p], step);
    }
  }
};

/// b_p = b(X_p, t), or zero without a body force. Separate kernels for scenes without one would cost more time to
/// compile than adding zeros costs to run.
template <int D>
struct EvaluateBodyForce {
  const Particles<D>& particles;
  const BodyForce<D>* body_force;
  double t;

  void operator()(Block<D>& block, const Grid<D>&) const {
    if (body_force)
      body_force->on_particles(t, of_block(particles.id, block), of_block(particles.X, block), block.b);
    else
      std::fill_n(block.b, block.count, Vec<D>::Zero());
  }

 private:
  template <class T>
  static std::span<const T> of_block(const Array<T>& field, const Block<D>& block) {
    if (field.empty()) return {};
    return {&field[block.begin], static_cast<std::size_t>(block.count)};
  }
};

/// Finds inverted particles: det F <= 0, or not a number.
template <int D>
struct CheckDeformation {
  const Particles<D>& particles;

  [[gnu::flatten]] Fault operator()(Block<D>& block, const Grid<D>&) const {
    Mask4 positive{-1, -1, -1, -1};
    for_packs(block, [&](const ParticlePack& pack, int) {
      positive &= Mask4(pack.of(particles.F).determinant().of > Double4{});
    });
    return all(positive) ? Fault::none : Fault::inverted;
  }
};

/// Updates F_p by L_p, and finds inverted particles             S (8), W (11)
template <int D>
struct UpdateDeformation {
  Particles<D>& particles;
  DeformationStep deform;

  Fault operator()(Block<D>& block, const Grid<D>&) const {
    const bool is_linear = deform.rule == Deformation::linear;
    return is_linear ? update<Deformation::linear>(block) : update<Deformation::exponential>(block);
  }

 private:
  template <Deformation rule>
  [[gnu::noinline, gnu::flatten]] Fault update(Block<D>& block) const {
    Mask4 positive{-1, -1, -1, -1};
    for_packs(block, [&](const ParticlePack& pack, int) {
      const PackMat<D> L = (pack - block.begin).of(block.L).template topRows<D>();
      const PackMat<D> F = deform.template by<rule>(pack.of(particles.F), L);
      pack.write(F, particles.F.data());
      positive &= Mask4(F.determinant().of > Double4{});
    });
    return all(positive) ? Fault::none : Fault::inverted;
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

/// X' = X + Δt `rate`
template <int D>
struct MoveByRate {
  Particles<D>& particles;
  double dt;

  void operator()(Block<D>& block, const Grid<D>&) const {
    for (std::size_t p = block.begin; p < block.begin + static_cast<std::size_t>(block.count); ++p)
      particles.x[p] += dt * particles.rate[p];
  }
};

/// Brings particles that left through a periodic face back in on the other side. Sets `must_sort` if one has strayed so
/// far from its slab that the particles must be sorted. A position that is NaN passes here: the next sweep finds it.
template <int D>
struct WrapPosition {
  Particles<D>& particles;
  const std::array<bool, D>& periodic;
  const Slabs<D>& slabs;
  std::atomic<bool>& must_sort;

  void operator()(Block<D>& block, const Grid<D>& grid) const {
    const bool may_wrap = std::any_of(periodic.begin(), periodic.end(), std::identity{});
    if (!may_wrap && slabs.count() == 1) return;
    Extent<D> extent(block, particles.x);
    if (may_wrap && wrap(block, grid, extent)) extent = Extent<D>(block, particles.x);
    const auto [least, most] = slabs.reach(block.slab, grid);
    if (extent.least[D - 1] < least || extent.most[D - 1] > most) must_sort = true;
  }

 private:
  /// Brings particles back in through periodic faces. Returns whether one had left.
  bool wrap(const Block<D>& block, const Grid<D>& grid, const Extent<D>& extent) const {
    bool some = false;
    for (int d = 0; d < D; ++d) {
      const double lower = grid.lower()[d], period = grid.h() * grid.cells()[d], upper = lower + period;
      if (!periodic[static_cast<std::size_t>(d)] || (extent.least[d] >= lower && extent.most[d] < upper)) continue;
      some = true;
      for (std::size_t p = block.begin; p < block.begin + static_cast<std::size_t>(block.count); ++p) {
        double& x = particles.x[p][d];
        if (!(x >= lower && x < upper)) x = wrapped(x, lower, period);
      }
    }
    return some;
  }
  /// Moves x by whole periods to where it is at least `lower` and less than a period beyond, after rounding too.
  static double wrapped(double x, double lower, double period) {
    const double back = x - period * std::floor((x - lower) / period);
    return back < lower || back >= lower + period ? lower : back;
  }
};

}  // namespace mpmvv::solver
