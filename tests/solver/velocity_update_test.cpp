#include <Eigen/LU>
#include <cmath>

#include "tests/numbers.hpp"
#include "tests/solver/each_update.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::velocity_update_test {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// N table 1 once more, with the matrices of N §2.1: a line of particles between free faces.
class Dense {
 public:
  explicit Dense(const Scene<1>& scene) : scene_(scene), count_(static_cast<int>(scene.particles.size())) {
    X = V = F = V0_ = M_ = Vector::Zero(count_);
    for (int p = 0; p < count_; ++p) {
      const auto q = static_cast<std::size_t>(p);
      X[p] = scene.particles.x[q][0], V[p] = scene.particles.v[q][0], F[p] = scene.particles.F[q](0, 0);
      V0_[p] = scene.particles.V0[q], M_[p] = scene.particles.m[q];
    }
  }

  Vector X, V, F;

  void step(std::string_view integrator, const AnyVelocityUpdate& update, double dt) {
    evaluate();
    const bool first = integrator.starts_with("usf") || integrator.starts_with("usavg");
    const bool again = integrator.ends_with("+");
    const double share = integrator.starts_with("usavg") ? 0.5 : 1;
    const Vector p = S_.transpose() * M_.cwiseProduct(V);
    if (first) deform(stress_velocity(update, p), share * dt);
    const Vector a = lumped(force()), v = lumped(p);
    const Vector v_plus = stress_velocity(update, p + dt * force());
    advance(update, p, v, a, v_plus, dt);
    if (again)
      deform(stress_velocity(update, S_.transpose() * M_.cwiseProduct(V)), share * dt);
    else if (integrator != "usf")
      deform(v_plus, share * dt);
  }

  /// Σ_l (-1)^(l+1) C(k, l) (S⁺S)^(l-1) m⁻¹, N (1)
  Matrix inverse(int order) const {
    const Matrix mass_product = mass_.cwiseInverse().asDiagonal() * (S_.transpose() * M_.asDiagonal() * S_);
    Matrix sum = Matrix::Zero(mass_.size(), mass_.size()), power = Matrix::Identity(mass_.size(), mass_.size());
    double binomial = 1;
    for (int l = 1; l <= order; ++l) {
      binomial *= static_cast<double>(order + 1 - l) / l;
      sum += (l % 2 == 1 ? binomial : -binomial) * power;
      power = power * mass_product;
    }
    return sum * mass_.cwiseInverse().asDiagonal();
  }

  /// S and G at the particles' places, of the nodes that they reach.
  void evaluate() {
    const auto grid = grid_for<BSpline2, 1>(scene_.lower, scene_.h, scene_.cells);
    S_ = G_ = Matrix::Zero(count_, static_cast<int>(grid.size()));
    for (int p = 0; p < count_; ++p)
      for (const auto& i : reached<1>(Setting{BSpline2{}, 1}, grid, Vec<1>(X[p])))
        S_(p, grid.node(i.node)) = i.N, G_(p, grid.node(i.node)) = i.dN[0];
    mass_ = S_.transpose() * M_;
    std::vector<int> reached_nodes;
    for (int n = 0; n < mass_.size(); ++n)
      if (mass_[n] > 0) reached_nodes.push_back(n);
    S_ = Matrix(S_(Eigen::all, reached_nodes));
    G_ = Matrix(G_(Eigen::all, reached_nodes));
    mass_ = Vector(mass_(reached_nodes));
  }

 private:
  Vector lumped(const Vector& momentum) const { return momentum.cwiseQuotient(mass_); }
  Vector stress_velocity(const AnyVelocityUpdate& update, const Vector& momentum) const {
    const auto* fmpm = std::get_if<Fmpm>(&update);
    return fmpm ? Vector(inverse(fmpm->order) * momentum) : lumped(momentum);
  }
  Vector force() const {
    const auto& material = std::get<NeoHookeanLog>(scene_.material);
    const Vector tau = F.unaryExpr([&](double f) { return material.lambda * std::log(f) + material.mu * (f * f - 1); });
    return -G_.transpose() * V0_.cwiseProduct(tau);
  }
  void deform(const Vector& v, double dt) { F += dt * (G_ * v).cwiseProduct(F); }

  void advance(const AnyVelocityUpdate& update, const Vector& p, const Vector& v, const Vector& a, const Vector& v_plus,
               double dt) {
    const Vector V_n = V;
    if (const auto* flip = std::get_if<Flip>(&update)) {
      V += dt * S_ * a;
      if (flip->position == FlipPosition::first_order) X += dt * S_ * v_plus;
      if (flip->position == FlipPosition::second_order) X += dt * S_ * v + dt * dt / 2 * S_ * a;
      if (flip->position == FlipPosition::particle) X += dt / 2 * (V_n + V);
    } else if (const auto* xpic = std::get_if<Xpic>(&update)) {
      V = S_ * (inverse(xpic->order) * p + dt * a);
      X += dt * (S_ * v + (V - V_n) / 2);
    } else if (std::holds_alternative<Fmpm>(update)) {
      V = S_ * v_plus;
      X += dt / 2 * (V_n + V);
    } else {
      V = S_ * v_plus;
      X += dt * V;
    }
  }

