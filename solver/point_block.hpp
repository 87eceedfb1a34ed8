#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "solver/basis/basis.hpp"
#include "solver/company.hpp"
#include "solver/fault.hpp"
#include "solver/grid.hpp"
#include "solver/particles.hpp"
#include "solver/runs.hpp"
#include "solver/stencil.hpp"

namespace mpmvv::solver {

/// A block with the nodes that each of its particles reaches. Weights and gradients are kept per axis; a `Stencil` or
/// `SharedNodes` forms their products.
template <int D, int K, Evaluates evaluates = Evaluates::weights_and_gradients>
struct PointBlock : Block<D> {
  static constexpr int most = block_size<D>;  ///< particles
  static constexpr int room = most + 4;       ///< four may be read at the last
  int first[room];                            ///< storage index of the first node
  alignas(32) double N[D][K][room];           ///< weights
  alignas(32) double dN[D][K][room];          ///< gradients, per length
  int runs;                                   ///< of particles that share their nodes
  int run[block_size<D> + 1];                 ///< where each begins, and the end

  auto stencil(int k, const Grid<D>& grid) const {
    constexpr bool gradients = evaluates == Evaluates::weights_and_gradients;
    std::conditional_t<gradients, Stencil<D, K>, Weights<D, K>> s;
    s.first = static_cast<std::size_t>(first[k]);
    for (int d = 0; d < D; ++d) {
      s.stride[static_cast<std::size_t>(d)] = grid.stride(d);
      for (int i = 0; i < K; ++i) {
        s.N[d][i] = N[d][i][k];
        if constexpr (gradients) s.dN[d][i] = dN[d][i][k];
      }
    }
    return s;
  }
};

/// Repeats the last weights: four are read from any place on, and those of no particle have to be finite.
template <int D, int K, Evaluates evaluates>
void pad(PointBlock<D, K, evaluates>& block) {
  const auto repeat = [&block](double* of_node) { std::fill_n(of_node + block.count, 3, of_node[block.count - 1]); };
  for (int d = 0; d < D; ++d)
    for (int i = 0; i < K; ++i) {
      repeat(block.N[d][i]);
      if constexpr (evaluates == Evaluates::weights_and_gradients) repeat(block.dN[d][i]);
    }
}

/// The positions of a block's particles from the lower faces, in cells, moved to where a basis may be evaluated, and
/// their widths, by axis. What lies beyond the last of them repeats it, up to four.
template <int D>
struct PointsByAxis {
  static constexpr int room = block_size<D> + 4;
  alignas(32) double xi[D][room], width[D][room];
};

/// Faults as `evaluate_stencils`.
template <class B, int D>
[[gnu::flatten]] Fault find_points(const Block<D>& block, const Particles<D>& particles, const Grid<D>& grid,
                                   PointsByAxis<D>& points) {
  const double inverse_h = 1 / grid.h();
  Vec<D> least, most;
  for (int d = 0; d < D; ++d) {
    const int cells = grid.cells()[d];
    least[d] = B::ghost == 0 ? 0 : std::max(1, (B::support - 1) / 2) - B::ghost;
    most[d] = B::ghost == 0 ? cells : std::nextafter(cells - least[d], 0.0);
  }
  Truths outside{}, outgrown{};
  for_fours(block, [&](const Company<D>& company, int k) {
    const FourVec<D> x = company.of(particles.x);
    for (int d = 0; d < D; ++d) {
      const Four xi = (x[d] - grid.lower()[d]) * inverse_h;
      store_quad(confined(xi, least[d], most[d], outside).of, &points.xi[d][k]);
    }
    if constexpr (B::width != ParticleWidth::none) {
      const FourVec<D> l = company.of(particles.l);
      for (int d = 0; d < D; ++d)
        store_quad(confined(l[d], std::numeric_limits<double>::min(), 1, outgrown).of, &points.width[d][k]);
    }
  });
  return (any(outside) ? Fault::outside : Fault::none) | (any(outgrown) ? Fault::outgrown : Fault::none);
}

/// Evaluates the stencils of a block at its particles' positions. A particle out of reach of the grid, or a NaN, is a
/// fault; its stencil then lies somewhere inside storage, and the caller stops the run.
template <int D, class B, Evaluates evaluates>
Fault evaluate_stencils(const B& basis, const Particles<D>& particles, const Grid<D>& grid,
                        PointBlock<D, B::support, evaluates>& block) {
  PointsByAxis<D> points;
  const Fault found = find_points<B>(block, particles, grid, points);
  const double inverse_h = 1 / grid.h();
  const int padded = (block.count + 3) / 4 * 4;
  std::fill_n(block.first, padded, grid.node({}));
  for (int d = 0; d < D; ++d) {
    const int cells = grid.cells()[d], stride = grid.stride(d);
    int first[PointsByAxis<D>::room];
    for (int k = 0; k < padded; ++k) {
      double N[B::support], dN[B::support];
      const double width = B::width == ParticleWidth::none ? 0 : points.width[d][k];
      first[k] = basis.evaluate({points.xi[d][k], cells, width}, N, dN);
      for (int i = 0; i < B::support; ++i) {
        block.N[d][i][k] = N[i];
        if constexpr (evaluates == Evaluates::weights_and_gradients) block.dN[d][i][k] = dN[i] * inverse_h;
      }
    }
    for (int k = 0; k < padded; ++k) block.first[k] += stride * first[k];
  }
  pad(block);
  return found;
}

/// Evaluates the stencils of a block and forms its companies.
template <int D, class B, Evaluates evaluates>
Fault set_up(const B& basis, const Particles<D>& particles, const Grid<D>& grid,
             PointBlock<D, B::support, evaluates>& block) {
  const Fault found = evaluate_stencils(basis, particles, grid, block);
  form_companies(block);
  return found;
}

}  // namespace mpmvv::solver
