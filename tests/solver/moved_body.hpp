#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <random>

#include "solver/stencils/sweep.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver {

/// Particles on their way, up to 0.4 cells along each axis from where they were sorted, with masses, velocities and
/// deformations of their own, on a grid in motion; and the weights of each, node by node.
template <int D>
struct MovedBody {
  Scene<D> scene;
  Particles<D>& particles = scene.particles;
  Grid<D> grid;
  std::vector<std::vector<Weight<D>>> weights;  ///< by particle

  /// Without weights it takes kernels, but gives no `value` or `gradient`.
  explicit MovedBody(const AnyBasis& basis, bool has_weights = true)
      : scene(full_scene<D>(basis, D == 3 ? 5 : 12, D == 1 ? 12 : 3, Free{})),
        grid(grid_for<D>(basis, scene.lower, scene.h, scene.cells)) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> some(-1, 1);
    const auto any = [&] { return some(random); };
    for (std::size_t p = 0; p < particles.size(); ++p) {
      particles.m[p] *= 1 + 0.5 * any();
      for (int d = 0; d < D; ++d) particles.x[p][d] = std::clamp(particles.x[p][d] + 0.4 * scene.h * any(), 0.0, 1.0);
      particles.v[p] = Vec<D>::NullaryExpr(any);
      particles.F[p] += 0.2 * Mat<D>::NullaryExpr(any);
      if (has_weights) weights.push_back(weights_of(basis, p));
    }
    for (auto* field : {&grid.v, &grid.a})
      for (auto& value : *field) value = Padded<D>::NullaryExpr(any);
  }

  /// Takes all particles through these kernels.
  void visit(std::initializer_list<AnyKernel<D>> kernels) {
    AnyBlock<D> any = make_block<D>(scene.basis, 0);
    const auto most = static_cast<std::size_t>(std::visit([](const auto& own) { return own.most; }, any));
    Block<D>& block = common<D>(any);
    for (block.begin = 0; block.begin < particles.size(); block.begin += most) {
      block.count = static_cast<int>(std::min(most, particles.size() - block.begin));
      ASSERT_EQ(evaluate(scene.basis, particles, grid, true, any), Fault::none);
      for (auto* handed_over : {block.L, block.tau})
        std::fill_n(handed_over, most, PaddedMat<D>::Constant(std::nan("")));
      for (const auto& kernel : kernels) kernel(any, grid);
    }
  }

  /// Σ_i N_ip φ_i
  Vec<D> value(std::size_t p, const Array<Padded<D>>& field) const {
    Vec<D> sum = Vec<D>::Zero();
    for (const auto& w : weights[p]) sum += w.N * field[w.n].template head<D>();
    return sum;
  }
  /// Σ_i φ_i ⊗ ∇N_ip
  Mat<D> gradient(std::size_t p, const Array<Padded<D>>& field) const {
    Mat<D> sum = Mat<D>::Zero();
    for (const auto& w : weights[p]) sum += field[w.n].template head<D>() * w.dN.transpose();
    return sum;
  }

 private:
  std::vector<Weight<D>> weights_of(const AnyBasis& basis, std::size_t p) const {
    Particles<D> one;
    one.resize(1);
    one.x[0] = particles.x[p];
    if (!particles.l.empty()) one.l = {particles.l[p]};
    if (!particles.R.empty()) one.R = {particles.R[p]};
    Fault found;
    auto all = weights_of_one(basis, one, grid, found);
    EXPECT_EQ(found, Fault::none);
    return all;
  }
};

/// In the first `rows` of each, which are no padding.
template <int rows, class Some, class Others>
void expect_near(const Some& some, const Others& others, const char* what) {
  double difference = 0, size = 0;
  for (std::size_t k = 0; k < some.size(); ++k) {
    difference = std::max(difference, (some[k] - others[k]).template topRows<rows>().norm());
    size = std::max(size, others[k].template topRows<rows>().norm());
  }
  EXPECT_GT(size, 0) << what;
  EXPECT_LT(difference, 1e-13 * size) << what;
}

}  // namespace mpmvv::solver
