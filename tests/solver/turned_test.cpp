#include <algorithm>
#include <deque>
#include <span>

#include "solver/integrator/integrators.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

/// The solver knows no direction: a scene that is turned, turned round or continued along a third axis moves as the
/// scene itself, whatever its faces are.
namespace mpmvv::solver::turned_test {

/// A wall that accelerates.
struct Drive final : WallMotion {
  double x0, v0, half_a;

  Drive(double x, double v, double c) : x0(x), v0(v), half_a(c) {}
  double position(double t) const override { return x0 + v0 * t + half_a * t * t; }
  double velocity(double t) const override { return v0 + 2 * half_a * t; }
  double gradient(double t) const override { return 5 + 100 * t; }
};

struct Scheme {
  std::string_view integrator;
  AnyVelocityUpdate update;
  AnyBasis basis;
  WallMethod walls = WallMethod::combined;
  bool has_consistent_mass = false;
};

std::vector<Scheme> schemes() {
  return {{"usl", Flip{}, BSpline2{}},
          {"usavg", Flip{FlipPosition::second_order}, CpGimp{}},
          {"usl", Flip{}, BSpline2{}, WallMethod::combined, true},
          {"usl", Fmpm(2), BSpline2{}, WallMethod::combined, true},
          {"rk4", Flip{}, BSpline3{}},
          {"uvf", Flip{}, B2Gimp{}},
          {"usl+", Apic{}, BSpline2{}},
          {"usf", Xpic{2}, Cpdi{}, WallMethod::lumped},
          {"usavg+", Fmpm{3}, BSpline3{}, WallMethod::elimination},
          {"usl+", Fmpm{2, 2}, B2Cpdi{}, WallMethod::velocity}};
}

/// Whether the scheme goes with the faces, of which not every scheme takes walls.
bool takes(const Scheme& scheme, const auto& faces) {
  const auto is_wall = [](const AnyBoundary& face) { return std::holds_alternative<Wall>(face); };
  const bool takes_walls = integrator_named(scheme.integrator).has_whole_steps() &&
                           !(scheme.has_consistent_mass && adds_accelerations(scheme.update));
  return takes_walls || std::ranges::none_of(faces, is_wall);
}

/// One tenth of a metre to a cell, two particles along each axis of a cell, off its middle. Strained, and in a motion
/// that is none of symmetry and takes particles out of the domain.
template <int D>
Scene<D> box(const Scheme& scheme, const Index<D>& cells, const std::array<AnyBoundary, 2 * D>& faces) {
  Scene<D> scene = full_scene<D>(scheme.basis, 10, 2);
  scene.cells = cells;
  scene.lower = Vec<3>(0, -0.7, 0.4).head<D>();
  scene.boundary = faces;
  scene.integrator = scheme.integrator;
  scene.velocity_update = scheme.update;
  scene.wall_method = scheme.walls;
  if (scheme.has_consistent_mass) scene.consistent_mass = ConsistentMassSettings{.tolerance = 1e-13};
  Index<D> count = cells;
  for (int& n : count) n *= 2;
  const Vec<D> corner = scene.lower + scene.h * Vec<D>(Vec<3>(0.013, -0.021, 0.017).head<D>());
  scene.particles = particles_at<D>(lattice<D>(corner, scene.h / 2, count), std::pow(scene.h / 2, D));
  set_widths(scene, 0.5);
  for (std::size_t p = 0; p < scene.particles.size(); ++p)
    for (int d = 0; d < D; ++d) {
      const Vec<D>& x = scene.particles.x[p];
      scene.particles.v[p][d] = 15 * std::sin(1 + 2 * d + (3 + d) * x[0] - 4 * x[1] + (D == 3 ? 5 * x[D - 1] : 0));
      for (int e = 0; e < D; ++e) scene.particles.F[p](d, e) += 0.01 * (1 + 2 * d - 3 * e);
    }
  return scene;
}

/// The particles after some steps, in the order of their creation.
template <int D>
Particles<D> moved(const Scene<D>& scene) {
  Mpm<D> mpm(scene);
  for (int k = 0; k < 12; ++k) EXPECT_TRUE(mpm.step(2e-4)) << mpm.fault();
  Particles<D> particles = mpm.particles();
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const std::size_t id = mpm.particles().id[p];
    particles.x[id] = mpm.particles().x[p];
    particles.v[id] = mpm.particles().v[p];
    particles.F[id] = mpm.particles().F[p];
  }
  return particles;
}

