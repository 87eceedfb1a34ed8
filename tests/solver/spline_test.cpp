#include <boost/math/special_functions/cardinal_b_spline.hpp>
#include <cmath>
#include <numeric>

#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::spline_test {

/// S (21) as printed, in units of h.
double printed_quadratic(double x) {
  if (-1.5 <= x && x <= -0.5) return x * x / 2 + 3 * x / 2 + 9.0 / 8;
  if (-0.5 <= x && x <= 0.5) return -x * x + 3.0 / 4;
  if (0.5 <= x && x <= 1.5) return x * x / 2 - 3 * x / 2 + 9.0 / 8;
  return 0;
}

template <class B>
void expect_cardinal_spline_inside(int cells, double margin) {
  constexpr unsigned degree = B::support - 1;
  for (const double xi : places(cells)) {
    if (xi < margin || xi > cells - margin) continue;
    double N[B::support], dN[B::support];
    const int first = B{}.evaluate({xi, cells, 1}, N, dN);
    for (int i = 0; i < B::support; ++i) {
      const double distance = xi - B::position(first + i, cells);
      EXPECT_NEAR(N[i], boost::math::cardinal_b_spline<degree>(distance), 1e-15) << xi;
      EXPECT_NEAR(dN[i], boost::math::cardinal_b_spline_prime<degree>(distance), 4e-15) << xi;
    }
  }
}

TEST(Spline, QuadraticIsTheOnePrinted) {  // S (21)
  for (const double xi : places(9)) {
    double N[3], dN[3];
    const int first = BSpline2{}.evaluate({xi, 9, 1}, N, dN);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(N[i], printed_quadratic(xi - (first + i)), 1e-14) << xi;
  }
}

TEST(Spline, CentredOnesAreCardinalSplines) {
  expect_cardinal_spline_inside<BSpline2>(9, 0);
  expect_cardinal_spline_inside<BSpline3>(9, 0);
}

TEST(Spline, OpenOnesAreCardinalSplinesInside) {
  expect_cardinal_spline_inside<BSpline2Open>(9, 2);
  expect_cardinal_spline_inside<BSpline3Open>(9, 3);
}

/// N §2.1: the slope of a mean over a box is what the function gains along the box over the box's width; over a whole
/// cell the mean is the cubic spline.
TEST(Spline, B2GimpIsTheMeanOfTheQuadraticOneOverTheParticle) {
  using boost::math::cardinal_b_spline;
  constexpr int cells = 6;
  for (const double l : {0.1, 0.25, 0.5, 0.8, 1.0})
    for (const double xi : places(cells)) {
      double N[4], dN[4];
      const int first = B2Gimp{}.evaluate({xi, cells, l}, N, dN);
      for (int i = 0; i < 4; ++i) {
        const double r = xi - (first + i);
        const double gain = cardinal_b_spline<2>(r + l / 2) - cardinal_b_spline<2>(r - l / 2);
        EXPECT_NEAR(dN[i], gain / l, 1e-14) << xi << ' ' << l;
        if (l == 1) {
          EXPECT_NEAR(N[i], cardinal_b_spline<3>(r), 1e-15) << xi;
        }
      }
    }
}

template <class B>
class OpenSpline : public ::testing::Test {};
using OpenSplines = ::testing::Types<BSpline2Open, BSpline3Open>;
TYPED_TEST_SUITE(OpenSpline, OpenSplines);

TYPED_TEST(OpenSpline, OneFunctionIsOneOnEachFace) {
  for (const int cells : {1, 2, 3, 8}) {
    double N[TypeParam::support], dN[TypeParam::support];
    EXPECT_EQ(TypeParam{}.evaluate({0, cells, 1}, N, dN), 0);
    EXPECT_EQ(N[0], 1);
    EXPECT_EQ(std::accumulate(N + 1, N + TypeParam::support, 0.0), 0);
    const int first = TypeParam{}.evaluate({static_cast<double>(cells), cells, 1}, N, dN);
    EXPECT_EQ(first + TypeParam::support, cells + TypeParam::extra_inside);
    EXPECT_EQ(N[TypeParam::support - 1], 1);
    EXPECT_EQ(std::accumulate(N, N + TypeParam::support - 1, 0.0), 0);
  }
}

