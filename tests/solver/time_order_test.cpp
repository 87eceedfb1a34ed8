#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace mpmvv::solver {

namespace {

/// A force that changes within a step.
class Swing final : public BodyForce<1> {
 public:
  explicit Swing(const std::vector<Vec<1>>& X) : X_(X) {}
  void on_particles(double t, std::span<const std::uint32_t> ids, Vec<1>* b) const override {
    for (const auto id : ids) *b++ = at_position(X_[id], t);
  }
  Vec<1> at_position(const Vec<1>& x, double t) const override {
    return Vec<1>(2000 * std::sin(2 * M_PI * x[0]) * std::cos(900 * t));
  }

 private:
  std::vector<Vec<1>> X_;
};

constexpr double end_time = 0.004;  // s, two fifths of the wave's period

/// The wave in a periodic bar of cubic B-splines, so small that no particle reaches a knot: between knots the rates of
/// the semi-discrete system are smooth, and a fixed grid shows the order in time alone.
Particles<1> bar_at_end(std::string_view integrator, int steps) {
  Scene<1> scene = full_scene<1>(BSpline3{}, 8, 2);
  set_wave(scene, 4);
  const auto X = scene.particles.x;
  const Swing force(X);
  scene.body_force = &force;
  scene.integrator = integrator;
  scene.half_start = integrator == "cd";
  Mpm<1> mpm(scene);
  for (int k = 0; k < steps; ++k) {
    EXPECT_TRUE(mpm.step(end_time / steps)) << mpm.fault();
    for (std::size_t p = 0; p < X.size(); ++p)
      EXPECT_LT(std::abs(mpm.particles().x[p][0] - X[mpm.particles().id[p]][0]), scene.h / 4);
  }
  return mpm.particles();
}

/// Largest difference of position (in wave lengths) and F; velocities of `cd` are those of another time.
double distance(const Particles<1>& a, const Particles<1>& b) {
  double largest = 0;
  for (std::size_t p = 0; p < a.size(); ++p)
    largest = std::max({largest, (a.x[p] - b.x[p]).norm(), (a.F[p] - b.F[p]).norm()});
  return largest;
}

TEST(TimeOrder, X) {
  const auto limit = bar_at_end("rk4", 2048);
  for (const auto i : integrator_words()) {
    double last = 0;
    for (int n = 16; n <= 1024; n *= 2) {
      const double e = distance(bar_at_end(i, n), limit);
      printf("%s %d %.3e %.3f\n", std::string(i).c_str(), n, e, std::log2(last / e));
      last = e;
    }
  }
}

}  // namespace

}  // namespace mpmvv::solver