  Scene<1> scene_;
  int count_;
  Vector V0_, M_, mass_;
  Matrix S_, G_;
};

/// A body of uneven spacing away from the faces, at a wave of velocities.
Scene<1> free_line(const AnyVelocityUpdate& update, std::string_view integrator = "usl") {
  Scene<1> scene;
  scene.cells = {14};
  scene.h = 0.1;
  scene.basis = BSpline2{};
  scene.boundary.fill(Free{});
  scene.material = NeoHookeanLog{300, 400};
  Array<Vec<1>> places;
  for (int k = 0; k < 20; ++k) places.emplace_back(0.33 + 0.035 * k + 0.008 * std::sin(2.0 * k));
  scene.particles = particles_at<1>(places, 0.035);
  for (auto& v : scene.particles.v) v[0] = 2 + 3 * std::sin(9 * (&v - scene.particles.v.data()));
  scene.velocity_update = update;
  scene.integrator = integrator;
  return scene;
}

/// What N table 1 has, and `Dense`.
const std::vector<AnyVelocityUpdate> table_one{Flip{FlipPosition::first_order},
                                               Flip{FlipPosition::second_order},
                                               Flip{FlipPosition::particle},
                                               Pic{},
                                               Xpic{1},
                                               Xpic{2},
                                               Xpic{5},
                                               Fmpm{1},
                                               Fmpm{2},
                                               Fmpm{4},
                                               Fmpm{8}};

TEST(VelocityUpdate, IsTableOne) {
  for (const auto integrator : {"usl", "usf", "usavg", "usl+", "usavg+"})
    for (const auto& update : table_one) {
      SCOPED_TRACE(testing::Message() << integrator << " " << name_of(update));
      const Scene<1> scene = free_line(update, integrator);
      Mpm<1> mpm(scene);
      Dense dense(scene);
      for (int k = 0; k < 12; ++k) {
        ASSERT_TRUE(mpm.step(2e-4)) << integrator << mpm.fault();
        dense.step(integrator, update, 2e-4);
      }
      for (std::size_t p = 0; p < scene.particles.size(); ++p) {
        const auto id = static_cast<int>(mpm.particles().id[p]);
        EXPECT_NEAR(mpm.particles().x[p][0], dense.X[id], 1e-13);
        EXPECT_NEAR(mpm.particles().v[p][0], dense.V[id], 1e-10);
        EXPECT_NEAR(mpm.particles().F[p](0, 0), dense.F[id], 1e-12);
      }
    }
}

/// N (2): the three share V', that is the acceleration, and differ in the effective velocity 𝕍 = (X' - X)/Δt - (V' -
/// V)/2.
TEST(VelocityUpdate, ThreeOfPicShareTheAcceleration) {
  const double dt = 1e-4;
  const auto after = [dt](const AnyVelocityUpdate& update) {
    Mpm<1> mpm(free_line(update));
    EXPECT_TRUE(mpm.step(dt));
    return mpm.particles();
  };
  const Scene<1> start = free_line(Flip{});
  const auto pic = after(Pic{}), xpic = after(Xpic{1}), fmpm = after(Fmpm{1}), flip = after(Flip{});
  for (std::size_t p = 0; p < start.particles.size(); ++p) {
    const double V = start.particles.v[p][0], V_new = pic.v[p][0];
    EXPECT_NEAR(xpic.v[p][0], V_new, 1e-12);
    EXPECT_NEAR(fmpm.v[p][0], V_new, 1e-12);
    const auto effective = [&](const Particles<1>& particles) {
      return (particles.x[p][0] - start.particles.x[p][0]) / dt - (particles.v[p][0] - V) / 2;
    };
    EXPECT_NEAR(effective(pic), (V_new + V) / 2, 1e-10);
    EXPECT_NEAR(effective(xpic), V_new - (flip.v[p][0] - V), 1e-10);  // S m⁻¹p
    EXPECT_NEAR(effective(fmpm), V, 1e-10);
  }
}

/// Every update, with every integrator that takes one: momentum, mass and rigid motion.
TEST(VelocityUpdate, KeepsMomentumAndRigidMotion) {
  for (const auto integrator : integrators_of_whole_steps())
    for (const auto& update : every_velocity_update()) {
      SCOPED_TRACE(testing::Message() << integrator << " " << name_of(update));
      Scene<1> scene = free_line(update, integrator);
      const auto momentum = [](const Particles<1>& particles) {
        double sum = 0;
        for (std::size_t p = 0; p < particles.size(); ++p) sum += particles.m[p] * particles.v[p][0];
        return sum;
      };
      Mpm<1> mpm(scene);
      for (int k = 0; k < 40; ++k) ASSERT_TRUE(mpm.step(2e-4)) << mpm.fault();
      EXPECT_NEAR(momentum(mpm.particles()), momentum(scene.particles), 1e-13);

      for (auto& v : scene.particles.v) v[0] = 3;
      Mpm<1> rigid(scene);
      for (int k = 0; k < 40; ++k) ASSERT_TRUE(rigid.step(2e-4));
      for (std::size_t p = 0; p < scene.particles.size(); ++p) {
        EXPECT_NEAR(rigid.particles().x[p][0], scene.particles.x[p][0] + 3 * 40 * 2e-4, 1e-13);
        EXPECT_NEAR(rigid.particles().v[p][0], 3, 1e-12);
        EXPECT_NEAR(rigid.particles().F[p](0, 0), 1, 1e-13);
      }
    }
}

