#pragma once
#include "solver/point_block.hpp"

/// The affine velocity field about a particle, v_p + C_p (x - x_p), that APIC carries: Jiang, Schroeder, Selle, Teran,
/// Stomakhin 2015, equations (6) to (8) there, and N §2.6. For bases with nodes a cell apart and weights that spread,
/// so that D_p = Σ_i N_ip (x_i - x_p)(x_i - x_p)ᵀ, diagonal for tensor products, can be inverted.
namespace mpmvv::solver {

/// Whether a basis has such stencils.
template <class B>
inline constexpr bool has_affine_fields = B::ghost > 0 && B::support > 2 && B::width != ParticleWidth::domain;

/// x_i - x_p along each axis of a stencil's nodes.
template <int D, int K>
struct Arms {
  double length[D][K];

  Arms(const Weights<D, K>& nodes, const Grid<D>& grid, const Vec<D>& x) {
    const Index<D> first = grid.index(nodes.first);
    for (int d = 0; d < D; ++d)
      for (int i = 0; i < K; ++i)
        length[d][i] = grid.lower()[d] + grid.h() * (first[static_cast<std::size_t>(d)] + i) - x[d];
  }
};

/// Calls visit(n, N_ip, x_i - x_p) for each node.
template <int D, int K, class Visit>
void for_arms(const Weights<D, K>& nodes, const Grid<D>& grid, const Vec<D>& x, const Visit& visit) {
  const Arms<D, K> arms(nodes, grid, x);
  Index<D> i{};
  do {
    std::ptrdiff_t n = static_cast<std::ptrdiff_t>(nodes.first);
    double weight = 1;
    Vec<D> arm;
    for (int d = 0; d < D; ++d) {
      const int k = i[static_cast<std::size_t>(d)];
      n += k * nodes.stride[static_cast<std::size_t>(d)];
      weight *= nodes.N[d][k];
      arm[d] = arms.length[d][k];
    }
    visit(static_cast<std::size_t>(n), weight, arm);
    for (std::size_t d = 0; d < D && ++i[d] == K; ++d)
      if (d + 1 < D) i[d] = 0;
  } while (i[D - 1] < K);
}

/// p_i += N_ip m_p C_p (x_i - x_p) of a block's particles.
template <int D, int K, Evaluates evaluates>
[[gnu::noinline]] void scatter_affine(const Particles<D>& particles, const PointBlock<D, K, evaluates>& block,
                                      Grid<D>& grid) {
  for (int k = 0; k < block.count; ++k) {
    const std::size_t p = block.begin + static_cast<std::size_t>(k);
    for_arms<D, K>(block.stencil(k, grid), grid, particles.x[p], [&](std::size_t n, double N, const Vec<D>& arm) {
      grid.p[n] += N * packed<D>(particles.m[p] * (particles.C[p] * arm), 0);
    });
  }
}

/// C_p = Σ_i N_ip v_i (x_i - x_p)ᵀ D_p⁻¹ of a block's particles.
template <int D, int K, Evaluates evaluates>
[[gnu::noinline]] void gather_affine(Particles<D>& particles, const PointBlock<D, K, evaluates>& block,
                                     const Grid<D>& grid) {
  for (int k = 0; k < block.count; ++k) {
    const std::size_t p = block.begin + static_cast<std::size_t>(k);
    Mat<D> moment = Mat<D>::Zero();
    Vec<D> inertia = Vec<D>::Zero();
    for_arms<D, K>(block.stencil(k, grid), grid, particles.x[p], [&](std::size_t n, double N, const Vec<D>& arm) {
      moment += N * grid.v[n].template head<D>() * arm.transpose();
      inertia += N * arm.cwiseAbs2();
    });
    particles.C[p] = moment * inertia.cwiseInverse().asDiagonal();
  }
}

}  // namespace mpmvv::solver
