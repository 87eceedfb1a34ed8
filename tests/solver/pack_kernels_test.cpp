#include <tuple>

#include "solver/consistent_mass.hpp"
#include "solver/integrator/rk4.hpp"
#include "solver/kernels/node_kernels.hpp"
#include "solver/velocity_update/update_particle.hpp"
#include "tests/solver/moved_body.hpp"

/// The operations that take part in fewer schemes than those of companies_test.cpp, with one basis.
namespace mpmvv::solver::company_operations_test {

template <class OfSpace>
class CompanyOperations : public ::testing::Test {
 protected:
  using Body = MovedBody<OfSpace::value, BSpline2>;

  Body together, alone;

  /// Takes both bodies through the operations that `operations_of` gives, packed in a tuple.
  void operate(const auto& operations_of) {
    for (Body* body : {&together, &alone})
      std::apply([&](const auto&... ops) { body->visit(body == &together, NoStage{}, ops...); }, operations_of(*body));
  }

  void expect_same_motion() const {
    constexpr int D = OfSpace::value;
    expect_near<D>(together.particles.x, alone.particles.x, "position");
    expect_near<D>(together.particles.v, alone.particles.v, "velocity");
    expect_near<D>(together.particles.F, alone.particles.F, "deformation");
  }
};

TYPED_TEST_SUITE(CompanyOperations, TestedDimensions);

TYPED_TEST(CompanyOperations, MapMassAlone) {
  constexpr int D = TypeParam::value;
  this->operate([](auto& body) { return std::tuple{MapMass<D>{body.particles, body.grid}}; });
  expect_near<D + 1>(this->together.grid.p, this->alone.grid.p, "mass");
}

TYPED_TEST(CompanyOperations, MapAScalarThereAndBack) {
  constexpr int D = TypeParam::value;
  std::vector<double> u(this->alone.grid.size());
  for (std::size_t n = 0; n < u.size(); ++n) u[n] = std::sin(static_cast<double>(n));
  this->operate([&](auto& body) { return std::tuple{MapScalarMassProduct<D>{body.particles, u, body.grid.p}}; });
  expect_near<D + 1>(this->together.grid.p, this->alone.grid.p, "product");
}

TYPED_TEST(CompanyOperations, AdvanceAStageOfRungeAndKutta) {
  constexpr int D = TypeParam::value;
  for (auto* body : {&this->together, &this->alone}) body->particles.start_stages();
  for (const double next : {0.006, 0.0})
    this->operate([&](auto& body) { return std::tuple{AdvanceStage<D>{body.particles, body.grid, 0.004, next}}; });
  this->expect_same_motion();
  expect_near<D>(this->together.particles.stages.sum.F, this->alone.particles.stages.sum.F, "sum");
}

TYPED_TEST(CompanyOperations, UpdateParticlesByAnyFields) {
  constexpr int D = TypeParam::value;
  using Fields = VelocityFields<D>;
  const auto& grid = this->alone.grid;
  for (const Fields& fields : {Fields{&grid.a, nullptr, nullptr, 0.3, 0.7}, Fields{nullptr, &grid.v, &grid.a, 0, 1},
                               Fields{nullptr, nullptr, &grid.v, 0, 0}})
    this->operate([&](auto& body) {
      return std::tuple{UpdateParticle<D>{body.particles, body.grid, fields, 0.004, {0.01, Deformation::linear}}};
    });
  this->expect_same_motion();
}

TYPED_TEST(CompanyOperations, UpdateVelocityPositionAndDeformationApart) {
  constexpr int D = TypeParam::value;
  const VelocityFields<D> fields{&this->alone.grid.a, nullptr, nullptr, 0.5, 0.5};
  for (auto* body : {&this->together, &this->alone}) body->particles.rate.resize(body->particles.size());
  this->operate([&](auto& body) {
    return std::tuple{UpdateVelocityAndPosition<D>{body.particles, body.grid, fields, 0.004},
                      UpdateDeformation<D>{body.particles, body.grid, {0.01, Deformation::exponential}}};
  });
  this->operate([&](auto& body) { return std::tuple{UpdateVelocityAndRate<D>{body.particles, body.grid, fields}}; });
  this->operate([&](auto& body) {
    return std::tuple{MoveByRate<D>{body.particles, 0.004}, UpdatePosition<D>{body.particles, body.grid, 0.004}};
  });
  this->expect_same_motion();
  expect_near<D>(this->together.particles.rate, this->alone.particles.rate, "rate");
}

TYPED_TEST(CompanyOperations, CarryAffineFields) {
  constexpr int D = TypeParam::value;
  for (auto* body : {&this->together, &this->alone}) {
    body->particles.C.resize(body->particles.size());
    for (std::size_t p = 0; p < body->particles.size(); ++p)
      body->particles.C[p].setConstant(std::cos(static_cast<double>(p)));
  }
  const VelocityFields<D> fields{nullptr, &this->alone.grid.v, nullptr, 0, 1};
  this->operate([](auto& body) { return std::tuple{MapMomentum<D>{body.particles, body.grid}}; });
  this->operate([&](auto& body) {
    return std::tuple{UpdateParticle<D>{body.particles, body.grid, fields, 0.004, {0.01, Deformation::linear}}};
  });
  expect_near<D + 1>(this->together.grid.p, this->alone.grid.p, "momentum");
  expect_near<D>(this->together.particles.C, this->alone.particles.C, "affine field");
  this->expect_same_motion();
}

}  // namespace mpmvv::solver::company_operations_test
