#include <algorithm>
#include <random>

#include "solver/integrator/integrators.hpp"
#include "solver/mpm.hpp"
#include "tests/solver/scenes.hpp"

/// Particles that images complete move as they do within the whole body.
namespace mpmvv::solver::parts_test {

struct Scheme {
  std::string_view integrator;
  AnyVelocityUpdate update;
  AnyBasis basis;
  bool has_consistent_mass = false;
};

std::vector<Scheme> schemes() {
  return {{"usl", Flip{}, BSpline2{}},
          {"cd", Flip{}, CpGimp{}},
          {"usl", Flip{}, Linear{}},
          {"usl", Flip{}, Cpdi{}},
          {"usavg", Flip{FlipPosition::second_order}, BSpline3{}},
          {"usl", Flip{}, BSpline2{}, true},
          {"usl", Fmpm{4}, BSpline3{}},
          {"usavg+", Fmpm{3, 2}, BSpline2{}},
          {"usf", Xpic{5}, Cpdi{}},
          {"rk4", Flip{}, BSpline3{}},
          {"uvf", Flip{}, Gimp{}},
          {"usl+", Apic{}, B2Gimp{}}};
}

/// A thinned block of particles, some of them beyond a face. It flies on, strained and in all directions at once. Its
/// images overlap with it. As it has gaps, images give mass to many nodes that it does not reach.
template <int D>
Scene<D> block(const Scheme& scheme, Images images, const AnyBoundary& boundary) {
  Scene<D> scene = full_scene<D>(scheme.basis, 10, 1, boundary);
  scene.lower.template head<2>().setConstant(-0.5);
  scene.images = images;
  scene.material = NeoHookeanLog{30, 40};  // so soft that light nodes at its edges are no harm
  scene.integrator = scheme.integrator;
  scene.velocity_update = scheme.update;
  if (scheme.has_consistent_mass) scene.consistent_mass = ConsistentMassSettings{.tolerance = 1e-14};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> some(-1, 1);
  const auto some_vector = [&] { return Vec<D>(Vec<D>::NullaryExpr([&] { return some(random); })); };
  Index<D> count;
  count.fill(D == 2 ? 9 : 7);
  Array<Vec<D>> x;
  for (const Vec<D>& place : lattice<D>(Vec<3>(0.56 - 0.05 * count[0], -0.11, 0.4).head<D>(), scene.h / 2, count))
    if (some(random) < -0.7) x.push_back(place);
  scene.particles = particles_at<D>(x, std::pow(scene.h / 2, D));
  set_widths(scene, 0.5);
  auto& particles = scene.particles;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    particles.x[p] += 0.1 * scene.h * some_vector();
    particles.m[p] *= 1 + 0.5 * some(random);
    particles.v[p] = 4 * Vec<D>::Unit(0) + some_vector();
    particles.F[p] += 0.02 * Mat<D>::NullaryExpr([&] { return some(random); });
  }
  return scene;
}

/// The scene with all images as particles of their own, after those that it has.
template <int D>
Scene<D> whole(const Scene<D>& part) {
  Scene<D> scene = part;
  scene.images = Images::none;
  auto& all = scene.particles;
  const std::size_t n = all.size(), images = static_cast<std::size_t>(count(part.images));
  Mat<D> Q;
  for (int d = 0; d < D; ++d) Q.col(d) = next_image(part.images, Vec<D>(Vec<D>::Unit(d)));
  all.resize(images * n);
  const auto fill_up = [&](auto& field) {
    if (!field.empty()) field.resize(images * n, field.front());
  };
  fill_up(all.l), fill_up(all.l0), fill_up(all.R), fill_up(all.R0);
  for (std::size_t p = n; p < all.size(); ++p) {
    all.x[p] = Q * all.x[p - n];
    all.v[p] = Q * all.v[p - n];
    all.F[p] = Q * all.F[p - n] * Q.transpose();
    all.m[p] = all.m[p - n];
    all.V0[p] = all.V0[p - n];
  }
  return scene;
}

/// The motion after some steps, in the order of the particles' ids.
template <int D>
Motion<D> motion(const Scene<D>& scene) {
  Mpm<D> mpm(scene);
  EXPECT_EQ(mpm.advance(5e-4, 16), 16) << mpm.fault();
  const auto& particles = mpm.particles();
  Motion<D> end{particles.x, particles.v, particles.F};
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const std::size_t id = particles.id[p];
    end.x[id] = particles.x[p], end.v[id] = particles.v[p], end.F[id] = particles.F[p];
  }
  return end;
}

template <int D>
void expect_to_move_as_in_the_whole(const Scene<D>& part) {
  const Motion<D> alone = motion(part), within = motion(whole(part));
  double x = 0, v = 0, F = 0;
  for (std::size_t p = 0; p < part.particles.size(); ++p) {
    x = std::max(x, (alone.x[p] - within.x[p]).norm());
    v = std::max(v, (alone.v[p] - within.v[p]).norm());
    F = std::max(F, (alone.F[p] - within.F[p]).norm());
  }
  EXPECT_LT(x, 1e-12);
  EXPECT_LT(v, 1e-10);
  EXPECT_LT(F, 1e-11);
}

std::string_view word(const auto& any) {
  return std::visit([](const auto& own) -> std::string_view { return own.word; }, any);
}

template <int D>
void expect_of_all_schemes() {
  for (const Scheme& scheme : schemes())
    for (const AnyBoundary& boundary : {AnyBoundary(Free{}), AnyBoundary(Periodic{}), AnyBoundary(Symmetry{})})
      for (const Images images : {Images::middle, Images::diagonal, Images::quarter_turns}) {
        SCOPED_TRACE(::testing::Message()
                     << scheme.integrator << " with " << word(scheme.update) << " and " << word(scheme.basis)
                     << ", faces " << word(boundary) << ", images " << static_cast<int>(images));
        expect_to_move_as_in_the_whole(block<D>(scheme, images, boundary));
      }
}

TEST(Parts, MoveAsWithinTheWholeBodyInThePlane) {
  expect_of_all_schemes<2>();
}
TEST(Parts, MoveAsWithinTheWholeBodyInSpace) {
  expect_of_all_schemes<3>();
}

}  // namespace mpmvv::solver::parts_test
