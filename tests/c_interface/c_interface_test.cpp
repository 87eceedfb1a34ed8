#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "mms/c/mpmvv_mms.h"
#include "mms/catalogue.hpp"

namespace mpmvv::c_interface_test {

struct Destroy {
  void operator()(mpmvv_solution* solution) const { mpmvv_destroy(solution); }
};
using Solution = std::unique_ptr<mpmvv_solution, Destroy>;

Solution solution_named(const std::string& name, const mms::Values& values = {}) {
  std::vector<const char*> names;
  std::vector<double> numbers;
  for (const auto& [parameter, value] : values) names.push_back(parameter.c_str()), numbers.push_back(value);
  mpmvv_solution* made = nullptr;
  EXPECT_EQ(mpmvv_create(name.c_str(), static_cast<int>(names.size()), names.data(), numbers.data(), &made), MPMVV_OK)
      << mpmvv_message();
  return Solution(made);
}

/// Points that lie in every body of D dimensions of the catalogue, off its axes.
template <int D>
std::vector<mms::Vec<D>> points() {
  std::vector<mms::Vec<D>> all;
  for (const double s : {0.78, 0.83, 0.9}) all.push_back(s * mms::Vec<D>::LinSpaced(0.5, 0.7).normalized());
  return all;
}

TEST(CInterface, ListsTheCatalogue) {
  ASSERT_EQ(mpmvv_version(), MPMVV_MMS_VERSION);
  ASSERT_EQ(mpmvv_solution_count(), static_cast<int>(mms::catalogue().size()));
  for (int k = 0; k < mpmvv_solution_count(); ++k) {
    const mms::Entry& entry = mms::catalogue()[static_cast<std::size_t>(k)];
    EXPECT_EQ(mpmvv_solution_name(k), entry.name);
    EXPECT_EQ(mpmvv_solution_what(k), entry.what);
    EXPECT_EQ(mpmvv_solution_dimension(k), entry.dimension());
    ASSERT_EQ(mpmvv_parameter_count(k), static_cast<int>(entry.parameters.size()));
    for (int p = 0; p < mpmvv_parameter_count(k); ++p) {
      const mms::Parameter& parameter = entry.parameters[static_cast<std::size_t>(p)];
      EXPECT_EQ(mpmvv_parameter_name(k, p), parameter.name);
      EXPECT_EQ(mpmvv_parameter_unit(k, p), parameter.unit);
      EXPECT_EQ(mpmvv_parameter_range(k, p), parameter.range);
      EXPECT_EQ(mpmvv_parameter_default(k, p), parameter.value);
    }
  }
  for (const int beyond : {-1, mpmvv_solution_count()}) {
    EXPECT_EQ(mpmvv_solution_name(beyond), nullptr);
    EXPECT_EQ(mpmvv_solution_what(beyond), nullptr);
    EXPECT_EQ(mpmvv_solution_dimension(beyond), -1);
    EXPECT_EQ(mpmvv_parameter_count(beyond), -1);
    EXPECT_EQ(mpmvv_parameter_name(0, 99), nullptr);
    EXPECT_TRUE(std::isnan(mpmvv_parameter_default(beyond, 0)));
  }
}

template <int D>
void expect_fields_of(const mms::Entry& entry) {
  const mms::Values values = mms::complete(entry, {});
  const auto own = mms::make<D>(entry.name, values);
  const Solution solution = solution_named(std::string(entry.name));
  ASSERT_EQ(mpmvv_dimension(solution.get()), D);
  EXPECT_EQ(mpmvv_displacement_scale(solution.get()), own->displacement_scale());
  const std::vector<mms::Vec<D>> X = points<D>();
  const double t = 1e-3;
  std::vector<mms::Vec<D>> found(X.size()), N(X.size(), mms::Vec<D>::Unit(D - 1)), x(X.size());
  std::vector<double> matrix(X.size() * D * D);
  const auto expect_vectors = [&](auto function, const auto& expected) {
    ASSERT_EQ(function(solution.get(), X.size(), X[0].data(), t, found[0].data()), MPMVV_OK) << mpmvv_message();
    for (std::size_t p = 0; p < X.size(); ++p) EXPECT_EQ(found[p], expected(X[p])) << entry.name;
  };
  const auto expect_matrices = [&](auto function, const auto& expected) {
    ASSERT_EQ(function(solution.get(), X.size(), X[0].data(), t, matrix.data()), MPMVV_OK) << mpmvv_message();
    for (std::size_t p = 0; p < X.size(); ++p)
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t J = 0; J < D; ++J)
          EXPECT_EQ(matrix[p * D * D + i * D + J], expected(X[p])(static_cast<int>(i), static_cast<int>(J)));
  };
  expect_vectors(mpmvv_velocity, [&](const auto& at) { return own->v(at, t); });
  expect_vectors(mpmvv_acceleration, [&](const auto& at) { return own->a(at, t); });
  expect_vectors(mpmvv_body_force, [&](const auto& at) { return own->b(at, t); });
  expect_vectors(mpmvv_displacement, [&](const auto& at) { return own->u(at, t); });
  expect_matrices(mpmvv_deformation_gradient, [&](const auto& at) { return own->F(at, t); });
  expect_matrices(mpmvv_stress, [&](const auto& at) { return own->P(at, t); });
  for (std::size_t p = 0; p < X.size(); ++p) x[p] = X[p] + found[p] * 0 + own->u(X[p], t);
  ASSERT_EQ(mpmvv_traction(solution.get(), X.size(), X[0].data(), N[0].data(), t, found[0].data()), MPMVV_OK);
  for (std::size_t p = 0; p < X.size(); ++p) EXPECT_EQ(found[p], own->traction(X[p], N[p], t));
  ASSERT_EQ(mpmvv_reference_point(solution.get(), X.size(), x[0].data(), t, found[0].data()), MPMVV_OK);
  for (std::size_t p = 0; p < X.size(); ++p) EXPECT_LT((found[p] - X[p]).norm(), 1e-13);
}