template <int D>
double size_of(const Scene<D>& scene, int d) {
  return scene.h * scene.cells[static_cast<std::size_t>(d)];
}

/// What is along axis d comes along axis[d], from the other end where it is turned round.
template <int D>
struct Turn {
  Index<D> axis;
  std::array<bool, D> round;

  Mat<D> matrix() const {
    Mat<D> Q = Mat<D>::Zero();
    for (std::size_t d = 0; d < D; ++d) Q(axis[d], static_cast<int>(d)) = round[d] ? -1 : 1;
    return Q;
  }
  Vec<D> operator()(const Vec<D>& x, const Scene<D>& scene) const {
    Vec<D> y;
    for (int d = 0; d < D; ++d) {
      const auto axis_d = static_cast<std::size_t>(d);
      y[axis[axis_d]] = round[axis_d] ? 2 * scene.lower[d] + size_of(scene, d) - x[d] : x[d];
    }
    return y;
  }
};

template <int D>
Scene<D> turned(const Scene<D>& scene, const Turn<D>& turn, std::deque<Drive>& walls) {
  Scene<D> other = scene;
  for (std::size_t d = 0; d < D; ++d) {
    const auto to = static_cast<std::size_t>(turn.axis[d]);
    other.cells[to] = scene.cells[d];
    other.lower[turn.axis[d]] = scene.lower[static_cast<int>(d)];
    for (const std::size_t upper : {0, 1}) {
      AnyBoundary& face = other.boundary[2 * to + (turn.round[d] ? 1 - upper : upper)];
      face = scene.boundary[2 * d + upper];
      if (auto* wall = std::get_if<Wall>(&face); wall && turn.round[d]) {
        const auto& drive = dynamic_cast<const Drive&>(*wall->motion);
        walls.emplace_back(2 * scene.lower[static_cast<int>(d)] + size_of(scene, static_cast<int>(d)) - drive.x0,
                           -drive.v0, -drive.half_a);
        wall->motion = &walls.back();
      }
    }
  }
  const Mat<D> Q = turn.matrix();
  for (std::size_t p = 0; p < scene.particles.size(); ++p) {
    other.particles.x[p] = turn(scene.particles.x[p], scene);
    other.particles.v[p] = Q * scene.particles.v[p];
    other.particles.F[p] = Q * scene.particles.F[p] * Q.transpose();
  }
  return other;
}

template <int D>
void expect_no_direction(const Scene<D>& scene, const std::vector<Turn<D>>& turns, const std::string& what) {
  const Particles<D> plain = moved(scene);
  for (const Turn<D>& turn : turns) {
    std::deque<Drive> walls;
    const Particles<D> other = moved(turned(scene, turn, walls));
    const Mat<D> Q = turn.matrix();
    double x = 0, v = 0, F = 0;
    for (std::size_t p = 0; p < plain.size(); ++p) {
      x = std::max(x, (other.x[p] - turn(plain.x[p], scene)).norm());
      v = std::max(v, (other.v[p] - Q * plain.v[p]).norm());
      F = std::max(F, (other.F[p] - Q * plain.F[p] * Q.transpose()).norm());
    }
    EXPECT_LT(x, 1e-12) << what << ", turned by\n" << Q;
    EXPECT_LT(v, 1e-9) << what << ", turned by\n" << Q;
    EXPECT_LT(F, 1e-11) << what << ", turned by\n" << Q;
  }
}

const Drive inward(0, 15, 2000), ahead(0.6, 10, -3000);
const Periodic periodic;

