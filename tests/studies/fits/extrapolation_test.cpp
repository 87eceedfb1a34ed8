#include "studies/fits/extrapolation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace mpmvv::fits::extrapolation_test {

using testing::HasSubstr;

std::vector<ErrorSample> sampled(const std::vector<double>& cells, const std::function<double(double)>& phi) {
  std::vector<ErrorSample> samples;
  for (const double n : cells) samples.push_back({n, 1 / n, phi(1 / n)});
  return samples;
}

const std::vector<double> doubled{8, 16, 32, 64}, many{8, 11, 16, 23, 32, 45, 64};

TEST(Extrapolation, FindsTheLimitOfAPowerLaw) {
  for (const double p : {0.7, 1.0, 1.6}) {
    const auto samples = sampled(doubled, [&](double h) { return -3 + 5 * std::pow(h, p); });
    const Extrapolation e = extrapolate(samples, 8, 64);
    EXPECT_NEAR(e.limit, -3, 1e-7);
    EXPECT_NEAR(e.order, p, 1e-4);
    EXPECT_NEAR(e.uncertainty, 1.25 * (e.finest + 3), 1e-6) << "the safety factor alone";
    EXPECT_NEAR(e.convergence_index, e.uncertainty, 1e-5) << "the same on an exact power law";
    EXPECT_EQ(e.remark, "");
  }
}

TEST(Extrapolation, UncertaintyCoversTheErrorOfMixedOrders) {
  const auto phi = [](double h) { return 1 + 0.3 * h - 4 * h * h + 0.02 * std::sin(40 / h) * h; };
  const Extrapolation e = extrapolate(sampled(many, phi), 8, 64);
  EXPECT_LT(std::abs(e.finest - 1), e.uncertainty);
  EXPECT_LT(e.uncertainty, 0.1);
}

TEST(Extrapolation, HighAndLowOrdersAreNotTrusted) {
  const Extrapolation high = extrapolate(sampled(doubled, [](double h) { return h * h * h; }), 8, 64);
  EXPECT_NEAR(high.order, 3, 1e-3);
  EXPECT_EQ(high.model, "φ0 + α h²");
  const Extrapolation low = extrapolate(sampled(many, [](double h) { return std::pow(h, 0.2); }), 8, 64);
  EXPECT_LT(low.order, 0.5);
  EXPECT_GT(low.uncertainty, 1.25 * std::abs(low.finest - low.limit)) << "three times, not one and a quarter";
}

/// With p above 2 the model is φ0 + α h², here fitted by hand with weights 1/h, where the misfit is the lesser.
TEST(Extrapolation, WeighsGridsByOneOverTheirWidth) {
  const auto samples = sampled(doubled, [](double h) { return h * h * h; });
  double sum = 0, x_mean = 0, y_mean = 0, xx = 0, xy = 0;
  for (const ErrorSample& s : samples) sum += 1 / s.h, x_mean += s.h, y_mean += s.e / s.h;
  x_mean /= sum, y_mean /= sum;
  for (const ErrorSample& s : samples) {
    xx += std::pow(s.h * s.h - x_mean, 2) / s.h;
    xy += (s.h * s.h - x_mean) * (s.e - y_mean) / s.h;
  }
  EXPECT_NEAR(extrapolate(samples, 8, 64).limit, y_mean - xy / xx * x_mean, 1e-14);
}

/// σ of φ0 + Σ c_j h^powers_j, with weights that sum to the number of grids, by the normal equations.
double deviation(const std::vector<ErrorSample>& samples, const std::vector<double>& powers, bool finer_more) {
  const auto n = static_cast<Eigen::Index>(samples.size()), unknowns = static_cast<Eigen::Index>(powers.size()) + 1;
  Eigen::MatrixXd A = Eigen::MatrixXd::Ones(n, unknowns);
  Eigen::VectorXd w = Eigen::VectorXd::Ones(n), phi(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const ErrorSample& s = samples[static_cast<std::size_t>(k)];
    for (Eigen::Index j = 1; j < unknowns; ++j) A(k, j) = std::pow(s.h, powers[static_cast<std::size_t>(j - 1)]);
    if (finer_more) w[k] = 1 / s.h;
    phi[k] = s.e;
  }
  w *= static_cast<double>(n) / w.sum();
  const Eigen::MatrixXd AtW = A.transpose() * w.asDiagonal();
  const Eigen::VectorXd misfit = A * (AtW * A).eval().ldlt().solve(AtW * phi) - phi;
  return std::sqrt(misfit.dot(w.cwiseProduct(misfit)) / static_cast<double>(n - unknowns));
}

