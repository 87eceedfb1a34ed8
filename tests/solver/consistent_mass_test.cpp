#include "solver/consistent_mass.hpp"

#include <Eigen/Eigenvalues>
#include <random>

#include "solver/step.hpp"
#include "tests/numbers.hpp"
#include "tests/solver/each_basis.hpp"
#include "tests/solver/each_boundary.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::consistent_mass_test {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

double largest(const Matrix& difference) {
  return difference.lpNorm<Eigen::Infinity>();
}

/// The same numbers in whichever order tests run, and alone.
class RandomNumbers {
 public:
  double next() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }

 private:
  std::mt19937 engine_{11};
};

/// The box filled with particles that have left their lattice, at random velocities.
template <int D>
Scene<D> jumbled_box(const AnyBasis& basis, int cells, const AnyBoundary& boundary) {
  Scene<D> scene = full_scene<D>(basis, cells, 2, boundary);
  RandomNumbers random;
  for (auto& x : scene.particles.x)
    for (int d = 0; d < D; ++d) x[d] += 0.2 * scene.h * random.next();
  for (auto& v : scene.particles.v)
    for (int d = 0; d < D; ++d) v[d] = random.next();
  return scene;
}

/// A scene with its masses on the grid, and its mass matrix beside it.
template <int D>
struct Mapped {
  Step<D> step;
  ConsistentMass<D> mass;

  Mapped(const Scene<D>& scene, const ConsistentMassSettings& settings)
      : step(scene), mass(step, settings, scene.particles.m[0] * std::pow(2, D)) {
    step.map_momentum_and_forces();
    mass.set_coverage(step);
  }

  /// The matrix of one component, column by column.
  Matrix matrix() {
    const std::size_t nodes = step.grid().size();
    Matrix M(nodes, nodes);
    Array<Padded<D>> u(nodes), q(nodes);
    for (std::size_t j = 0; j < nodes; ++j) {
      std::fill(u.begin(), u.end(), Padded<D>::Zero());
      u[j].setOnes();
      mass.multiply(step, u, q);
      for (std::size_t i = 0; i < nodes; ++i) M(static_cast<int>(i), static_cast<int>(j)) = q[i][0];
    }
    return M;
  }

  Vector lumped() const {
    Vector m(step.grid().size());
    for (std::size_t n = 0; n < step.grid().size(); ++n) m[static_cast<int>(n)] = step.grid().m(n);
    return m;
  }
};

class ConsistentMassMatrix : public WithEachBasis {};
INSTANTIATE_TEST_SUITE_P(, ConsistentMassMatrix, every_basis(), word_in_name);

template <int D>
void expect_the_sum_over_particles(const AnyBasis& basis) {
  const Scene<D> scene = jumbled_box<D>(basis, 4, Free{});
  Mapped<D> mapped(scene, unregularised);
  Matrix expected = Matrix::Zero(mapped.step.grid().size(), mapped.step.grid().size());
  for (std::size_t p = 0; p < scene.particles.size(); ++p) {
    const auto nodes = reached(Setting{scene.basis, 0.5}, mapped.step.grid(), scene.particles.x[p]);
    for (const auto& i : nodes)
      for (const auto& j : nodes)
        expected(mapped.step.grid().node(i.node), mapped.step.grid().node(j.node)) += scene.particles.m[p] * i.N * j.N;
  }
  EXPECT_LT(largest(mapped.matrix() - expected), 1e-11 * scene.particles.m[0]);
}

TEST_P(ConsistentMassMatrix, IsTheSumOverParticles) {
  expect_the_sum_over_particles<1>(basis);
  expect_the_sum_over_particles<2>(basis);
}

/// Of M relative to diag(m), on the nodes that particles reach.
Vector relative_eigenvalues(const Matrix& M, const Vector& m) {
  std::vector<int> reached_nodes;
  for (int n = 0; n < m.size(); ++n)
    if (m[n] > 1e-40) reached_nodes.push_back(n);
  const Vector scale = m(reached_nodes).cwiseSqrt().cwiseInverse();
  const Matrix relative = scale.asDiagonal() * M(reached_nodes, reached_nodes) * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Matrix>(relative).eigenvalues();
}