TEST(CInterface, GivesTheFieldsOfEverySolution) {
  for (const mms::Entry& entry : mms::catalogue())
    std::visit([&]<int D>(mms::Make<D>) { expect_fields_of<D>(entry); }, entry.make);
}

TEST(CInterface, TakesParametersByName) {
  const Solution ring = solution_named("ring", {{"amplitude", 0.02}, {"poissons_ratio", 0.3}});
  EXPECT_EQ(mpmvv_parameter(ring.get(), "amplitude"), 0.02);
  EXPECT_EQ(mpmvv_parameter(ring.get(), "poissons_ratio"), 0.3);
  EXPECT_EQ(mpmvv_parameter(ring.get(), "inner_radius"), 0.5) << "its default";
  EXPECT_TRUE(std::isnan(mpmvv_parameter(ring.get(), "period")));
  EXPECT_TRUE(std::isnan(mpmvv_parameter(nullptr, "period")));
}

void expect_refusal(const char* name, const char* parameter, double value, mpmvv_status status, const char* message) {
  auto* made = reinterpret_cast<mpmvv_solution*>(&status);
  EXPECT_EQ(mpmvv_create(name, parameter ? 1 : 0, &parameter, &value, &made), status);
  EXPECT_EQ(made, nullptr);
  EXPECT_NE(std::string(mpmvv_message()).find(message), std::string::npos) << mpmvv_message();
}

TEST(CInterface, RefusesWhatMakesNoSolution) {
  expect_refusal("rings", nullptr, 0, MPMVV_UNKNOWN_NAME, "unknown solution 'rings' (known: bar, bar-rest, square");
  expect_refusal("ring", "radius", 1, MPMVV_UNKNOWN_NAME, "'radius' of 'ring' (known: amplitude, inner_radius");
  expect_refusal("ring", "density", -1, MPMVV_BAD_VALUE, "'density' of 'ring' is -1 (> 0)");
  expect_refusal("ring", "density", std::nan(""), MPMVV_BAD_VALUE, "'density' of 'ring' is nan (> 0)");
  expect_refusal("ring", "inner_radius", 2, MPMVV_BAD_VALUE, "inner_radius 2 is not below outer_radius 1");
  expect_refusal("square", "amplitude", 0.4, MPMVV_BAD_VALUE, "is 0.4 (between -1/pi and 1/pi");
  expect_refusal(nullptr, nullptr, 0, MPMVV_BAD_ARGUMENT, "a null pointer");
  EXPECT_EQ(mpmvv_create("ring", 0, nullptr, nullptr, nullptr), MPMVV_BAD_ARGUMENT);
  mpmvv_solution* made = nullptr;
  EXPECT_EQ(mpmvv_create("ring", 1, nullptr, nullptr, &made), MPMVV_BAD_ARGUMENT);
  EXPECT_EQ(mpmvv_create("ring", -1, nullptr, nullptr, &made), MPMVV_BAD_ARGUMENT);
  EXPECT_STREQ(mpmvv_message(), "mpmvv_create: a negative number of parameters");
}