/// The limit k -> infinity is the solve with the consistent mass: each further term leaves less, as (1 - s)^k of the
/// mode that S⁺S leaves the fraction s of.
TEST(ExpandedInverse, TendsToTheConsistentMass) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 10, 3);
  for (auto& v : scene.particles.v) v[0] = std::sin(9 * (&v - scene.particles.v.data()));
  const auto velocities = [&scene](int order) {
    scene.velocity_update = Fmpm{order};
    Mpm<1> mpm(scene);
    EXPECT_TRUE(mpm.step(1e-4));
    return mpm.particles().v;
  };
  scene.consistent_mass = unregularised;
  const auto exact = velocities(1);
  scene.consistent_mass.reset();
  double last = infinity;
  for (const int order : {1, 2, 4, 8, 16, 32, 64}) {
    const auto v = velocities(order);
    double distance = 0;
    for (std::size_t p = 0; p < v.size(); ++p) distance = std::max(distance, (v[p] - exact[p]).norm());
    EXPECT_LT(distance, last);
    last = distance;
  }
  EXPECT_LT(last, 1e-6);
}

/// Steps between those of periodic FMPM are FLIP's with positions of second order.
TEST(VelocityUpdate, PeriodicFmpmIsFlipBetween) {
  for (const std::string_view integrator : {"usl", "usf", "usavg", "usl+", "usavg+"}) {
    Scene<1> scene = free_line(Fmpm{4, 3});
    scene.integrator = integrator;
    Mpm<1> periodic(scene);
    for (int k = 0; k < 7; ++k) {
      scene.velocity_update = k % 3 == 0 ? AnyVelocityUpdate(Fmpm{4}) : Flip{FlipPosition::second_order};
      Mpm<1> one_step(scene);
      ASSERT_TRUE(one_step.step(2e-4) && periodic.step(2e-4));
      scene.particles = one_step.particles();
      EXPECT_TRUE(scene.particles.x == periodic.particles().x && scene.particles.v == periodic.particles().v &&
                  scene.particles.F == periodic.particles().F)
          << integrator << " step " << k;
    }
  }
}

/// What particles take of XPIC obeys a face as FMPM's velocities do; it stands where forces did.
TEST(WallMethods, HoldWhatXpicTakes) {
  for (const auto method : {WallMethod::velocity, WallMethod::combined, WallMethod::lumped}) {
    Scene<1> scene = full_scene<1>(BSpline2{}, 8, 3, Dirichlet{});
    for (auto& v : scene.particles.v) v[0] = 1;
    scene.velocity_update = Xpic{3};
    scene.wall_method = method;
    Mpm<1> mpm(scene);
    ASSERT_TRUE(mpm.step(1e-5));
    const double taken = mpm.grid().f[static_cast<std::size_t>(mpm.grid().node({0}))][0];
    EXPECT_EQ(taken == 0, method != WallMethod::lumped) << taken;
  }
}

/// By the velocity and the combined method a wall's nodes have its velocity, by the lumped one about.
TEST(WallMethods, HoldWhatTheySay) {
  const auto at_wall = [](WallMethod method) {
    Scene<1> scene = full_scene<1>(BSpline2{}, 8, 3, Dirichlet{});
    for (auto& v : scene.particles.v) v[0] = 1;
    scene.velocity_update = Fmpm{3};
    scene.wall_method = method;
    Mpm<1> mpm(scene);
    EXPECT_TRUE(mpm.step(1e-5));
    return std::pair{mpm.grid().v[static_cast<std::size_t>(mpm.grid().node({0}))][0],
                     mpm.grid().v[static_cast<std::size_t>(mpm.grid().node({1}))][0]};
  };
  EXPECT_EQ(at_wall(WallMethod::velocity).first, 0);
  EXPECT_EQ(at_wall(WallMethod::combined).first, 0);
  EXPECT_NE(at_wall(WallMethod::lumped).first, 0);
  EXPECT_EQ(at_wall(WallMethod::combined).second, at_wall(WallMethod::lumped).second);
  EXPECT_NEAR(at_wall(WallMethod::velocity).second, 1, 1e-3);  // as if there were no wall
  EXPECT_GT(std::abs(at_wall(WallMethod::combined).second - 1), 1e-2);
}

}  // namespace mpmvv::solver::velocity_update_test