TYPED_TEST(OpenSpline, RepresentsASlopeOnTheFaces) {  // the splines with zero slope there, S §3.2, cannot
  const int cells = 5;
  for (const double xi : {0.0, 1e-9, 0.3, 2.5, 4.999, 5.0}) {
    double N[TypeParam::support], dN[TypeParam::support];
    const int first = TypeParam{}.evaluate({xi, cells, 1}, N, dN);
    double value = 0, slope = 0;
    for (int i = 0; i < TypeParam::support; ++i) {
      const double coefficient = 3 * TypeParam::position(first + i, cells) - 1;
      value += coefficient * N[i];
      slope += coefficient * dN[i];
    }
    EXPECT_NEAR(value, 3 * xi - 1, 1e-14);
    EXPECT_NEAR(slope, 3, 1e-13);
  }
}

/// S (22), (23) as printed, on the knots with ends of multiplicity `order`: 0/0 counts as zero.
double printed_recursion(int i, int order, double x, const std::vector<double>& knots) {
  const auto knot = [&knots](int k) { return knots[static_cast<std::size_t>(k)]; };
  if (order == 1) return knot(i) <= x && x < knot(i + 1) ? 1 : 0;
  const double rise = knot(i + order - 1) - knot(i), fall = knot(i + order) - knot(i + 1);
  return (rise > 0 ? printed_recursion(i, order - 1, x, knots) * (x - knot(i)) / rise : 0) +
         (fall > 0 ? printed_recursion(i + 1, order - 1, x, knots) * (knot(i + order) - x) / fall : 0);
}

template <class Order>
class CoxDeBoor : public ::testing::Test {};
using Orders =
    ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>, std::integral_constant<int, 4>,
                     std::integral_constant<int, 5>, std::integral_constant<int, 6>>;
TYPED_TEST_SUITE(CoxDeBoor, Orders);

TYPED_TEST(CoxDeBoor, IsThePrintedRecursion) {  // S (22), (23)
  constexpr int order = TypeParam::value;
  for (const int cells : {1, 2, 3, 7}) {
    std::vector<double> knots;
    for (int k = 1 - order; k < cells + order; ++k) knots.push_back(std::clamp(k, 0, cells));
    const int functions = static_cast<int>(knots.size()) - order;
    EXPECT_EQ(functions, cells + 1 + order - 2);  // "N + k - 2" with N = cells + 1 knots needs multiplicity k
    for (const double xi : places(cells)) {
      if (xi >= cells) continue;
      double N[order], dN[order];
      const int span = static_cast<int>(xi);
      cox_de_boor<order>(xi, span, cells, N, dN);
      ASSERT_LE(span + order, functions);
      for (int i = 0; i < functions; ++i)
        EXPECT_NEAR(printed_recursion(i, order, xi, knots), i >= span && i < span + order ? N[i - span] : 0, 1e-14);
    }
  }
}

TYPED_TEST(CoxDeBoor, SumsToOneWithTheRightDerivative) {
  constexpr int order = TypeParam::value;
  const double step = 1e-6;
  for (const int cells : {1, 2, 3, 7})
    for (int span = 0; span < cells; ++span)
      for (const double t : {0.1, 0.37, 0.5, 0.92}) {
        double N[order], dN[order], right[order], left[order], unused[order];
        cox_de_boor<order>(span + t, span, cells, N, dN);
        cox_de_boor<order>(span + t + step, span, cells, right, unused);
        cox_de_boor<order>(span + t - step, span, cells, left, unused);
        EXPECT_NEAR(std::accumulate(N, N + order, 0.0), 1, 1e-15);
        EXPECT_NEAR(std::accumulate(dN, dN + order, 0.0), 0, 1e-14);
        for (int i = 0; i < order; ++i) EXPECT_NEAR((right[i] - left[i]) / (2 * step), dN[i], 1e-8);
      }
}

}  // namespace mpmvv::solver::spline_test
