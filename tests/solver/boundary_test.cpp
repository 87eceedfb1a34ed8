#include <bitset>
#include <map>
#include <random>

#include "tests/solver/each_basis.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::boundary_test {

/// A grid of 6 x 5 cells with two ghost layers, every field random.
Grid<2> random_grid() {
  Grid<2> grid(Vec<2>::Zero(), 1, {6, 5}, 1, 2);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-1, 1);
  for (auto& p : grid.p) p = padded<2>(Vec<2>(value(random), value(random)), 2 + value(random));
  for (auto& v : grid.v) v = Vec<2>(value(random), value(random));
  return grid;
}

constexpr std::array<Face, 4> faces{Face{0, false}, Face{0, true}, Face{1, false}, Face{1, true}};

/// Calls visit(i, j, n) for every node.
template <class Visit>
void for_all(const Grid<2>& grid, const Visit& visit) {
  for (int j = -2; j < grid.inside(1) + 2; ++j)
    for (int i = -2; i < grid.inside(0) + 2; ++i) visit(i, j, static_cast<std::size_t>(grid.node({i, j})));
}

/// Calls visit(axes) for every choice of axes, none left out but the empty one.
template <int D, class Visit>
void for_choices_of_axes(const Visit& visit) {
  for (unsigned long choice = 1; choice < 1U << D; ++choice) visit(std::bitset<D>(choice));
}

/// Along the axes folded, and along no other, a node has the sum over its images, those beyond edges and corners too.
template <int D>
void expect_sums_of_images(const Index<D>& cells) {
  for_choices_of_axes<D>([&](const std::bitset<D>& periodic) {
    Grid<D> grid(Vec<D>::Zero(), 1, cells, 1, 2);
    std::mt19937 random(1);
    for (auto& p : grid.p) p = padded_alone<D>(std::uniform_real_distribution<double>(1, 3)(random));
    const auto mapped = grid.p;
    std::map<Index<D>, double> sums;
    const auto place = [&](std::size_t n) {
      Index<D> i = grid.index(n);
      for (std::size_t d = 0; d < D; ++d)
        if (periodic[d]) i[d] = (i[d] + 2 * cells[d]) % cells[d];
      return i;
    };
    for (std::size_t n = 0; n < grid.size(); ++n) sums[place(n)] += mapped[n][D];
    for (int d = 0; d < D; ++d)
      for (const bool upper : {false, true})
        if (periodic[static_cast<std::size_t>(d)]) Periodic{}.sum_images(grid, {d, upper}, grid.p);
    for (std::size_t n = 0; n < grid.size(); ++n) EXPECT_NEAR(grid.m(n), sums[place(n)], 1e-13) << periodic << " " << n;
  });
}

TEST(PeriodicBoundary, ImagesCarryTheSumOfOnePeriod) {
  expect_sums_of_images<1>({6});
  expect_sums_of_images<2>({6, 5});
  expect_sums_of_images<3>({4, 3, 5});
}

/// A lone particle that leaves through a corner comes back along the axes that are periodic, and along no other.
template <int D>
void expect_wrapping(std::string_view integrator) {
  for_choices_of_axes<D>([&](const std::bitset<D>& periodic) {
    for (const bool upward : {false, true}) {
      Scene<D> scene = full_scene<D>(BSpline2{}, 4, 1, Free{});
      for (std::size_t d = 0; d < D; ++d)
        if (periodic[d]) scene.boundary[2 * d] = scene.boundary[2 * d + 1] = Periodic{};
      const double start = upward ? 0.975 : 0.025, v = upward ? 1 : -1, end = start + 0.125 * v;
      scene.particles = particles_at<D>({Vec<D>::Constant(start)}, std::pow(scene.h, D));
      scene.particles.v[0].setConstant(v);
      scene.integrator = integrator;
      Mpm<D> mpm(scene);
      ASSERT_TRUE(mpm.step(0.125)) << mpm.fault();
      for (int d = 0; d < D; ++d)
        EXPECT_NEAR(mpm.particles().x[0][d], periodic[static_cast<std::size_t>(d)] ? end - v : end, 1e-14)
            << integrator << " " << periodic << " " << d;
    }
  });
}

