#pragma once
#include <gtest/gtest.h>

#include <initializer_list>
#include <random>

#include "solver/kernels/block_kernels.hpp"
#include "solver/stencils/stencil_groups.hpp"
#include "solver/stencils/sweep.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver {

/// Particles on their way, up to 0.4 cells along each axis from where they were sorted, so that groups of
/// particles with the same nodes have all lengths; with masses, velocities and deformations of their own, on a grid in
/// motion.
template <int D, class B>
struct MovedBody {
  Scene<D> scene = full_scene<D>(B{}, D == 3 ? 8 : 12, D == 1 ? 12 : 3, Free{});
  Particles<D>& particles = scene.particles;
  Grid<D> grid = grid_for<B, D>(scene.lower, scene.h, scene.cells);

  MovedBody() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> some(-1, 1);
    const auto any = [&] { return some(random); };
    ThreadPool alone(1);
    Slabs<D>(grid, B{}).sort(particles, grid, alone);
    for (std::size_t p = 0; p < particles.size(); ++p) {
      particles.m[p] *= 1 + 0.5 * any();
      for (int d = 0; d < D; ++d) particles.x[p][d] = std::clamp(particles.x[p][d] + 0.4 * scene.h * any(), 0.0, 1.0);
      particles.v[p] = Vec<D>::NullaryExpr(any);
      particles.F[p] += 0.2 * Mat<D>::NullaryExpr(any);
    }
    for (auto* field : {&grid.v, &grid.a})
      for (auto& value : *field) value = Padded<D>::NullaryExpr(any);
  }

  /// Takes all particles through these kernels.
  void visit(bool is_grouped, std::initializer_list<AnyKernel<D>> kernels) {
    AnyBlock<D> any = make_block<D>(B{}, 0);
    auto& block = std::get<PointBlock<D, B::support>>(any);
    for (block.begin = 0; block.begin < particles.size(); block.begin += block.most) {
      block.count = static_cast<int>(std::min<std::size_t>(block.most, particles.size() - block.begin));
      ASSERT_EQ(evaluate(B{}, particles, grid, true, any), Fault::none);
      list_groups(block, find_group_ends(block));
      block.is_grouped = is_grouped;
      for (auto& row : block.tau.entry)
        for (auto& entries : row) std::fill(std::begin(entries), std::end(entries), std::nan(""));
      for (const auto& kernel : kernels) kernel(any, grid);
    }
  }
};

/// In the first `rows` of each, which are no padding.
template <int rows, class Field>
void expect_near(const Field& some, const Field& others, const char* what) {
  double difference = 0, size = 0;
  for (std::size_t k = 0; k < some.size(); ++k) {
    difference = std::max(difference, (some[k] - others[k]).template topRows<rows>().norm());
    size = std::max(size, some[k].template topRows<rows>().norm());
  }
  EXPECT_GT(size, 0) << what;
  EXPECT_LT(difference, 1e-14 * size) << what;
}

}  // namespace mpmvv::solver