/// The faces of a box of 6 by 5 cells: xmin, xmax, ymin, ymax.
std::vector<std::array<AnyBoundary, 4>> mixed_faces() {
  const Wall left{&inward, 1, WallGradient::given}, right{&ahead, 1.5, WallGradient::estimated};
  return {{Free{}, Dirichlet{}, periodic, periodic},
          {Mirror{}, Symmetry{}, periodic, periodic},
          {left, right, Mirror{}, Free{}},
          {left, Mirror{}, Dirichlet{}, Symmetry{}}};
}

TEST(Turned, PlaneScenesMoveAlike) {
  std::vector<Turn<2>> turns;
  for (const Index<2>& axis : {Index<2>{0, 1}, Index<2>{1, 0}})
    for (const bool x : {false, true})
      for (const bool y : {false, true}) turns.push_back({axis, {x, y}});
  for (const Scheme& scheme : schemes())
    for (std::size_t k = 0; k < mixed_faces().size(); ++k)
      if (takes(scheme, mixed_faces()[k]))
        expect_no_direction(box<2>(scheme, {6, 5}, mixed_faces()[k]), turns,
                            std::string(scheme.integrator) + ", faces " + std::to_string(k));
}

/// An open knot vector takes no periodic faces, mirrors or walls in motion, and has no nodes beyond a free one.
TEST(Turned, ScenesBetweenOpenKnotsMoveAlike) {
  const std::vector<Turn<2>> turns{{{0, 1}, {true, false}}, {{1, 0}, {false, true}}, {{1, 0}, {true, true}}};
  for (const AnyBasis& basis : {AnyBasis{BSpline2Open{}}, AnyBasis{BSpline3Open{}}})
    for (const bool has_consistent_mass : {false, true})
      expect_no_direction(box<2>({"usl", Flip{}, basis, WallMethod::combined, has_consistent_mass}, {6, 5},
                                 {Symmetry{}, Dirichlet{}, Symmetry{}, Symmetry{}}),
                          turns, "open knots");
}

TEST(Turned, NodesLieByTheCellsOfTheirOwnAxis) {
  const Mpm<2> mpm(box<2>({"usl", Flip{}, BSpline3Open{}}, {6, 4}, {Symmetry{}, Symmetry{}, Symmetry{}, Symmetry{}}));
  const Grid<2>& grid = mpm.grid();
  for (std::size_t n = 0; n < grid.size(); ++n)
    for (int d = 0; d < 2; ++d) {
      const auto axis = static_cast<std::size_t>(d);
      const double cells = BSpline3Open::position(grid.index(n)[axis], grid.cells()[d]);
      EXPECT_DOUBLE_EQ(mpm.node_position(n)[d], grid.lower()[d] + grid.h() * cells);
    }
}

/// A body force that is the place itself, and grows with time.
struct Place final : BodyForce<2> {
  void on_particles(double, std::span<const std::uint32_t>, std::span<const Vec<2>>, Vec<2>*) const override {}
  Vec<2> at_position(const Vec<2>& x, double t) const override { return (1 + 1000 * t) * x; }
};

TEST(Turned, BodyForcesOnTheGridAreThoseOfItsPlacesAndTime) {
  Scene<2> scene = box<2>({"usl", Flip{}, BSpline2{}}, {6, 5}, {Free{}, Free{}, Free{}, Free{}});
  scene.material = NeoHookeanLog{};  // without stiffness
  Place place;
  scene.body_force = &place;
  scene.body_force_on = BodyForceOn::grid;
  Mpm<2> mpm(scene);
  for (int k = 0; k < 3; ++k) {
    mpm.map_acceleration();
    int accelerated = 0;
    for (std::size_t n = 0; n < mpm.grid().size(); ++n)
      if (mpm.is_accelerated(n)) {
        EXPECT_LT((mpm.grid().a[n] - (1 + 1000 * mpm.time()) * mpm.node_position(n)).norm(), 1e-12) << k;
        ++accelerated;
      }
    EXPECT_GT(accelerated, 40);
    ASSERT_TRUE(mpm.step(2e-4)) << mpm.fault();
  }
}