/// M̂ = M̂ᵀ, M̂ 1 = m, and ε <= eigenvalues relative to m <= 1.
template <int D>
void expect_sound(const Scene<D>& scene, const ConsistentMassSettings& settings) {
  Mapped<D> mapped(scene, settings);
  const Matrix M = mapped.matrix();
  const Vector m = mapped.lumped();
  EXPECT_LT(largest(M - M.transpose()), 1e-14 * m.maxCoeff());
  EXPECT_LT(largest(M.rowwise().sum() - m), 1e-14 * m.maxCoeff());
  const Vector eigenvalues = relative_eigenvalues(M, m);
  EXPECT_GT(eigenvalues.minCoeff(), settings.lumped_share - 1e-13);
  EXPECT_LT(eigenvalues.maxCoeff(), 1 + 1e-13);
}

TEST_P(ConsistentMassMatrix, RegularisedKeepsSymmetryRowSumsAndBounds) {
  for (const double lumped_share : {1e-1, 1e-2, 1e-4})
    for (const double covered : {0.0, 0.25}) {
      const ConsistentMassSettings settings{.lumped_share = lumped_share, .covered = covered};
      expect_sound(jumbled_box<1>(basis, 6, Free{}), settings);
      expect_sound(jumbled_box<2>(basis, 3, Free{}), settings);
    }
}

/// One step of no length: the grid then holds the velocities that the particles were mapped to.
template <int D>
std::unique_ptr<Step<D>> mapped_velocities(Scene<D> scene, const ConsistentMassSettings& settings) {
  scene.consistent_mass = settings;
  auto s = std::make_unique<Step<D>>(scene);
  s->advance(0);
  EXPECT_EQ(s->fault(), Fault::none);
  return s;
}

/// The largest error of a particle's velocity, solved for to a tolerance: that of the nodes, e, has
/// Σ_p m_p (S e)_p² = eᵀ M e <= |r|²/s with the residual r and the least eigenvalue s, both relative to diag(m), and
/// |r| is no more than the tolerance times |p|, nor |p|² than Σ_p m_p v_p².
template <int D>
double error_bound(const Scene<D>& scene, const ConsistentMassSettings& settings) {
  Mapped<D> mapped(scene, settings);
  const double s = relative_eigenvalues(mapped.matrix(), mapped.lumped()).minCoeff();
  double squares = 0;
  for (const auto& v : scene.particles.v) squares += v.squaredNorm();
  return settings.tolerance * std::sqrt(squares / s);
}

/// A velocity that every basis holds: particles get back from M⁻¹ p what they have given; from p/m they do not.
template <int D>
void expect_linear_velocity_found(const AnyBasis& basis) {
  Scene<D> scene = jumbled_box<D>(basis, D == 1 ? 9 : 5, Free{});
  Mat<D> G;
  for (int k = 0; k < D * D; ++k) G.data()[k] = 0.3 - 0.17 * k;
  for (std::size_t p = 0; p < scene.particles.size(); ++p)
    scene.particles.v[p] = G * scene.particles.x[p] + Vec<D>::Constant(2);
  const auto step = mapped_velocities(scene, unregularised);
  const auto& grid = step->grid();
  double consistent = 0, lumped = 0;
  for (std::size_t p = 0; p < scene.particles.size(); ++p) {
    Vec<D> v = Vec<D>::Zero(), smoothed = Vec<D>::Zero();
    for (const auto& i : reached(Setting{basis, 0.5}, grid, scene.particles.x[p])) {
      const auto n = static_cast<std::size_t>(grid.node(i.node));
      v += i.N * grid.v[n].template head<D>();
      if (grid.m(n) > 0) smoothed += i.N * grid.p[n].template head<D>() / grid.m(n);
    }
    consistent = std::max(consistent, (v - scene.particles.v[p]).norm());
    lumped = std::max(lumped, (smoothed - scene.particles.v[p]).norm());
  }
  EXPECT_LT(consistent, error_bound(scene, unregularised));
  EXPECT_GT(lumped, 1e-3);
}

TEST_P(ConsistentMassMatrix, FindsALinearVelocityAgain) {
  expect_linear_velocity_found<1>(basis);
  expect_linear_velocity_found<2>(basis);
}

