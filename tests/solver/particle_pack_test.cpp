#include "solver/kernels/add_mass_product.hpp"
#include "solver/kernels/map_to_grid.hpp"
#include "solver/kernels/update_particles.hpp"
#include "tests/solver/moved_body.hpp"

namespace mpmvv::solver::particle_pack_test {

/// Another one on each particle.
template <int D>
struct SomeForce final : BodyForce<D> {
  void on_particles(double, std::span<const std::uint32_t> ids, std::span<const Vec<D>>, Vec<D>* b) const override {
    for (const auto id : ids) *b++ = Vec<D>::Constant(std::sin(3.0 * id));
  }
  Vec<D> at_position(const Vec<D>&, double) const override { return Vec<D>::Zero(); }
};

template <class B, int D>
void expect_to_map_as_each_alone(const AnyMaterial& material, const BodyForce<D>* force) {
  MovedBody<D, B> together, alone;
  for (auto* body : {&together, &alone}) {
    auto& particles = body->particles;
    auto& grid = body->grid;
    if (std::holds_alternative<MieGruneisen>(material)) particles.thermal.resize(particles.size());
    body->visit(body == &together,
                {EvaluateStress<D>{particles, material, 1}, EvaluateBodyForce<D>{particles, force, 0},
                 Fused{MapMomentum<D>{particles, grid}, MapForces<D>{particles, grid}}});
  }
  expect_near<D + 1>(together.grid.p, alone.grid.p, "momentum");
  expect_near<D>(together.grid.f, alone.grid.f, "force");
}

template <class B, int D>
void expect_to_move_as_each_alone(Deformation rule) {
  MovedBody<D, B> together, alone;
  for (auto* body : {&together, &alone})
    body->visit(body == &together, {UpdateVelocity<D>{body->particles, body->grid, 0.1},
                                    UpdatePositionAndDeformation<D>{body->particles, body->grid, 0.1, {0.01, rule}}});
  expect_near<D>(together.particles.x, alone.particles.x, "position");
  expect_near<D>(together.particles.v, alone.particles.v, "velocity");
  expect_near<D>(together.particles.F, alone.particles.F, "deformation");
}

template <class B, int D>
void expect_mass_products_as_each_alone() {
  MovedBody<D, B> together, alone;
  for (auto* body : {&together, &alone})
    body->visit(body == &together, {AddMassProduct<D>{body->particles, body->grid.v, body->grid.f}});
  expect_near<D>(together.grid.f, alone.grid.f, "momentum");
}

template <class B, int D>
void expect_all_as_each_alone() {
  if constexpr (B::width == ParticleWidth::domain) {
    GTEST_SKIP() << "particles with domains do not go in packs";
  } else {
    const SomeForce<D> force;
    expect_to_map_as_each_alone<B, D>(NeoHookeanLog{3000, 4000}, &force);
    expect_to_map_as_each_alone<B, D>(MieGruneisen{.bulk_modulus = 1e4, .gamma = 1}, nullptr);
    expect_to_move_as_each_alone<B, D>(Deformation::linear);
    expect_to_move_as_each_alone<B, D>(Deformation::exponential);
    expect_mass_products_as_each_alone<B, D>();
  }
}

template <class B>
class ParticlePacks : public ::testing::Test {};
TYPED_TEST_SUITE(ParticlePacks, TestedBases);

TYPED_TEST(ParticlePacks, DoAsEachAloneOnALine) {
  expect_all_as_each_alone<TypeParam, 1>();
}
TYPED_TEST(ParticlePacks, DoAsEachAloneInThePlane) {
  expect_all_as_each_alone<TypeParam, 2>();
}
TYPED_TEST(ParticlePacks, DoAsEachAloneInSpace) {
  expect_all_as_each_alone<TypeParam, 3>();
}

/// A block of particles that lie in these cells of a line, one after the other.
PointBlock<1, BSpline3::support> block_in(const std::vector<int>& cells) {
  Particles<1> particles;
  particles.resize(cells.size());
  for (std::size_t p = 0; p < cells.size(); ++p)
    particles.x[p][0] = cells[p] + 0.1 + 0.8 * static_cast<double>(p) / static_cast<double>(cells.size());
  PointBlock<1, BSpline3::support> block(0);
  block.begin = 0;
  block.count = static_cast<int>(cells.size());
  EXPECT_EQ(evaluate_stencils(BSpline3{}, particles, Grid<1>(Vec<1>(0), 1, {10}, 1, 2), true, block), Fault::none);
  group_by_stencil(block);
  return block;
}

TEST(StencilGroups, AreOfNeighboursWithTheSameNodes) {
  auto block = block_in({3, 3, 3, 3, 3, 4, 3, 3, 7});
  EXPECT_EQ(list_groups(block, find_group_ends(block)), 2 + 1 + 1 + 1);
  ASSERT_EQ(block.groups, 4);
  EXPECT_EQ(std::vector<int>(block.group, block.group + 5), (std::vector{0, 5, 6, 8, 9}));
}

TEST(StencilGroups, AreFoundInBlocksOfEverySize) {
  std::mt19937 random(8);
  for (int count = 1; count <= block_size<1>; ++count) {
    std::vector<int> cells(static_cast<std::size_t>(count));
    for (std::size_t p = 0; p < cells.size(); ++p)
      cells[p] = p > 0 && random() % 3 > 0 ? cells[p - 1] : static_cast<int>(2 + random() % 6);
    auto block = block_in(cells);
    block.count = count;
    std::vector<int> expected{0};
    for (int k = 1; k < count; ++k)
      if (block.first[k] != block.first[k - 1]) expected.push_back(k);
    expected.push_back(count);
    list_groups(block, find_group_ends(block));
    EXPECT_EQ(std::vector<int>(block.group, block.group + block.groups + 1), expected) << count;
  }
}

/// So many in the first cell, then so many in the next.
PointBlock<1, BSpline3::support> block_of(int first, int second) {
  std::vector<int> cells(static_cast<std::size_t>(first + second), 1);
  std::fill(cells.begin() + first, cells.end(), 2);
  return block_in(cells);
}

TEST(StencilGroups, AreLeftToTheNextBlockWhenAFullOneMayCutThem) {
  EXPECT_EQ(block_of(100, 28).count, 100);
  EXPECT_EQ(block_of(64, 64).count, 128);
  EXPECT_EQ(block_of(127, 1).count, 127);
  EXPECT_EQ(block_of(100, 27).count, 127) << "the block is not full";
  std::vector<int> cells(128);
  for (std::size_t p = 0; p < cells.size(); ++p) cells[p] = static_cast<int>(p / 2 % 8);
  EXPECT_EQ(block_in(cells).count, 128) << "not in packs";
}

TEST(StencilGroups, GoInPacksWhereThatPays) {
  EXPECT_TRUE(block_in(std::vector<int>(16, 5)).is_grouped);
  EXPECT_TRUE(block_in({1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2}).is_grouped);
  EXPECT_TRUE(block_in({1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3}).is_grouped);
  EXPECT_FALSE(block_in({1, 1, 1, 2, 2, 2, 3, 3, 3}).is_grouped);
  EXPECT_FALSE(block_in({1, 2, 3, 4, 5, 6, 7, 8}).is_grouped);
  EXPECT_FALSE(block_in({1}).is_grouped);
}

TEST(Extents, AreOfAllParticlesOfABlockAndNoOthers) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> some(-1, 1);
  std::vector<Vec<2>> x(20);
  for (auto& at : x) at = Vec<2>::NullaryExpr([&] { return some(random); });
  for (int count = 1; count < 12; ++count) {
    Block<2> block(0);
    block.begin = 3, block.count = count;
    const Extent<2> extent(block, x);
    Vec<2> least = x[3], most = x[3];
    for (int k = 1; k < count; ++k) {
      least = least.cwiseMin(x[static_cast<std::size_t>(3 + k)]);
      most = most.cwiseMax(x[static_cast<std::size_t>(3 + k)]);
    }
    EXPECT_EQ(extent.least, least) << count;
    EXPECT_EQ(extent.most, most) << count;
  }
}

