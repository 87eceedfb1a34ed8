#pragma once
#include <algorithm>
#include <atomic>
#include <tuple>
#include <type_traits>
#include <vector>

#include "solver/basis/basis.hpp"
#include "solver/grid.hpp"
#include "solver/particles.hpp"
#include "solver/slabs.hpp"
#include "solver/team.hpp"

namespace mpmvv::solver {

/// Why a run has blown up; kept by the first one to happen.
enum class Fault { none, outside, inverted, outgrown };

/// The nodes that one particle reaches: weights and gradients per axis, tensor products formed on the way.
template <int D, int K>
struct Stencil {
  int first;       ///< storage index of the first node
  double N[D][K];  ///< weights
  double dN[D][K]; ///< gradients, per length

  /// Calls visit(storage index, N_ip, ∇N_ip) for each of the K^D nodes, in storage order.
  template <class Visit>
  void for_nodes(const Grid<D>& grid, const Visit& visit) const {
    if constexpr (D == 1) {
      for (int i = 0; i < K; ++i) visit(first + i, N[0][i], Vec<1>(dN[0][i]));
    } else if constexpr (D == 2) {
      for (int j = 0; j < K; ++j)
        for (int i = 0; i < K; ++i)
          visit(first + i + j * grid.stride(1), N[0][i] * N[1][j], Vec<2>(dN[0][i] * N[1][j], N[0][i] * dN[1][j]));
    } else {
      for (int k = 0; k < K; ++k)
        for (int j = 0; j < K; ++j) {
          const double jk = N[1][j] * N[2][k], djk = dN[1][j] * N[2][k], jdk = N[1][j] * dN[2][k];
          const int row = first + j * grid.stride(1) + k * grid.stride(2);
          for (int i = 0; i < K; ++i) visit(row + i, N[0][i] * jk, Vec<3>(dN[0][i] * jk, N[0][i] * djk, N[0][i] * jdk));
        }
    }
  }
};

inline constexpr int block_size = 64;

/// A few neighbouring particles with all that the stages of a sweep hand to each other.
template <int D, int K>
struct Block {
  int slab;
  std::size_t begin;
  int count;
  Stencil<D, K> stencil[block_size];
  Mat<D> tau[block_size];  ///< Kirchhoff stress, by EvaluateStress
  Vec<D> b[block_size];    ///< body acceleration, by EvaluateBodyForce
};

/// Node-level operations fused into one loop over particles and nodes. Each has begin(particle, block, k),
/// node(n, N, dN) and end(particle).
template <class... Ops>
struct NodeLoop {
  std::tuple<Ops...> ops;

  template <int D, int K>
  void operator()(Block<D, K>& block, const Grid<D>& grid) {
    std::apply(
        [&](Ops&... op) {
          for (int k = 0; k < block.count; ++k) {
            const std::size_t p = block.begin + static_cast<std::size_t>(k);
            (op.begin(p, block, k), ...);
            block.stencil[k].for_nodes(grid, [&](int n, double N, const Vec<D>& dN) { (op.node(n, N, dN), ...); });
            (op.end(p), ...);
          }
        },
        ops);
  }
};

template <>
struct NodeLoop<> {
  template <int D, int K>
  void operator()(Block<D, K>&, const Grid<D>&) const {}
};

template <class... Ops>
NodeLoop<Ops...> node_loop(Ops... ops) {
  if constexpr (sizeof...(Ops) == 0)
    return {};
  else
    return {std::tuple<Ops...>{ops...}};
}

/// Evaluates the stencils of a block at the particles' positions. A particle out of reach of the grid, or a NaN,
/// is a fault; its stencil is then set to the first one that is inside storage, and the caller stops the run.
template <int D, class B>
Fault evaluate_stencils(const B& basis, const Particles<D>& particles, const Grid<D>& grid,
                        Block<D, B::support>& block) {
  constexpr double stray = B::ghost == 0 ? 0 : B::ghost - 1;
  const double inverse_h = 1 / grid.h();
  Fault fault = Fault::none;
  for (int k = 0; k < block.count; ++k) {
    const std::size_t p = block.begin + static_cast<std::size_t>(k);
    Stencil<D, B::support>& stencil = block.stencil[k];
    Index<D> first;
    for (int d = 0; d < D; ++d) {
      AxisPoint at{(particles.x[p][d] - grid.lower()[d]) * inverse_h, grid.cells()[d], 0};
      if constexpr (B::width != ParticleWidth::none) {
        at.width = particles.l[p][d];
        if (!(at.width > 0 && at.width <= 1)) fault = Fault::outgrown, at.width = 1;
      }
      if (!(at.xi >= -stray && at.xi <= at.cells + stray)) fault = Fault::outside, at.xi = 0;
      first[d] = basis.evaluate(at, stencil.N[d], stencil.dN[d]);
      for (double& dN : stencil.dN[d]) dN *= inverse_h;
    }
    stencil.first = grid.node(first);
  }
  return fault;
}

/// A stage either returns nothing or a fault that it found.
template <int D, int K, class Stage>
void run_stage(Stage& stage, Block<D, K>& block, const Grid<D>& grid, Fault& fault) {
  if constexpr (std::is_same_v<decltype(stage(block, grid)), Fault>) {
    const Fault found = stage(block, grid);
    if (found != Fault::none) fault = found;
  } else {
    stage(block, grid);
  }
}

/// One visit to all particles: per block the stencils once, then every stage in turn. Slabs of one colour share no
/// node and run at once; the order of additions on a node does not depend on the number of threads.
template <int D, class B, class... Stages>
Fault sweep(const B& basis, const Particles<D>& particles, const Grid<D>& grid, const Slabs<D>& slabs, Team& team,
            const Stages&... stages) {
  std::atomic<Fault> fault{Fault::none};
  for (int colour = 0; colour < 2; ++colour) {
    team.run((slabs.count() - colour + 1) / 2, [&](int task) {
      const auto [begin, end] = slabs.particles(2 * task + colour);
      std::tuple<Stages...> own{stages...};
      Block<D, B::support> block;
      block.slab = 2 * task + colour;
      for (block.begin = begin; block.begin < end; block.begin += block_size) {
        block.count = static_cast<int>(std::min<std::size_t>(block_size, end - block.begin));
        Fault found = evaluate_stencils(basis, particles, grid, block);
        std::apply([&](Stages&... stage) { (run_stage(stage, block, grid, found), ...); }, own);
        if (found != Fault::none) fault = found;
      }
    });
  }
  return fault;
}

}  // namespace mpmvv::solver