/// Cᵀ (p - M̂ v) = 0, v = C v.
template <int D>
void expect_solved(const AnyBasis& basis, const AnyBoundary& boundary) {
  const ConsistentMassSettings settings{.tolerance = 1e-12};
  const Scene<D> scene = jumbled_box<D>(basis, std::max(D == 3 ? 4 : 6, 2 * ghosts_of(basis) + 1), boundary);
  const auto step = mapped_velocities(scene, settings);
  ConsistentMass<D> mass(*step, settings, std::pow(scene.h, D));
  mass.set_coverage(*step);
  Array<Padded<D>> p(step->grid().size()), q(step->grid().size()), v = step->grid().v;
  for (std::size_t n = 0; n < p.size(); ++n) p[n] = step->grid().p[n].template head<padded_size<D>>();
  step->constrain(v);
  step->constrain_transposed(p);
  mass.multiply(*step, v, q);
  for (std::size_t n = 0; n < p.size(); ++n) {
    EXPECT_EQ((v[n] - step->grid().v[n]).template head<D>().norm(), 0);
    EXPECT_LT((p[n] - q[n]).template head<D>().norm(), 1e-11 * std::pow(scene.h, D));
  }
}

TEST_P(ConsistentMassMatrix, IsSolvedForWhatTheWallsLeaveFree) {
  for (const AnyBoundary& boundary : every_boundary()) {
    if (is_moved(boundary)) continue;
    if (has_open_knots && !std::holds_alternative<Free>(boundary) && !std::holds_alternative<Dirichlet>(boundary))
      continue;
    SCOPED_TRACE(word_of(boundary));
    expect_solved<1>(basis, boundary);
    expect_solved<2>(basis, boundary);
    expect_solved<3>(basis, boundary);
  }
}

/// M is singular with one particle per cell. The regularised one gives no mode more than 1/ε of what diag(m) does.
TEST_P(ConsistentMassMatrix, BoundsAccelerationsWhereItIsSingular) {
  Scene<2> scene = full_scene<2>(basis, 6, 1, has_open_knots ? AnyBoundary{Free{}} : Periodic{});
  set_widths(scene, 0.5);
  RandomNumbers random;
  for (auto& F : scene.particles.F) F(0, 0) = 1 + 0.3 * random.next();
  const auto norm_of = [&scene](double lumped_share) {
    scene.consistent_mass = ConsistentMassSettings{.lumped_share = lumped_share, .tolerance = 1e-9};
    Mpm<2> mpm(scene);
    mpm.map_acceleration();
    double sum = 0;
    for (std::size_t n = 0; n < mpm.grid().size(); ++n) sum += mpm.grid().m(n) * mpm.grid().a[n].squaredNorm();
    return std::sqrt(sum);
  };
  const double lumped = norm_of(1);
  for (const double lumped_share : {1e-1, 1e-2, 1e-3}) {
    EXPECT_GT(norm_of(lumped_share), lumped);
    EXPECT_LT(norm_of(lumped_share), lumped / lumped_share);
  }
}

/// The one particle of W §3 finds its own velocity again, where p_i/m_i = v and Σ_i N_ip v_i = v x/h.
TEST(ConsistentMass, ReproducesTheVelocityOfASingleParticle) {
  Scene<1> scene;
  scene.cells = {1};
  scene.material = NeoHookeanLog{0, 1};
  scene.boundary = {Dirichlet{}, Free{}};
  scene.particles = particles_at<1>({Vec<1>(0.4)}, 1);
  scene.particles.v[0][0] = 5;
  const auto step = mapped_velocities(scene, unregularised);
  EXPECT_NEAR(step->grid().v[static_cast<std::size_t>(step->grid().node({1}))][0], 5 / 0.4, 1e-9);
}

/// Whatever is not a number ends as a fault.
TEST_P(ConsistentMassMatrix, SurvivesNotANumber) {
  for (const auto& spoil :
       std::vector<void (*)(Particles<2>&)>{[](auto& p) { p.v[7][0] = nan; }, [](auto& p) { p.F[3](1, 0) = infinity; },
                                            [](auto& p) { p.x[5][1] = nan; }, [](auto& p) { p.v[2][1] = 1e300; }}) {
    Scene<2> scene = jumbled_box<2>(basis, 6, Dirichlet{});
    spoil(scene.particles);
    scene.consistent_mass.emplace();
    Mpm<2> mpm(scene);
    mpm.step(1e-4);
    EXPECT_FALSE(mpm.step(1e-4));
    EXPECT_NE(mpm.fault(), "");
  }
}

}  // namespace mpmvv::solver::consistent_mass_test