/// Whether a particle astray is found at every place of a block.
void expect_fault_at_every_place(double astray) {
  const Grid<2> grid(Vec<2>::Zero(), 0.1, {10, 10}, 1, 2);
  for (std::size_t count = 1; count < 10; ++count)
    for (std::size_t p = 0; p < count; ++p) {
      Particles<2> particles;
      particles.resize(count);
      for (auto& x : particles.x) x = {0.51, 0.47};
      particles.x[p][1] = astray;
      PointBlock<2, BSpline2::support> block(0);
      block.begin = 0;
      block.count = static_cast<int>(count);
      EXPECT_EQ(evaluate_stencils(BSpline2{}, particles, grid, true, block), Fault::outside) << astray << ' ' << p;
    }
}

TEST(PointBlocks, FindAParticleAstray) {
  expect_fault_at_every_place(1.3);
  expect_fault_at_every_place(-0.3);
  expect_fault_at_every_place(std::numeric_limits<double>::infinity());
  expect_fault_at_every_place(std::numeric_limits<double>::quiet_NaN());
}

template <class B>
void expect_sorted_by_nodes() {
  Scene<2> scene = full_scene<2>(B{}, 9, 3, Free{});
  std::mt19937 random(3);
  std::shuffle(scene.particles.x.begin(), scene.particles.x.end(), random);
  for (auto& x : scene.particles.x) x.array() += 0.01 * scene.h;  // off the places where nodes change
  const auto grid = grid_for<B, 2>(scene.lower, scene.h, scene.cells);
  ThreadPool alone(1);
  Slabs<2>(grid, B{}).sort(scene.particles, grid, alone);
  PointBlock<2, B::support> block(0);
  int last = 0;
  for (block.begin = 0; block.begin < scene.particles.size(); ++block.begin) {
    block.count = 1;
    ASSERT_EQ(evaluate_stencils(B{}, scene.particles, grid, false, block), Fault::none);
    EXPECT_LE(last, block.first[0]) << B::word;
    last = block.first[0];
  }
}

