#include <Eigen/Geometry>
#include <random>

#include "tests/numbers.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::cpdi_test {

constexpr double cell_width = 0.125;
constexpr int cells_across = 6;

template <int D>
Grid<D> small_grid() {
  Index<D> count;
  count.fill(cells_across);
  return grid_for<Cpdi, D>(Vec<D>::Constant(-0.25), cell_width, count);
}

/// A particle somewhere in the domain with random edges, at most `reach` cells from its corners, and what it reaches.
template <int D>
struct RandomParticle {
  Particles<D> particles;
  AnyBlock<D> any = make_block<D>(Cpdi{}, 0);
  CpdiBlock<D, Cpdi::support>& block = std::get<CpdiBlock<D, Cpdi::support>>(any);
  CpdiStencil<D, Cpdi::support> nodes;

  RandomParticle(std::mt19937& random, const Grid<D>& grid, double reach = domain_reach) {
    std::uniform_real_distribution<double> place(0, cells_across), edge(-2 * reach / D, 2 * reach / D);
    particles.resize(1);
    particles.R.resize(1);
    for (int d = 0; d < D; ++d) {
      particles.x[0][d] = grid.lower()[d] + cell_width * place(random);
      for (int e = 0; e < D; ++e) particles.R[0](d, e) = edge(random);
    }
    block.begin = 0, block.count = 1;
    EXPECT_EQ(evaluate<D>(Cpdi{}, particles, grid, true, any), Fault::none);
    nodes = block.stencil(0, grid);
  }
};

template <int D>
Vec<D> position(const Grid<D>& grid, std::size_t n) {
  Vec<D> x = grid.lower();
  for (int d = 0; d < D; ++d) x[d] += grid.h() * grid.index(n)[static_cast<std::size_t>(d)];
  return x;
}

/// Mean over the domain of the multilinear interpolant of a node's hat at the corners, and of its gradient, by Gauss's
/// rule of two points along each edge, which is exact.
template <int D>
std::pair<double, Vec<D>> means(const Vec<D>& node, const Vec<D>& x, const Mat<D>& edges) {
  double N = 0;
  Vec<D> dN = Vec<D>::Zero();
  for (int point = 0; point < 1 << D; ++point)
    for (int c = 0; c < 1 << D; ++c) {
      Vec<D> corner = x, along = Vec<D>::Ones();
      double hat = 1, shape = 1;
      for (int d = 0; d < D; ++d) {
        const double s = (c >> d & 1) != 0 ? 1 : -1, xi = ((point >> d & 1) != 0 ? 1 : -1) / std::sqrt(3);
        corner += s / 2 * edges.col(d);
        shape *= (1 + s * xi) / 2;
        for (int e = 0; e < D; ++e) along[e] *= d == e ? s : (1 + s * xi) / 2;  // ∂/∂(xi_e / 2)
      }
      for (int d = 0; d < D; ++d) hat *= std::max(0.0, 1 - std::abs(corner[d] - node[d]) / cell_width);
      N += hat * shape / (1 << D);
      dN += hat / (1 << D) * edges.transpose().inverse() * along;
    }
  return {N, dN};
}

template <int D>
void expect_means() {
  std::mt19937 random(D);
  auto grid = small_grid<D>();
  for (int trial = 0; trial < 20; ++trial) {
    const RandomParticle<D> p(random, grid);
    const Mat<D> edges = cell_width * p.particles.R[0];
    if (std::abs(p.particles.R[0].determinant()) < 0.02) continue;
    Array<Vec<2>> N(grid.size(), Vec<2>::Zero());
    p.nodes.scatter(Vec<2>(1, 0), N);
    std::array<Array<Padded<D>>, D> dN;
    for (std::size_t d = 0; d < D; ++d) {
      dN[d].assign(grid.size(), Padded<D>::Zero());
      ValueAndGradient<D> unit{Padded<D>::Zero(), PaddedMat<D>::Zero()};
      unit.gradient(0, static_cast<int>(d)) = 1;
      p.nodes.scatter(unit, dN[d]);
    }
    for (std::size_t n = 0; n < grid.size(); ++n) {
      const auto [mean, mean_gradient] = means<D>(position(grid, n), p.particles.x[0], edges);
      EXPECT_NEAR(N[n][0], mean, 1e-15);
      for (std::size_t d = 0; d < D; ++d)
        EXPECT_NEAR(dN[d][n][0], mean_gradient[static_cast<int>(d)], 1e-12 / cell_width);
    }
  }
}

