#include "solver/kernels/add_mass_product.hpp"
#include "solver/kernels/advance_stage.hpp"
#include "solver/kernels/map_to_grid.hpp"
#include "solver/kernels/update_particles.hpp"
#include "tests/solver/moved_body.hpp"

/// The kernels that take part in fewer schemes than those of particle_pack_test.cpp, with one basis.
namespace mpmvv::solver::pack_kernels_test {

template <class OfSpace>
class PackKernels : public ::testing::Test {
 protected:
  using Body = MovedBody<OfSpace::value, BSpline2>;

  Body together, alone;

  /// Takes both bodies, one in packs, through the kernels that `kernels_of` makes, each in a sweep of its own.
  void run(const auto&... kernels_of) {
    for (Body* body : {&together, &alone}) (body->visit(body == &together, {kernels_of(*body)}), ...);
  }

  void expect_same_motion() const {
    constexpr int D = OfSpace::value;
    expect_near<D>(together.particles.x, alone.particles.x, "position");
    expect_near<D>(together.particles.v, alone.particles.v, "velocity");
    expect_near<D>(together.particles.F, alone.particles.F, "deformation");
  }
};

TYPED_TEST_SUITE(PackKernels, TestedDimensions);

TYPED_TEST(PackKernels, MapMassWithoutMomentum) {
  constexpr int D = TypeParam::value;
  const AnyMaterial material = NeoHookeanLog{0, 1};
  for (auto* body : {&this->together, &this->alone})
    body->visit(body == &this->together,
                {EvaluateStress<D>{body->particles, material, 1}, EvaluateBodyForce<D>{body->particles, nullptr, 0},
                 Fused{MapMass<D>{body->particles, body->grid}, MapForces<D>{body->particles, body->grid}}});
  expect_near<D + 1>(this->together.grid.p, this->alone.grid.p, "mass");
}

TYPED_TEST(PackKernels, MapAScalarThereAndBack) {
  constexpr int D = TypeParam::value;
  std::vector<double> u(this->alone.grid.size());
  for (std::size_t n = 0; n < u.size(); ++n) u[n] = std::sin(static_cast<double>(n));
  this->run([&](auto& body) { return AddScalarMassProduct<D>{body.particles, u, body.grid.p}; });
  expect_near<D + 1>(this->together.grid.p, this->alone.grid.p, "product");
}

TYPED_TEST(PackKernels, AdvanceAStageOfRungeAndKutta) {
  constexpr int D = TypeParam::value;
  for (auto* body : {&this->together, &this->alone}) body->particles.start_stages();
  for (const std::optional<double> next : {std::optional(0.006), std::optional<double>()})
    this->run([&](auto& body) { return AdvanceStage<D>{body.particles, body.grid, 0.004, next}; });
  this->expect_same_motion();
  expect_near<D>(this->together.particles.stages.sum.F, this->alone.particles.stages.sum.F, "sum");
}

TYPED_TEST(PackKernels, UpdateParticlesByAnyFields) {
  constexpr int D = TypeParam::value;
  using Fields = VelocityFields<D>;
  const auto& grid = this->alone.grid;
  for (const Fields& fields : {Fields{&grid.a, nullptr, nullptr, 0.3, 0.7}, Fields{nullptr, &grid.v, &grid.a, 0, 1},
                               Fields{nullptr, nullptr, &grid.v, 0, 0}})
    this->run([&](auto& body) {
      return UpdateParticle<D, false>{body.particles, body.grid, fields, 0.004, {0.01, Deformation::linear}};
    });
  this->expect_same_motion();
}

/// As by fields that are not known to be these.
TYPED_TEST(PackKernels, UpdateParticlesByFlip) {
  constexpr int D = TypeParam::value;
  const auto fields_of = [](const auto& body) {
    return VelocityFields<D>{.acceleration = &body.grid.a, .drift = &body.grid.v};
  };
  const DeformationStep<D> deform{0.01, Deformation::linear};
  ASSERT_TRUE(are_flip(fields_of(this->alone), this->alone.grid));
  this->together.visit(true, {UpdateParticle<D, true>{this->together.particles, this->together.grid,
                                                      fields_of(this->together), 0.004, deform}});
  this->alone.visit(false, {UpdateParticle<D, false>{this->alone.particles, this->alone.grid, fields_of(this->alone),
                                                     0.004, deform}});
  this->expect_same_motion();
}

TYPED_TEST(PackKernels, UpdateVelocityPositionAndDeformationApart) {
  constexpr int D = TypeParam::value;
  const VelocityFields<D> fields{&this->alone.grid.a, nullptr, nullptr, 0.5, 0.5};
  for (auto* body : {&this->together, &this->alone}) body->particles.rate.resize(body->particles.size());
  this->run(
      [&](auto& body) {
        return UpdateVelocityAndPosition<D, false>{body.particles, body.grid, fields, 0.004};
      },
      [&](auto& body) {
        return UpdateDeformation<D>{body.particles, body.grid, {0.01, Deformation::exponential}};
      },
      [&](auto& body) {
        return UpdateVelocityAndRate<D>{body.particles, body.grid, fields, 0.004};
      },
      [&](auto& body) {
        return MoveByRate<D>{body.particles, 0.004};
      });
  this->expect_same_motion();
  expect_near<D>(this->together.particles.rate, this->alone.particles.rate, "rate");
}

TYPED_TEST(PackKernels, CarryAffineFields) {
  constexpr int D = TypeParam::value;
  for (auto* body : {&this->together, &this->alone}) {
    body->particles.C.resize(body->particles.size());
    for (std::size_t p = 0; p < body->particles.size(); ++p)
      body->particles.C[p].setConstant(std::cos(static_cast<double>(p)));
  }
  const VelocityFields<D> fields{nullptr, &this->alone.grid.v, nullptr, 0, 1};
  this->run(
      [](auto& body) {
        return MapMomentum<D>{body.particles, body.grid};
      },
      [&](auto& body) {
        return UpdateParticle<D, false>{body.particles, body.grid, fields, 0.004, {0.01, Deformation::linear}};
      });
  expect_near<D + 1>(this->together.grid.p, this->alone.grid.p, "momentum");
  expect_near<D>(this->together.particles.C, this->alone.particles.C, "affine field");
  this->expect_same_motion();
}

}  // namespace mpmvv::solver::pack_kernels_test
