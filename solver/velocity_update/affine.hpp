#pragma once
#include <algorithm>

#include "solver/basis/basis.hpp"
#include "solver/grid.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/point_block.hpp"

/// The affine velocity field about a particle, v_p + C_p (x - x_p), that APIC carries: Jiang, Schroeder, Selle, Teran,
/// Stomakhin 2015, equations (6) to (8) there, and N §2.6. It needs a basis with nodes a cell apart and weights on
/// several of them wherever the particle is. Then D_p = Σ_i N_ip (x_i - x_p)(x_i - x_p)ᵀ, which is diagonal for tensor
/// products, can be inverted.
namespace mpmvv::solver {

/// Whether a basis has the nodes and weights that affine fields need.
template <class B>
inline constexpr bool has_affine_fields = B::ghost > 0 && B::support > 2 && B::width != ParticleWidth::domain;

/// A particle's stencil with N_ip (x_i - x_p) in the place of the gradients `dN`, so that `gather_with_gradient` sums
/// first moments, and the diagonal of D_p as `inertia`.
template <int D, int K>
struct ArmStencil : Stencil<D, K> {
  Vec<D> inertia;

  ArmStencil(const Weights<D, K>& nodes, const Grid<D>& grid, const Vec<D>& x) : Stencil<D, K>{nodes, {}} {
    const Index<D> corner = grid.index(nodes.first);
    inertia.setZero();
    for (int d = 0; d < D; ++d)
      for (int i = 0; i < K; ++i) {
        const double arm = grid.lower()[d] + grid.h() * (corner[static_cast<std::size_t>(d)] + i) - x[d];
        this->dN[d][i] = arm * nodes.N[d][i];
        inertia[d] += arm * this->dN[d][i];
      }
  }

  /// Returns the weights N_ip (x_i - x_p)_d.
  Weights<D, K> arms_along(int d) const {
    Weights<D, K> arms = *this;
    std::ranges::copy(this->dN[d], arms.N[d]);
    return arms;
  }
};

/// A block kernel: p_i += N_ip m_p C_p (x_i - x_p), where the velocity update keeps C.
template <int D>
struct MapAffineMomentum {
  const Particles<D>& particles;
  Grid<D>& grid;

  void operator()(const Block<D>&, const Grid<D>&) const {}
  template <int K>
  void operator()(const PointBlock<D, K>& block, const Grid<D>&) const {
    if (!particles.C.empty()) scatter(block);
  }

 private:
  template <int K>
  [[gnu::noinline]] void scatter(const PointBlock<D, K>& block) const {
    for (int k = 0; k < block.count; ++k) {
      const std::size_t p = block.begin + static_cast<std::size_t>(k);
      const ArmStencil<D, K> nodes(block.template stencil<false>(k, grid), grid, particles.x[p]);
      for (int d = 0; d < D; ++d)
        nodes.arms_along(d).scatter(padded<D>(particles.m[p] * particles.C[p].col(d), 0), grid.p);
    }
  }
};

/// A block kernel: C_p = Σ_i N_ip v_i (x_i - x_p)ᵀ D_p⁻¹, where the velocity update keeps C.
template <int D>
struct UpdateAffineField {
  Particles<D>& particles;
  const Grid<D>& grid;

  void operator()(const Block<D>&, const Grid<D>&) const {}
  template <int K>
  void operator()(const PointBlock<D, K>& block, const Grid<D>&) const {
    if (!particles.C.empty()) gather(block);
  }

 private:
  template <int K>
  [[gnu::noinline]] void gather(const PointBlock<D, K>& block) const {
    for (int k = 0; k < block.count; ++k) {
      const std::size_t p = block.begin + static_cast<std::size_t>(k);
      const ArmStencil<D, K> nodes(block.template stencil<false>(k, grid), grid, particles.x[p]);
      const auto moment = nodes.gather_with_gradient(grid.v).gradient;
      particles.C[p] = moment.template topRows<D>() * nodes.inertia.cwiseInverse().asDiagonal();
    }
  }
};

}  // namespace mpmvv::solver