TEST(Cpdi, TakesTheMeansOfTheInterpolant) {
  expect_means<1>();
  expect_means<2>();
  expect_means<3>();
}

template <int D>
Padded<D> random_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> component(-1, 1);
  Vec<D> v;
  for (int d = 0; d < D; ++d) v[d] = component(random);
  return padded<D>(v);
}

template <int D>
void expect_adjoint() {
  std::mt19937 random(10 + D);
  auto grid = small_grid<D>();
  for (auto& v : grid.v) v = random_vector<D>(random);
  const RandomParticle<D> p(random, grid);
  ValueAndGradient<D> source{random_vector<D>(random), {}};
  for (int d = 0; d < D; ++d) source.gradient.col(d) = random_vector<D>(random);

  const auto v = p.nodes.gather_with_gradient(grid.v);
  EXPECT_LT((v.value - p.nodes.gather(grid.v)).template head<D>().norm(), 1e-15);
  const double on_particle = source.value.template head<D>().dot(v.value.template head<D>()) +
                             source.gradient.template topRows<D>().cwiseProduct(v.gradient.template topRows<D>()).sum();
  p.nodes.scatter(source, grid.f);
  double on_grid = 0;
  for (std::size_t n = 0; n < grid.size(); ++n)
    on_grid += grid.f[n].template head<D>().dot(grid.v[n].template head<D>());
  EXPECT_NEAR(on_grid, on_particle, 1e-12 * p.nodes.slope.template topRows<D>().norm());
}

TEST(Cpdi, ScatterIsTheAdjointOfGather) {
  expect_adjoint<1>();
  expect_adjoint<2>();
  expect_adjoint<3>();
}

/// By node, what a particle with an axis-aligned box as its domain reaches.
template <int D>
std::map<Index<D>, std::pair<double, Vec<D>>> box_reaches(const AnyBasis& basis, const Vec<D>& x, double width) {
  std::map<Index<D>, std::pair<double, Vec<D>>> nodes;
  Index<D> count;
  count.fill(cells_across);
  const auto grid = grid_for<D>(basis, Vec<D>::Zero(), 1, count);
  for (const auto& node : reached(Setting{basis, width}, grid, x)) {
    auto& [N, dN] = nodes.try_emplace(node.node, 0, Vec<D>::Zero()).first->second;
    N += node.N, dN += node.dN;
  }
  return nodes;
}

template <int D>
void expect_linear_within_a_cell(const Vec<D>& x, double width) {
  const auto corners = box_reaches<D>(Cpdi{}, x, width);
  for (const auto& [node, hat] : box_reaches<D>(Linear{}, x, width)) {
    EXPECT_NEAR(corners.at(node).first, hat.first, 1e-15);
    EXPECT_LT((corners.at(node).second - hat.second).norm(), 1e-14);
  }
}

TEST(Cpdi, IsTheLinearBasisWhileItsBoxLiesInACell) {
  expect_linear_within_a_cell<1>(Vec<1>(2.3), 0.5);
  expect_linear_within_a_cell<2>(Vec<2>(2.3, 3.7), 0.5);
  expect_linear_within_a_cell<3>(Vec<3>(2.3, 3.7, 0.5), 0.5);
}

