#include <gtest/gtest.h>

#include "tests/mms/samples.hpp"

namespace mpmvv::mms::radial_test {

constexpr double radii_of_rings[][2] = {{0.5, 1}, {0.2, 1.1}, {1, 2.9}, {1, 3.1}, {0.01, 0.7}};

double w(const RadialProfile& profile, double R) {
  return R * profile.over_R(R);
}

/// W (61) as printed: w' = 0 at both radii, and w(R_O) = 1.
TEST(RadialProfile, HasThePrintedConstants) {
  for (const auto& [R_I, R_O] : radii_of_rings) {
    const RadialProfile profile({R_I, R_O});
    const double size = profile.steepest();
    EXPECT_NEAR(w(profile, R_O), 1, 1e-13 * size);
    EXPECT_EQ(profile.slope(R_I), 0);
    EXPECT_EQ(profile.slope(R_O), 0);
    for (const double R : {R_I, 0.7 * R_I + 0.3 * R_O, R_O}) {
      const double step = 1e-4 * R_O;  // central differences are exact for w and cost its third derivative for w'
      const auto slope = [&](double at) { return (w(profile, at + step) - w(profile, at - step)) / (2 * step); };
      const auto curvature = [&](double at) {
        return (profile.slope(at + step) - profile.slope(at - step)) / (2 * step);
      };
      const auto over_R_slope = [&](double at) {
        return (profile.over_R(at + step) - profile.over_R(at - step)) / (2 * step);
      };
      EXPECT_NEAR(profile.slope(R), slope(R), 1e-7 * size);
      EXPECT_NEAR(profile.curvature(R), curvature(R), 1e-9 * size / R_I);
      EXPECT_NEAR(profile.over_R_slope(R), over_R_slope(R), 1e-9 * size / R_I);
    }
  }
}

TEST(RadialProfile, KnowsItsExtremes) {
  for (const auto& [R_I, R_O] : radii_of_rings) {
    const RadialProfile profile({R_I, R_O});
    double largest = 0, steepest = 0;
    constexpr int n = 1000;
    for (int k = 0; k <= n; ++k) {
      const double R = R_I + (R_O - R_I) * k / n;
      largest = std::max(largest, std::abs(w(profile, R)));
      steepest = std::max({steepest, std::abs(profile.slope(R)), std::abs(profile.over_R(R))});
    }
    EXPECT_NEAR(profile.largest(), largest, 1e-5 * largest);
    EXPECT_NEAR(profile.steepest(), steepest, 1e-5 * steepest);
  }
}

TEST(RadialProfile, RefusesRadiiThatMakeNoRing) {
  for (const auto& [R_I, R_O] : {std::pair{0.0, 1.0}, {-0.5, 1.0}, {1.0, 1.0}, {2.0, 1.0}, {std::nan(""), 1.0}})
    EXPECT_THROW(Radii(R_I, R_O), std::invalid_argument);
  for (const double R_I : {0.1, 1.0 / 3, 1.0, 7.7}) EXPECT_THROW(RadialProfile({R_I, 3 * R_I}), std::invalid_argument);
  EXPECT_THROW(RadialProfile({0.1, 0.3}), std::invalid_argument);
}

template <class S>
class RadialSolution : public ::testing::Test {};
using RadialSamples = ::testing::Types<RingSample, ShellSample>;
TYPED_TEST_SUITE(RadialSolution, RadialSamples);

/// The traction on both surfaces is normal: nothing at ν = 0, else λK, as F_RR = 1 there.
TYPED_TEST(RadialSolution, SurfacesCarryLambdaLogJ) {
  constexpr int D = TypeParam::dimension;
  for (const TypeParam& sample : samples<TypeParam>())
    for (const double phase : {0.0, 0.1, 0.25, 0.5, 0.9})
      for (const Vec<D>& e_R : directions<D>())
        for (const auto& [R, side] : {std::pair{sample.radii.inner, -1}, {sample.radii.outer, 1}}) {
          const double t = phase * sample.period();
          const auto closed = sample.closed();
          const double stretch = 1 + closed.u(R * e_R, t).dot(e_R) / R;
          const Vec<D> expected = sample.material.lambda() * (D - 1) * std::log(stretch) * side * e_R;
          EXPECT_LT((closed.traction(R * e_R, side * e_R, t) - expected).norm(),
                    1e-13 * sample.material.youngs_modulus);
        }
}

/// Nodes that carry mass lie about the body too.
TYPED_TEST(RadialSolution, ReferencePointsAboutTheBody) {
  constexpr int D = TypeParam::dimension;
  for (const TypeParam& sample : samples<TypeParam>())
    for (const double phase : {0.0, 0.2, 0.25, 0.5})
      for (const double R : {0.9 * sample.radii.inner, 1.05 * sample.radii.outer}) {
        const double t = phase * sample.period();
        const auto closed = sample.closed();
        const Vec<D> X = R * directions<D>().back();
        EXPECT_LT((closed.reference_point(X + closed.u(X, t), t) - X).norm(), 1e-13);
      }
  const TypeParam folding = samples<TypeParam>().back();
  EXPECT_THROW(folding.closed().reference_point(Vec<D>::Constant(9), folding.period() / 2), std::domain_error);
}

TYPED_TEST(RadialSolution, MovesAlongTheRadius) {
  constexpr int D = TypeParam::dimension;
  for (const TypeParam& sample : samples<TypeParam>())
    for (const Vec<D>& e_R : directions<D>()) {
      const auto closed = sample.closed();
      EXPECT_LT((closed.u(sample.radii.outer * e_R, 0) - sample.amplitude * e_R).norm(), 1e-14);
      EXPECT_EQ(closed.v(sample.radii.outer * e_R, 0).norm(), 0);
    }
}

}  // namespace mpmvv::mms::radial_test