TEST(Slabs, SortParticlesByTheirNodes) {
  expect_sorted_by_nodes<Linear>();
  expect_sorted_by_nodes<BSpline2>();
  expect_sorted_by_nodes<BSpline3>();
  expect_sorted_by_nodes<BSpline2Open>();
  expect_sorted_by_nodes<Gimp>();
  expect_sorted_by_nodes<B2Gimp>();
}

TEST(Packs, ReadAndWriteEveryCountOfNumbers) {
  const auto check = []<int n>(std::integral_constant<int, n>) {
    std::array<std::array<double, n>, 4> from, to{};
    for (std::size_t lane = 0; lane < 4; ++lane)
      for (std::size_t k = 0; k < n; ++k) from[lane][k] = static_cast<double>(10 * lane + k + 1);
    std::array<Pack, n> packs;
    load_packs<n>({from[0].data(), from[1].data(), from[2].data(), from[3].data()}, packs.data());
    for (std::size_t lane = 0; lane < 4; ++lane)
      for (std::size_t k = 0; k < n; ++k) EXPECT_EQ(packs[k][lane], from[lane][k]) << n;
    store_packs<n>(packs.data(), {to[0].data(), to[1].data(), to[2].data(), to[3].data()});
    EXPECT_EQ(to, from) << n;
  };
  for_constants<9>([&](auto k) { check(std::integral_constant<int, k + 1>{}); });
}

}  // namespace mpmvv::solver::particle_pack_test