TEST(PeriodicBoundary, BringsBackAlongItsOwnAxisAlone) {
  for (const auto integrator : integrator_words()) {
    expect_wrapping<1>(integrator);
    expect_wrapping<2>(integrator);
    expect_wrapping<3>(integrator);
  }
}

TEST(PeriodicBoundary, OneCellIsOneNode) {
  Grid<1> grid(Vec<1>::Zero(), 1, {1}, 1, 2);
  std::fill(grid.v.begin(), grid.v.end(), Padded<1>(1));
  Periodic{}.sum_images(grid, {0, false}, grid.v);
  for (const auto& v : grid.v) EXPECT_EQ(v[0], 6);
}

TEST(DirichletBoundary, HoldsEveryComponentOnTheFaceAndBeyond) {
  Grid<2> grid = random_grid();
  const auto before = grid.v;
  Dirichlet{}.constrain(grid, {1, true}, grid.v);
  for_all(grid, [&](int, int j, std::size_t n) { EXPECT_EQ(grid.v[n], j < 5 ? before[n] : Vec<2>::Zero().eval()); });
}

TEST(SymmetryBoundary, TurnsTheNormalComponentOnly) {
  for (const Face face : faces) {
    Grid<2> grid = random_grid();
    const auto before = grid.v;
    Symmetry{}.constrain(grid, face, grid.v);
    const int plane = face.upper ? grid.cells()[static_cast<std::size_t>(face.axis)] : 0;
    for_all(grid, [&](int i, int j, std::size_t n) {
      const auto axis = static_cast<std::size_t>(face.axis);
      Index<2> image{i, j};
      const int beyond = (image[axis] - plane) * (face.upper ? 1 : -1);
      image[axis] = 2 * plane - image[axis];
      const double inside = beyond > 0 ? grid.v[static_cast<std::size_t>(grid.node(image))][face.axis] : 0;
      EXPECT_EQ(grid.v[n][face.axis], beyond < 0 ? before[n][face.axis] : -inside);
      EXPECT_EQ(grid.v[n][1 - face.axis], before[n][1 - face.axis]);
    });
  }
}

TEST(MirrorBoundary, FoldsCornersOnce) {
  Grid<2> grid = random_grid();
  const auto mapped = grid.p;
  const auto mass = [&mapped](std::size_t n) { return mapped[n][2]; };
  const auto momentum = [&mapped](std::size_t n) { return Vec<2>(mapped[n].head<2>()); };
  for (const Face face : {faces[0], faces[2]}) Mirror{}.sum_images(grid, face, grid.p);
  const auto at = [&grid](int i, int j) { return static_cast<std::size_t>(grid.node({i, j})); };
  const auto flipped = [](Vec<2> v, double x, double y) { return Vec<2>(x * v[0], y * v[1]); };
  for (int i : {1, 2})
    for (int j : {1, 2}) {
      EXPECT_NEAR(grid.m(at(i, j)), mass(at(i, j)) + mass(at(-i, j)) + mass(at(i, -j)) + mass(at(-i, -j)), 1e-14);
      const Vec<2> sum = momentum(at(i, j)) + flipped(momentum(at(-i, j)), -1, 1) +
                         flipped(momentum(at(i, -j)), 1, -1) + flipped(momentum(at(-i, -j)), -1, -1);
      EXPECT_LT((grid.p[at(i, j)].head<2>() - sum).norm(), 1e-14);
      EXPECT_LT((grid.p[at(-i, -j)].head<2>() + sum).norm(), 1e-14);
      EXPECT_LT((grid.p[at(-i, j)].head<2>() - flipped(sum, -1, 1)).norm(), 1e-14);
    }
  for (int i = 1; i < 3; ++i)
    EXPECT_NEAR(grid.m(at(0, i)), 2 * (mass(at(0, i)) + mass(at(0, -i))), 1e-14) << "its own image";
  for (int i = -2; i < 4; ++i) {
    EXPECT_EQ(grid.p[at(0, i)].head<2>()[0], 0);
    EXPECT_EQ(grid.p[at(i, 0)].head<2>()[1], 0);
  }
}

