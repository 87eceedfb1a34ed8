#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::time_order_test {

/// A force that changes within a step.
class Swing final : public BodyForce<1> {
 public:
  explicit Swing(const Array<Vec<1>>& X) : X_(X) {}
  void on_particles(double t, std::span<const std::uint32_t> ids, std::span<const Vec<1>>, Vec<1>* b) const override {
    for (const auto id : ids) *b++ = at_position(X_[id], t);
  }
  Vec<1> at_position(const Vec<1>& x, double t) const override {
    return Vec<1>(1500 * std::sin(2 * M_PI * x[0]) * std::cos(900 * t));
  }

 private:
  Array<Vec<1>> X_;
};

constexpr double end_time = 0.004;  // s, two fifths of the wave's period

/// The wave in a periodic bar of cubic B-splines, so small that no particle reaches a knot: between knots the rates of
/// the semi-discrete system are smooth, and a fixed grid shows the order in time alone.
Particles<1> bar_at_end(std::string_view integrator, int steps, int cells = 8,
                        const std::optional<ConsistentMassSettings>& consistent_mass = {}) {
  Scene<1> scene = full_scene<1>(BSpline3{}, cells, 2);
  scene.consistent_mass = consistent_mass;
  set_wave(scene, 3);
  const auto X = scene.particles.x;
  Swing force(X);
  scene.body_force = &force;
  scene.integrator = integrator;
  scene.half_start = integrator_named(integrator).is_staggered;
  Mpm<1> mpm(scene);
  double farthest = 0;
  for (int k = 0; k < steps; ++k) {
    EXPECT_TRUE(mpm.step(end_time / steps)) << mpm.fault();
    for (std::size_t p = 0; p < X.size(); ++p)
      farthest = std::max(farthest, std::abs(mpm.particles().x[p][0] - X[mpm.particles().id[p]][0]));
  }
  EXPECT_LT(farthest, scene.h / 4);
  return mpm.particles();
}

/// Largest difference of position (in wave lengths) and F; a staggered velocity is that of another time.
double distance(const Particles<1>& a, const Particles<1>& b) {
  double largest = 0;
  for (std::size_t p = 0; p < a.size(); ++p)
    largest = std::max({largest, (a.x[p] - b.x[p]).norm(), (a.F[p] - b.F[p]).norm()});
  return largest;
}

double order_between(std::string_view integrator, int steps, const Particles<1>& limit) {
  return std::log2(distance(bar_at_end(integrator, steps), limit) / distance(bar_at_end(integrator, 2 * steps), limit));
}

TEST(TimeOrder, RungeKuttaIsOfFourthOrder) {
  const auto limit = bar_at_end("rk4", 2048);
  for (const int steps : {64, 128}) EXPECT_NEAR(order_between("rk4", steps, limit), 4, 0.25) << steps;
}

TEST(TimeOrder, OnAFixedGridAllOthersAreOfFirstOrderAndTendToTheSame) {
  const auto limit = bar_at_end("rk4", 2048);
  for (const auto integrator : integrator_words())
    if (integrator != "rk4") {
      EXPECT_NEAR(order_between(integrator, 2048, limit), 1, 0.05) << integrator;
    }
}

/// The first-order term of `cd` is what the round trip between particles and grid filters out, of second order in h:
/// refined together with the grid it is of third, and the second-order term of the central difference is left.
TEST(TimeOrder, CentralDifferenceIsOfSecondOrderWhenRefinedWithTheGrid) {
  const auto error = [](std::string_view integrator, int steps, int cells) {
    return distance(bar_at_end(integrator, steps, cells), bar_at_end("rk4", 512, cells));
  };
  EXPECT_GT(std::log2(error("cd", 256, 8) / error("cd", 256, 16)), 1.7);  // the term itself
  EXPECT_GT(std::log2(error("cd", 24, 8) / error("cd", 48, 16)), 2);
  EXPECT_GT(std::log2(error("cd", 48, 16) / error("cd", 96, 32)), 2);
  EXPECT_LT(std::log2(error("usl", 48, 16) / error("usl", 96, 32)), 1);
}

Particles<1> consistent_bar_at_end(std::string_view integrator, int steps) {
  return bar_at_end(integrator, steps, 8, unregularised);
}

TEST(TimeOrder, RungeKuttaIsOfFourthOrderWithTheConsistentMass) {
  const auto limit = consistent_bar_at_end("rk4", 1024);
  const auto error = [&limit](int steps) { return distance(consistent_bar_at_end("rk4", steps), limit); };
  for (const int steps : {64, 128}) EXPECT_NEAR(std::log2(error(steps) / error(2 * steps)), 4, 0.1) << steps;
}

/// M⁻¹ SᵀM S = I: what is mapped from the updated particles is what they were updated by. So it makes no difference
/// to map it anew, and of the first-order term of `cd` only what `uvf` has as well is left.
TEST(TimeOrder, NothingIsFilteredByTheConsistentMass) {
  for (const auto& [mapped_once, mapped_anew] : {std::pair{"usl", "usl+"}, {"usavg", "usavg+"}, {"cd", "uvf"}})
    EXPECT_LT(distance(consistent_bar_at_end(mapped_once, 64), consistent_bar_at_end(mapped_anew, 64)), 1e-11)
        << mapped_once;
  const auto lumped = distance(bar_at_end("cd", 256), bar_at_end("rk4", 512));
  const auto consistent = distance(consistent_bar_at_end("cd", 256), consistent_bar_at_end("rk4", 512));
  EXPECT_LT(consistent, lumped / 100);
}

}  // namespace mpmvv::solver::time_order_test
