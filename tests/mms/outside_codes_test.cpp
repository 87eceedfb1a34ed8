#include <gtest/gtest.h>

#include "mms/translation.hpp"
#include "mms/wave.hpp"
#include "tests/mms/samples.hpp"

/// Solutions that any code can run: those that start at rest, the inverse form, and those without a body force.
namespace mpmvv::mms::outside_codes_test {

template <class S>
class FromRest : public ::testing::Test {};
using RestSamples = ::testing::Types<BarAtRestSample, SquareAtRestSample, CubeAtRestSample, SquareInverseSample>;
TYPED_TEST_SUITE(FromRest, RestSamples);

TYPED_TEST(FromRest, NothingIsDisplacedOrMovesAtTheStart) {
  constexpr int D = TypeParam::dimension;
  for (const TypeParam& sample : samples<TypeParam>())
    for (const Vec<D>& X : sample.points()) {
      const auto closed = sample.closed();
      EXPECT_LT(closed.u(X, 0).norm(), 1e-16);
      EXPECT_LT(closed.v(X, 0).norm(), 1e-15 * closed.displacement_scale() * 2 * M_PI / sample.period());
      EXPECT_LT((closed.F(X, 0) - Mat<D>::Identity()).norm(), 1e-15);
      EXPECT_LT(closed.P(X, 0).norm(), 1e-14 * sample.material.youngs_modulus);
    }
}

TEST(SquareInverse, TakesItsBodyForceFromTheCurrentPosition) {
  for (const SquareInverseSample& sample : samples<SquareInverseSample>()) {
    const SquareInverse closed = sample.closed();
    const double t = 0.3 * sample.period();
    for (const Vec<2>& X : sample.points()) {
      const Vec<2> x = X + closed.u(X, t), b = closed.b(X, t);
      EXPECT_LT((closed.place(X, t) - x).norm(), 1e-14);
      EXPECT_LT((closed.b_at(x, t) - b).norm(), 1e-11 * (b.norm() + 1));
    }
  }
}

TEST(Wave, BalancesMomentumWithoutABodyForce) {
  const Elasticity material{1e4, 0.3, 2};
  const Wave wave(1e-3, material);
  const double t = 2.3e-3, s = 1e-3, dt = 1e-6;
  for (const double X : {0.1, 0.35, 0.5, 0.8}) {
    const Vec<2> at(X, 0.4), step(s, 0);
    const Vec<2> div_P = (wave.P(at + step, t) - wave.P(at - step, t)).col(0) / (2 * s);
    EXPECT_NEAR(div_P[0], material.density * wave.a(at, t)[0], 1e-5 * std::abs(div_P[0]) + 1e-8);
    EXPECT_NEAR((wave.u(at, t + dt) - wave.u(at, t - dt))[0] / (2 * dt), wave.v(at, t)[0], 1e-5);
    EXPECT_NEAR((wave.v(at, t + dt) - wave.v(at, t - dt))[0] / (2 * dt), wave.a(at, t)[0], 1e-1);
    EXPECT_NEAR((wave.u(at + step, t) - wave.u(at - step, t))[0] / (2 * s), wave.F(at, t)(0, 0) - 1, 1e-6);
    EXPECT_NEAR(wave.P(at, t)(0, 0), (material.lambda() + 2 * material.mu()) * (wave.F(at, t)(0, 0) - 1), 1e-9);
    EXPECT_NEAR(wave.P(at, t)(1, 1), material.lambda() * (wave.F(at, t)(0, 0) - 1), 1e-9);
    EXPECT_EQ(wave.b(at, t), (Vec<2>::Zero()));
  }
  EXPECT_EQ(wave.u({0.3, 0.2}, 0), (Vec<2>::Zero()));
}

/// How far the bar of the law S (46) in uniaxial strain is from the wave at the end, RMS: on so many intervals, by
/// central differences.
double neo_hookean_difference(double A, const Elasticity& material, double end) {
  const int n = 800;
  const double lambda = material.lambda(), mu = material.mu(), h = 1.0 / n;
  const double c = std::sqrt((lambda + 2 * mu) / material.density);
  const int steps = static_cast<int>(std::ceil(end * c / (0.2 * h)));
  const double dt = end / steps;
  std::vector<double> u(n + 1, 0), v(n + 1, 0), stress(n);
  const auto kick = [&](double interval) {
    for (int k = 0; k < n; ++k) {
      const double F = 1 + (u[static_cast<std::size_t>(k) + 1] - u[static_cast<std::size_t>(k)]) / h;
      stress[static_cast<std::size_t>(k)] = (lambda * std::log(F) + mu * (F * F - 1)) / F;
    }
    for (std::size_t i = 1; i < n; ++i) v[i] += interval * (stress[i] - stress[i - 1]) / h / material.density;
  };
  for (std::size_t i = 1; i < n; ++i) v[i] = A * M_PI * c * std::sin(M_PI * h * static_cast<double>(i));
  kick(dt / 2);
  for (int k = 0; k < steps; ++k) {
    for (std::size_t i = 0; i <= n; ++i) u[i] += dt * v[i];
    kick(dt);
  }
  double squares = 0;
  for (std::size_t i = 0; i < n; ++i)
    squares += std::pow(u[i] - A * std::sin(M_PI * h * static_cast<double>(i)) * std::sin(M_PI * c * end), 2);
  return std::sqrt(squares / n);
}

/// Between whole multiples of 1/c the first order of the difference counts, at them the next one.
TEST(Wave, KnowsHowFarAFiniteLawLeavesIt) {
  const Elasticity material{1e4, 0.3, 1};
  const double c = std::sqrt((material.lambda() + 2 * material.mu()) / material.density);
  for (const auto& [ct, A, least] : {std::tuple{0.5, 1e-3, 0.98},
                                     {1.75, 1e-3, 0.97},
                                     {2.5, 1e-3, 0.85},
                                     {4.25, 1e-3, 0.97},
                                     {1, 1e-2, 0.2},
                                     {1.43, 1e-2, 0.2},
                                     {2, 1e-2, 0.1},
                                     {3, 1e-2, 0.1}}) {
    const double difference = neo_hookean_difference(A, material, ct / c);
    const double most = Wave(A, material).nonlinear_error(ct / c);
    EXPECT_LT(difference, most) << ct;
    EXPECT_GT(difference, least * most) << ct;
  }
}

TEST(Translation, MovesABodyAsItIs) {
  const Translation<3> moved({1, -2, 3}, 1);
  const Vec<3> X(0.3, 0.2, 0.1);
  EXPECT_EQ(moved.u(X, 0.5), (Vec<3>(0.5, -1, 1.5)));
  EXPECT_EQ(moved.v(X, 0.5), (Vec<3>(1, -2, 3)));
  EXPECT_EQ(moved.F(X, 0.5), (Mat<3>::Identity()));
  EXPECT_EQ(moved.P(X, 0.5), (Mat<3>::Zero()));
  EXPECT_EQ(moved.a(X, 0.5) + moved.b(X, 0.5), (Vec<3>::Zero()));
}

}  // namespace mpmvv::mms::outside_codes_test