/// A body symmetric about the planes through the origin, alone in a wide domain; or its part beyond `planes` of them,
/// ended there by `boundary`.
template <int D>
Scene<D> symmetric_body(const AnyBasis& basis, int planes, const AnyBoundary& boundary) {
  Scene<D> scene;
  scene.h = 0.125;
  scene.basis = basis;
  scene.material = NeoHookeanLog{3000, 4000};
  scene.boundary.fill(Free{});
  Vec<D> corner = Vec<D>::Constant(-0.5);
  Index<D> count;
  for (std::size_t d = 0; d < D; ++d) {
    const bool cut = static_cast<int>(d) < planes;
    scene.cells[d] = cut ? 8 : 16;
    scene.lower[static_cast<int>(d)] = cut ? 0 : -1;
    corner[static_cast<int>(d)] = cut ? 0 : -0.5;
    count[d] = cut ? 8 : 16;
    if (cut) scene.boundary[2 * d] = boundary;
  }
  scene.particles = particles_at<D>(lattice<D>(corner, scene.h / 2, count), std::pow(scene.h / 2, D));
  set_widths(scene, 0.5);
  for (std::size_t p = 0; p < scene.particles.size(); ++p) {
    const Vec<D>& x = scene.particles.x[p];
    for (int d = 0; d < D; ++d) scene.particles.v[p][d] = 6 * std::sin(3 * x[d]) * (1 + x.squaredNorm() - x[d] * x[d]);
  }
  return scene;
}

/// Runs both bodies and compares the particles that started at the same place.
template <int D>
void expect_the_same_motion(Scene<D> whole, Scene<D> part, std::string_view integrator) {
  whole.integrator = part.integrator = integrator;
  const auto start = part.particles.x;
  const auto whole_start = whole.particles.x;
  Mpm<D> a(std::move(whole)), b(std::move(part));
  for (int k = 0; k < 60; ++k) ASSERT_TRUE(a.step(2e-4) && b.step(2e-4)) << a.fault() << b.fault();
  EXPECT_GT(a.strain_energy(), 0.01);
  std::size_t compared = 0;
  for (std::size_t q = 0; q < b.particles().size(); ++q)
    for (std::size_t p = 0; p < a.particles().size(); ++p) {
      if (whole_start[a.particles().id[p]] != start[b.particles().id[q]]) continue;
      ++compared;
      EXPECT_LT((a.particles().x[p] - b.particles().x[q]).norm(), 1e-13);
      EXPECT_LT((a.particles().v[p] - b.particles().v[q]).norm(), 1e-10);
      EXPECT_LT((a.particles().F[p] - b.particles().F[q]).norm(), 1e-11);
    }
  EXPECT_EQ(compared, b.particles().size());
}

class MirroredBody : public WithEachBasis {};
INSTANTIATE_TEST_SUITE_P(, MirroredBody, every_basis(), word_in_name);

TEST_P(MirroredBody, MovesAsTheWholeBodyDoes) {
  if (has_open_knots) GTEST_SKIP() << "an open-knot basis has no mirror";
  for (const auto integrator : integrator_words()) {
    expect_the_same_motion(symmetric_body<1>(basis, 0, Free{}), symmetric_body<1>(basis, 1, Mirror{}), integrator);
    for (const int planes : {1, 2})  // half of it, and a quarter with its corner
      expect_the_same_motion(symmetric_body<2>(basis, 0, Free{}), symmetric_body<2>(basis, planes, Mirror{}),
                             integrator);
  }
}