TEST(Cpdi, HasTheGradientOfGimpOnALine) {  // (S(x + l/2) - S(x - l/2))/l both
  for (const double l : {0.1, 0.5, 1.0})
    for (const double xi : places(cells_across)) {
      auto corners = box_reaches<1>(Cpdi{}, Vec<1>(xi), l);
      for (const auto& [node, gimp] : box_reaches<1>(Gimp{}, Vec<1>(xi), l)) {
        const auto [N, dN] = corners.contains(node) ? corners[node] : std::pair{0.0, Vec<1>(0)};
        EXPECT_NEAR(dN[0], gimp.second[0], 1e-14) << xi << " " << l;
        EXPECT_NEAR(N, gimp.first, l / 4 + 1e-15) << xi << " " << l;
      }
    }
}

TEST(Cpdi, DomainsFollowTheDeformation) {
  Scene<2> scene = full_scene<2>(Cpdi{}, 16, 2);
  for (auto& R : scene.particles.R0) R = 0.5 * domain_shape<2>(true);
  for (auto& x : scene.particles.x) x.array() += 0.1 * scene.h;
  scene.particles.update_widths(0, scene.particles.size());
  set_wave(scene, 20);
  for (const auto integrator : integrator_words()) {
    scene.integrator = integrator;
    Mpm<2> mpm(scene);
    for (int k = 0; k < 5; ++k) ASSERT_TRUE(mpm.step(0.2 * scene.h / 120)) << mpm.fault();
    const auto& particles = mpm.particles();
    for (std::size_t p = 0; p < particles.size(); ++p)
      EXPECT_LT((particles.R[p] - particles.F[p] * scene.particles.R0[0]).norm(), 1e-15);
    EXPECT_GT((particles.F[3] - Mat<2>::Identity()).norm(), 0.01);
  }
}

TEST(Cpdi, BodyTurnsWithoutStress) {  // but for what the centrifugal force and the lumped mass leave
  const double wave_speed = 105, omega = 0.04 * wave_speed;
  Scene<2> scene = full_scene<2>(Cpdi{}, 16, 2, Free{});
  scene.lower = Vec<2>(-1, -1), scene.h = 0.125;
  scene.particles = particles_at<2>(lattice<2>(Vec<2>(-0.5, -0.5), scene.h / 2, {16, 16}), scene.h * scene.h / 4);
  set_widths(scene, 0.5);
  for (std::size_t p = 0; p < scene.particles.size(); ++p)
    scene.particles.v[p] = omega * Vec<2>(-scene.particles.x[p][1], scene.particles.x[p][0]);
  Mpm<2> mpm(scene);
  const double dt = 0.2 * scene.h / wave_speed;
  while (omega * mpm.time() < M_PI / 2) ASSERT_TRUE(mpm.step(dt)) << mpm.fault();
  for (const auto& F : mpm.particles().F) {
    EXPECT_LT((F.transpose() * F - Mat<2>::Identity()).norm(), 0.01);
    EXPECT_NEAR(std::atan2(F(1, 0), F(0, 0)), M_PI / 2, 0.15);
  }
}

TEST(Cpdi, LongDomainsAreFaultsBeyondTheirReach) {
  const auto grid = small_grid<2>();
  for (const double reach : {domain_reach + 1e-9, -domain_reach - 1e-9, nan, infinity}) {
    Fault fault;
    reached(Setting{Cpdi{}, 2 * reach}, grid, Vec<2>(0.2, 0.1), &fault);
    EXPECT_EQ(fault, Fault::outgrown) << reach;
  }
  Scene<1> scene = full_scene<1>(Cpdi{}, 8, 1);
  scene.particles.R[3](0, 0) = 5;
  Mpm<1> mpm(scene);
  EXPECT_FALSE(mpm.step(1e-4));
  EXPECT_EQ(mpm.fault(), "a corner of a particle is more than 2 cells from it");
}

}  // namespace mpmvv::solver::cpdi_test