TEST(Turned, ScenesInSpaceMoveAlike) {
  const std::vector<Turn<3>> turns{{{1, 2, 0}, {}}, {{2, 0, 1}, {true, false, true}}, {{1, 0, 2}, {false, true, true}}};
  const Wall left{&inward, 1, WallGradient::estimated};
  const std::vector<std::array<AnyBoundary, 6>> mixed{{left, Free{}, periodic, periodic, Mirror{}, Dirichlet{}},
                                                      {periodic, periodic, periodic, periodic, Symmetry{}, Mirror{}}};
  for (const Scheme& scheme : schemes())
    for (std::size_t k = 0; k < mixed.size(); ++k)
      if (takes(scheme, mixed[k]))
        expect_no_direction(box<3>(scheme, {6, 5, 4}, mixed[k]), turns,
                            std::string(scheme.integrator) + ", faces " + std::to_string(k));
}

/// The scene continued along z, by layers of particles between these faces.
Scene<3> continued(const Scene<2>& plane, const AnyBoundary& face) {
  constexpr int cells = 3;
  Scene<3> scene = full_scene<3>(plane.basis, 10, 2);
  scene.cells = {plane.cells[0], plane.cells[1], cells};
  scene.lower.head<2>() = plane.lower;
  std::copy(plane.boundary.begin(), plane.boundary.end(), scene.boundary.begin());
  scene.boundary[4] = scene.boundary[5] = face;
  scene.integrator = plane.integrator;
  scene.velocity_update = plane.velocity_update;
  scene.wall_method = plane.wall_method;
  scene.consistent_mass = plane.consistent_mass;
  Array<Vec<3>> x;
  for (int layer = 0; layer < 2 * cells; ++layer)
    for (const Vec<2>& of_plane : plane.particles.x)
      x.emplace_back(of_plane[0], of_plane[1], plane.h / 2 * (layer + 0.5));
  scene.particles = particles_at<3>(x, std::pow(plane.h / 2, 3));
  set_widths(scene, 0.5);
  for (std::size_t p = 0; p < x.size(); ++p) {
    const std::size_t of_plane = p % plane.particles.size();
    scene.particles.v[p].head<2>() = plane.particles.v[of_plane];
    scene.particles.F[p].topLeftCorner<2, 2>() = plane.particles.F[of_plane];
  }
  return scene;
}

TEST(Turned, PlaneScenesContinueIntoSpace) {
  for (const Scheme& scheme : schemes())
    for (std::size_t k = 0; k < mixed_faces().size(); ++k) {
      if (!takes(scheme, mixed_faces()[k])) continue;
      const Scene<2> scene = box<2>(scheme, {6, 5}, mixed_faces()[k]);
      const Particles<2> plane = moved(scene);
      for (const AnyBoundary& face : {AnyBoundary{periodic}, AnyBoundary{Mirror{}}}) {
        if (scheme.has_consistent_mass) continue;  // its iterations grow what round-off there is along z
        const Particles<3> space = moved(continued(scene, face));
        double x = 0, v = 0, F = 0;
        for (std::size_t p = 0; p < space.size(); ++p) {
          const std::size_t of_plane = p % plane.size();
          x = std::max(x, (space.x[p].head<2>() - plane.x[of_plane]).norm());
          v = std::max(v, (space.v[p].head<2>() - plane.v[of_plane]).norm() + std::abs(space.v[p][2]));
          F = std::max(F, (space.F[p].topLeftCorner<2, 2>() - plane.F[of_plane]).norm());
        }
        EXPECT_LT(x, 1e-12) << scheme.integrator << ", faces " << k << ", " << face.index();
        EXPECT_LT(v, 1e-9) << scheme.integrator << ", faces " << k << ", " << face.index();
        EXPECT_LT(F, 1e-11) << scheme.integrator << ", faces " << k << ", " << face.index();
      }
    }
}

}  // namespace mpmvv::solver::turned_test
