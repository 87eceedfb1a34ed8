#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <variant>

#include "solver/body_force.hpp"
#include "solver/fault.hpp"
#include "solver/material/materials.hpp"
#include "solver/parallel/slabs.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/extent.hpp"
#include "solver/stencils/particle_pack.hpp"

/// Block kernels (stencils/kernel.hpp): stress, body force, and what follows a move.
namespace mpmvv::solver {

/// τ_p = τ(F_p)                                                S (3), W (12); with a history, of Δt since the last time
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
        block, [&](const ParticlePack<D>& pack, int k)
                   __attribute__((always_inline)) { put(m.kirchhoff(pack.of(particles.F)), block, k); });
  }
  void evaluate_each(const auto& m, Block<D>& block, const StressStep& step) const {
    for_packs(block, [&](const ParticlePack<D>& pack, int k) {
      PackMat<D> tau = PackMat<D>::Zero();
      for (int lane = 0; lane < pack.count(); ++lane) {
        const std::size_t p = pack.index(lane);
        const Mat<D> own = m.kirchhoff(particles.F[p], particles.thermal[p], step);
        for (int i = 0; i < D * D; ++i) tau(i).of[lane] = own(i);
      }
      put(tau, block, k);
    });
  }
  /// Sets the stresses of a pack whose first particle is the k-th.
  [[gnu::always_inline]] static void put(const PackMat<D>& tau, Block<D>& block, int k) {
    for (int c = 0; c < D; ++c)
      if (block.is_grouped) {
        for (int r = 0; r < D; ++r) store_lanes(tau(r, c).of, &block.tau.entry[r][c][k]);
      } else {
        std::array<Pack, padded_size<D>> column{};
        for (int r = 0; r < D; ++r) column[static_cast<std::size_t>(r)] = tau(r, c);
        PaddedMat<D>* const each = &block.tau.each[k];
        LaneAddresses<double> to;
        for (int lane = 0; lane < lanes; ++lane) to[static_cast<std::size_t>(lane)] = &each[lane](0, c);
        store_packs<padded_size<D>>(column.data(), to);
      }
  }
};

/// b_p = b(X_p, t), or zero without a body force: kernels for those scenes alone would cost more time to compile than
/// adding zeros costs to run.
template <int D>
struct EvaluateBodyForce {
  const Particles<D>& particles;
  const BodyForce<D>* body_force;
  double t;

  void operator()(Block<D>& block, const Grid<D>&) const {
    if (!body_force) return std::fill_n(block.b, block.places(), Vec<D>::Zero()), void();
    std::array<std::uint32_t, block_size<D>> ids;
    for (int k = 0; k < block.places(); ++k) ids[static_cast<std::size_t>(k)] = particles.id[block.particle[k]];
    body_force->on_particles(t, {ids.data(), static_cast<std::size_t>(block.places())}, block.b);
  }
};

/// Finds inverted particles: det F <= 0, or not a number.
template <int D>
struct CheckDeformation {
  const Particles<D>& particles;

  [[gnu::flatten]] Fault operator()(Block<D>& block, const Grid<D>&) const {
    LaneMask positive = ~LaneMask{};
    for_packs(block, [&](const ParticlePack<D>& pack, int) {
      positive &= LaneMask(pack.of(particles.F).determinant().of > Lanes{});
    });
    return all(positive) ? Fault::none : Fault::inverted;
  }
};

/// l_p = l_p⁰ diag F, R_p = F R_p⁰                             W (63), N §2.1
template <int D>
struct UpdateWidth {
  Particles<D>& particles;

  void operator()(Block<D>& block, const Grid<D>&) const {
    if (particles.has_widths_to_update()) for_particles(block, [&](std::size_t p, int) { particles.update_width(p); });
  }
};

/// X' = X + Δt `rate`
template <int D>
struct MoveByRate {
  Particles<D>& particles;
  double dt;

  void operator()(Block<D>& block, const Grid<D>&) const {
    for_particles(block, [&](std::size_t p, int) { particles.x[p] += dt * particles.rate[p]; });
  }
};

/// Brings particles that left through a periodic face back in on the other side, and notes whether one has strayed so
/// far from its slab that the particles must be sorted. A position that is NaN is a fault of the next sweep.
template <int D>
struct SettlePosition {
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
  /// Whether one had left.
  bool wrap(const Block<D>& block, const Grid<D>& grid, const Extent<D>& extent) const {
    bool some = false;
    for (int d = 0; d < D; ++d) {
      const double lower = grid.lower()[d], period = grid.h() * grid.cells()[d], upper = lower + period;
      if (!periodic[static_cast<std::size_t>(d)] || (extent.least[d] >= lower && extent.most[d] < upper)) continue;
      some = true;
      for_particles(block, [&](std::size_t p, int) {
        double& x = particles.x[p][d];
        x = x < lower ? x + period : x >= upper ? x - period : x;
      });
    }
    return some;
  }
};

}  // namespace mpmvv::solver