TEST(CInterface, SaysWhatIsWrongAtAPoint) {
  const Solution ring = solution_named("ring");
  const double X[]{0.6, 0.1, 0, 0};
  double b[4];
  EXPECT_EQ(mpmvv_body_force(ring.get(), 2, X, 1e-3, b), MPMVV_NOT_FINITE) << "the middle of the ring";
  EXPECT_STREQ(mpmvv_message(), "mpmvv_body_force is not finite at point 1 (points of the body, a time nearer to 0)");
  EXPECT_EQ(mpmvv_body_force(ring.get(), 1, X, std::nan(""), b), MPMVV_BAD_ARGUMENT);
  const double astray[]{0.2, 0.3, std::nan(""), 0.3};
  const Solution inverse = solution_named("square-inverse");
  EXPECT_EQ(mpmvv_displacement(inverse.get(), 2, astray, 1e-3, b), MPMVV_BAD_ARGUMENT);
  EXPECT_STREQ(mpmvv_message(), "mpmvv_displacement: a coordinate of point 1 is not a finite number");
  const double beyond[]{9, 9};
  EXPECT_EQ(mpmvv_reference_point(ring.get(), 1, beyond, 0.01, b), MPMVV_NOT_FINITE) << "out of reach";
  EXPECT_STREQ(mpmvv_message(), "no reference point found: the position is outside the body");
  EXPECT_EQ(mpmvv_traction(ring.get(), 1, X, nullptr, 0, b), MPMVV_BAD_ARGUMENT);
  EXPECT_EQ(mpmvv_traction(ring.get(), 1, X, astray + 1, 0, b), MPMVV_BAD_ARGUMENT);
  EXPECT_STREQ(mpmvv_message(), "mpmvv_traction: a component of the normal at point 0 is not a finite number");
  EXPECT_EQ(mpmvv_body_force(nullptr, 1, X, 0, b), MPMVV_BAD_ARGUMENT);
  EXPECT_EQ(mpmvv_body_force(ring.get(), 1, nullptr, 0, b), MPMVV_BAD_ARGUMENT);
  EXPECT_EQ(mpmvv_body_force(ring.get(), 0, nullptr, 0, nullptr), MPMVV_OK) << "no points, no arrays";
  mpmvv_destroy(nullptr);
}

TEST(CInterface, KeepsAMessageForEachThread) {
  expect_refusal("rings", nullptr, 0, MPMVV_UNKNOWN_NAME, "rings");
  std::thread([] {
    EXPECT_STREQ(mpmvv_message(), "");
    expect_refusal("bars", nullptr, 0, MPMVV_UNKNOWN_NAME, "bars");
  }).join();
  EXPECT_NE(std::string(mpmvv_message()).find("rings"), std::string::npos);
}

/// Least time of some passes, s.
double least_time(const auto& pass) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 15; ++k) {
    const auto start = std::chrono::steady_clock::now();
    pass();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

TEST(CInterfaceNightly, ManyPointsCostWhatTheyDoInCpp) {
  const auto own = mms::make<2>("ring", mms::complete(mms::entry_named("ring"), {}));
  const Solution ring = solution_named("ring");
  std::vector<mms::Vec<2>> X(20'000, mms::Vec<2>(0.6, 0.3)), b(X.size());
  const double in_cpp = least_time([&] {
    for (std::size_t p = 0; p < X.size(); ++p) b[p] = own->b(X[p], 1e-3);
  });
  const double in_c = least_time([&] { mpmvv_body_force(ring.get(), X.size(), X[0].data(), 1e-3, b[0].data()); });
  EXPECT_LT(in_c, 1.5 * in_cpp);
}

}  // namespace mpmvv::c_interface_test