TEST_P(MirroredBody, MovesAsTheWholeBodyDoesWithTheConsistentMass) {
  if (has_open_knots) GTEST_SKIP() << "an open-knot basis has no mirror";
  const auto consistent = [](auto scene) {
    scene.consistent_mass =
        ConsistentMassSettings{.tolerance = 1e-13};  // iterates differ by round-off, what they converge to does not
    return scene;
  };
  expect_the_same_motion(consistent(symmetric_body<1>(basis, 0, Free{})),
                         consistent(symmetric_body<1>(basis, 1, Mirror{})), "usl");
  expect_the_same_motion(consistent(symmetric_body<2>(basis, 0, Free{})),
                         consistent(symmetric_body<2>(basis, 2, Mirror{})), "usl");
}

/// A standing wave with a wall every `half` cells: the periodic box, or the part between two walls.
template <int D>
Scene<D> standing_wave(const AnyBasis& basis, int half, int cells, const AnyBoundary& boundary) {
  Scene<D> scene = full_scene<D>(basis, 2 * half, 2, boundary);
  scene.cells.fill(cells);
  Index<D> count;
  count.fill(2 * cells);
  scene.particles = particles_at<D>(lattice<D>(scene.lower, scene.h / 2, count), std::pow(scene.h / 2, D));
  set_widths(scene, 0.5);
  for (std::size_t p = 0; p < scene.particles.size(); ++p)
    for (int d = 0; d < D; ++d) scene.particles.v[p][d] = 6 * std::sin(2 * M_PI * scene.particles.x[p][d]);
  return with_consistent_mass(scene);
}

TEST_P(MirroredBody, IsHalfAPeriodWithTheConsistentMass) {
  if (has_open_knots) GTEST_SKIP() << "an open-knot basis has no mirror";
  const int half = 2 * std::max(ghosts_of(basis), 3) + 2;
  const auto body = [&]<int D>(const AnyBoundary& boundary, std::integral_constant<int, D>) {
    return standing_wave<D>(basis, half, boundary.index() == 0 ? 2 * half : half, boundary);
  };
  const std::integral_constant<int, 1> line;
  const std::integral_constant<int, 2> plane;
  for (const auto integrator : {"usl", "rk4"})
    expect_the_same_motion(body(Periodic{}, line), body(Mirror{}, line), integrator);
  expect_the_same_motion(body(Periodic{}, plane), body(Mirror{}, plane), "usl");
}

TEST(SymmetryBoundary, IsAMirrorForTheLinearBasis) {  // whose particles reach no ghost
  for (const auto integrator : integrator_words())
    for (const int planes : {1, 2})
      expect_the_same_motion(symmetric_body<2>(Linear{}, 0, Free{}), symmetric_body<2>(Linear{}, planes, Symmetry{}),
                             integrator);
  expect_the_same_motion(with_consistent_mass(symmetric_body<2>(Linear{}, 0, Free{})),
                         with_consistent_mass(symmetric_body<2>(Linear{}, 2, Symmetry{})), "usl");
}

TEST(WallAcceleration, IsZeroOrTheDifferenceOfVelocities) {  // S (30)
  for (const bool difference : {false, true}) {
    Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2, Dirichlet{});
    for (auto& v : scene.particles.v) v[0] = 2;
    scene.difference_acceleration = difference;
    Mpm<1> mpm(scene);
    const double dt = 1e-4;
    ASSERT_TRUE(mpm.step(dt));
    for (const int node : {-1, 0, 8, 9}) {
      const auto n = static_cast<std::size_t>(mpm.grid().node({node}));
      EXPECT_NEAR(mpm.grid().a[n][0], difference ? -2 / dt : 0, 1e-8);
      EXPECT_EQ(mpm.grid().v[n][0], 0);
    }
  }
}

}  // namespace mpmvv::solver::boundary_test
