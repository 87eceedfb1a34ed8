#include <cmath>

#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::gimp_test {

/// S (29) as printed, in units of h; l is the full width.
double printed_weight(double x, double l) {
  x = std::abs(x);
  if (x < l / 2) return 1 - (4 * x * x + l * l) / (4 * l);
  if (x < 1 - l / 2) return 1 - x;
  if (x < 1 + l / 2) return (1 + l / 2 - x) * (1 + l / 2 - x) / (2 * l);
  return 0;
}

/// W (6) as printed, in units of h; l is half of the width.
double printed_gradient(double x, double l) {
  if (-1 - l < x && x <= -1 + l) return (1 + l + x) / (2 * l);
  if (-1 + l < x && x <= -l) return 1;
  if (-l < x && x <= l) return -x / l;
  if (l < x && x <= 1 - l) return -1;
  if (1 - l < x && x <= 1 + l) return -(1 + l - x) / (2 * l);
  return 0;
}

constexpr int line_cells = 5;

TEST(Gimp, WeightsAreThePrintedOnes) {  // S (29), W (6), without their case distinction
  for (const double l : {1e-8, 1e-3, 0.1, 0.25, 1.0 / 3, 0.5, 0.75, 0.999, 1.0})
    for (const double xi : places(line_cells)) {
      double N[3], dN[3];
      const int first = gimp_weights(xi, l, N, dN);
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(N[i], printed_weight(xi - (first + i), l), 1e-14) << xi << " " << l;
        EXPECT_NEAR(dN[i], printed_gradient(xi - (first + i), l / 2), 1e-14 / l) << xi << " " << l;
      }
    }
}

TEST(Gimp, WidestIsTheQuadraticSpline) {
  for (const double xi : places(line_cells)) {
    double N[3], dN[3], spline[3], slope[3];
    const int first = UGimp{}.evaluate({xi, line_cells, 0}, N, dN);
    const int other = BSpline2{}.evaluate({xi, line_cells, 0}, spline, slope);
    for (int i = 0; i < 3; ++i) {
      const int k = first + i - other;  // half-way between nodes either may name the node that it just touches
      EXPECT_NEAR(N[i], k >= 0 && k < 3 ? spline[k] : 0, 1e-15) << xi;
      EXPECT_NEAR(dN[i], k >= 0 && k < 3 ? slope[k] : 0, 1e-15) << xi;
    }
  }
}

TEST(Gimp, NarrowestIsTheLinearBasis) {
  for (const double l : {1e-3, 1e-6, 1e-12})
    for (const double xi : places(line_cells)) {
      double N[3], dN[3], hat[2], slope[2];
      const int first = UGimp{l}.evaluate({xi, line_cells, 0}, N, dN);
      const int cell = Linear{}.evaluate({xi, line_cells, 0}, hat, slope);
      for (int i = 0; i < 3; ++i) {
        const int k = first + i - cell;
        EXPECT_NEAR(N[i], k >= 0 && k < 2 ? hat[k] : 0, l / 4 + 1e-15) << xi;
        if (std::abs(xi - std::round(xi)) < l) continue;  // around the node itself the slope turns over
        EXPECT_NEAR(dN[i], k >= 0 && k < 2 ? slope[k] : 0, 1e-15) << xi;
      }
    }
}

TEST(CpGimp, WidthsFollowTheStretchesAlongTheAxes) {  // W (63)
  Scene<2> scene = full_scene<2>(CpGimp{}, 16, 2);
  set_wave(scene, 20);
  for (const auto integrator : integrator_words()) {
    scene.integrator = integrator;
    Mpm<2> mpm(scene);
    for (int k = 0; k < 5; ++k) ASSERT_TRUE(mpm.step(0.2 * scene.h / 120)) << mpm.fault();
    const auto& particles = mpm.particles();
    double shear = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      EXPECT_LT((particles.l[p] - 0.5 * particles.F[p].diagonal()).norm(), 1e-15) << integrator;
      shear = std::max(shear, std::abs(particles.F[p](0, 1)));
    }
    EXPECT_GT(shear, 0.01);
  }
}

TEST(Linear, GradientOnANodeIsThatOfTheCellToTheRight) {
  for (int node = 0; node < line_cells; ++node) {
    double N[2], dN[2];
    EXPECT_EQ(Linear{}.evaluate({static_cast<double>(node), line_cells, 0}, N, dN), node);
    EXPECT_EQ(N[0], 1);
    EXPECT_LT(N[1], 1e-50);
    EXPECT_EQ(dN[0], -1);
    EXPECT_EQ(dN[1], 1);
  }
}

TEST(Linear, GradientOnTheLastFaceIsThatOfTheLastCell) {
  double N[2], dN[2];
  EXPECT_EQ(Linear{}.evaluate({line_cells, line_cells, 0}, N, dN), line_cells - 1);
  EXPECT_LT(N[0], 1e-50);
  EXPECT_EQ(N[1], 1);
}

TEST(Linear, IsTheHatPrinted) {  // S (17)
  for (const double xi : places(line_cells)) {
    double N[2], dN[2];
    const int first = Linear{}.evaluate({xi, line_cells, 0}, N, dN);
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(N[i], std::max(0.0, 1 - std::abs(xi - (first + i))), 1e-15);
  }
}

}  // namespace mpmvv::solver::gimp_test