struct Fallback {
  std::vector<double> values;               ///< from the coarsest grid
  std::vector<std::vector<double>> models;  ///< powers of those that compete
  std::string chosen;
};

TEST(Extrapolation, TakesTheFixedOrdersOfTheLeastDeviation) {
  const std::vector<std::vector<double>> above_two{{1}, {2}}, below_half{{1}, {2}, {1, 2}};
  for (const auto& [values, models, chosen] : std::vector<Fallback>{
           {{0, 1, 2, 1}, above_two, "φ0 + α h²"},
           {{0, 3, 0, 1}, above_two, "φ0 + α h"},
           {{0, 3, 2, 4}, below_half, "φ0 + α h²"},
           {{0, 1, 0, 1}, below_half, "φ0 + α h"},
           {{0, 0, 0, 1}, below_half, "φ0 + α h + β h²"},
       }) {
    std::size_t k = 0;
    const auto samples = sampled(doubled, [&](double) { return values[k++]; });
    double least = 10;
    for (const auto& powers : models)
      for (const bool finer_more : {false, true}) least = std::min(least, deviation(samples, powers, finer_more));
    const Extrapolation e = extrapolate(samples, 8, 64);
    EXPECT_EQ(e.model, chosen);
    EXPECT_NEAR(e.deviation, least, 1e-12) << chosen;
  }
}

TEST(Extrapolation, ScatterWidensTheUncertainty) {
  int k = 0;
  const auto noisy = sampled(many, [&](double h) { return 1 + h + (++k % 2 ? 0.05 : -0.05); });
  const Extrapolation e = extrapolate(noisy, 8, 64);
  EXPECT_GT(e.uncertainty, 0.05);
  EXPECT_LT(std::abs(e.finest - 1), e.uncertainty);
}

TEST(Extrapolation, OscillationHasNoConvergenceIndex) {
  int k = 0;
  const auto samples = sampled(doubled, [&](double h) { return ++k % 2 ? h : -h; });
  const Extrapolation e = extrapolate(samples, 8, 64);
  EXPECT_TRUE(std::isnan(e.convergence_index));
  EXPECT_THAT(e.remark, HasSubstr("not monotone"));
}

TEST(Extrapolation, ChangesThatGrowHaveNoConvergenceIndexAndNoOrder) {
  const Extrapolation e = extrapolate(sampled(doubled, [](double h) { return 1 / h; }), 8, 64);
  EXPECT_TRUE(std::isnan(e.convergence_index));
  EXPECT_THAT(e.remark, HasSubstr("changes do not shrink with the grid; free order at the edge of the scan"));
}

TEST(Extrapolation, FinestGridsThatAgreeHaveNoConvergenceIndex) {
  for (const double sign : {1., -1., 0.}) {
    const Extrapolation e = extrapolate(sampled(doubled, [=](double h) { return sign * std::max(h, 0.05); }), 8, 64);
    EXPECT_TRUE(std::isnan(e.convergence_index));
    EXPECT_THAT(e.remark, HasSubstr("the two finest grids agree")) << sign;
  }
  const auto nearly = [](double h) { return h > 0.05 ? h : 0.05 + 1e-12 * h; };
  EXPECT_THAT(extrapolate(sampled(doubled, nearly), 8, 64).remark, HasSubstr("hardly differ"));
}

TEST(Extrapolation, NeedsFourGridsOfTheWindow) {
  const auto samples = sampled(many, [](double h) { return h; });
  const Extrapolation e = extrapolate(samples, 30, 64);
  EXPECT_EQ(e.points, 3);
  EXPECT_THAT(e.model, HasSubstr("3 usable points"));
  EXPECT_TRUE(std::isnan(e.limit));
  EXPECT_EQ(extrapolate(samples, 16, 64).points, 5);
}

TEST(Extrapolation, OrderOfTheSamplesDoesNotMatter) {
  auto samples = sampled(many, [](double h) { return 2 + h + 0.1 * std::sin(9 * h); });
  const double before = extrapolate(samples, 8, 64).uncertainty;
  std::swap(samples.front(), samples.back());
  EXPECT_DOUBLE_EQ(extrapolate(samples, 8, 64).uncertainty, before);
}

}  // namespace mpmvv::fits::extrapolation_test
