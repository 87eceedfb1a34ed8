#include "solver/kernels/add_mass_product.hpp"
#include "solver/kernels/advance_stage.hpp"
#include "solver/kernels/block_kernels.hpp"
#include "solver/kernels/map_to_grid.hpp"
#include "solver/kernels/update_particles.hpp"
#include "tests/solver/each_basis.hpp"
#include "tests/solver/moved_body.hpp"

/// Kernels against their equations written down plainly, every particle with every node that it reaches.
namespace mpmvv::solver::kernels_test {

/// Another one on each particle.
template <int D>
struct SomeForce final : BodyForce<D> {
  void on_particles(double, std::span<const std::uint32_t> ids, std::span<const Vec<D>>, Vec<D>* b) const override {
    for (const auto id : ids) *b++ = at_id(id);
  }
  Vec<D> at_position(const Vec<D>&, double) const override { return Vec<D>::Zero(); }
  static Vec<D> at_id(std::uint32_t id) { return Vec<D>::Constant(std::sin(3.0 * id)); }
};

/// The first `rows` of each.
template <int rows>
auto heads(const auto& field) {
  Array<Vec<rows>> all;
  for (const auto& value : field) all.push_back(value.template head<rows>());
  return all;
}

/// m_i, p_i and f_i of these stresses and body forces.
template <int D>
void expect_mapped(const MovedBody<D>& body, const Array<Mat<D>>& tau, const Array<Vec<D>>& b) {
  const auto& particles = body.particles;
  Array<Vec<D + 1>> momentum(body.grid.size(), Vec<D + 1>::Zero());
  Array<Vec<D>> force(body.grid.size(), Vec<D>::Zero());
  for (std::size_t p = 0; p < particles.size(); ++p)
    for (const auto& [n, N, dN] : body.weights[p]) {
      momentum[n].template head<D>() += N * particles.m[p] * particles.v[p];
      momentum[n][D] += N * particles.m[p];
      force[n] += N * particles.m[p] * b[p] - particles.V0[p] * tau[p] * dN;
    }
  expect_near<D + 1>(heads<D + 1>(body.grid.p), momentum, "momentum");
  expect_near<D>(heads<D>(body.grid.f), force, "force");
}

template <int D>
void expect_to_map(const AnyBasis& basis, const AnyMaterial& material, const BodyForce<D>* force) {
  MovedBody<D> body(basis);
  auto& particles = body.particles;
  Array<Mat<D>> tau;
  Array<Vec<D>> b;
  std::visit(
      [&]<class M>(const M& m) {
        if constexpr (has_history<M>) particles.thermal.assign(particles.size(), m.state_at_rest());
        for (std::size_t p = 0; p < particles.size(); ++p) {
          b.push_back(force ? SomeForce<D>::at_id(particles.id[p]) : Vec<D>(Vec<D>::Zero()));
          if constexpr (has_history<M>) {
            ThermalState state = particles.thermal[p];
            tau.push_back(m.kirchhoff(particles.F[p], state, StressStep{1, body.grid.h()}));
          } else {
            tau.push_back(m.kirchhoff(particles.F[p]));
          }
        }
      },
      material);
  body.visit({EvaluateStress<D>{particles, material, 1}, EvaluateBodyForce<D>{particles, force, 0},
              Fused{MapMomentum<D>{particles, body.grid}, MapForces<D>{particles, body.grid}}});
  expect_mapped(body, tau, b);
}

template <int D>
void expect_to_map_either_way(const AnyBasis& basis) {
  const SomeForce<D> force;
  expect_to_map<D>(basis, NeoHookeanLog{3000, 4000}, &force);
  expect_to_map<D>(basis, MieGruneisen{.bulk_modulus = 1e4, .gamma = 1}, nullptr);
}

/// x, v and F of a body and what they should be.
template <int D>
struct Expected {
  Array<Vec<D>> x, v;
  Array<Mat<D>> F;

  explicit Expected(const Particles<D>& particles) : x(particles.x), v(particles.v), F(particles.F) {}

  void compare(const Particles<D>& found) const {
    expect_near<D>(found.x, x, "position");
    expect_near<D>(found.v, v, "velocity");
    expect_near<D>(found.F, F, "deformation");
  }
};

/// A velocity update with each of its fields once, and `flip` in both of its forms.
template <int D, bool is_flip>
void expect_to_move(const AnyBasis& basis, Deformation rule, const auto& fields_of) {
  MovedBody<D> body(basis);
  const VelocityFields<D> fields = fields_of(body.grid);
  ASSERT_TRUE(!is_flip || are_flip(fields, body.grid));
  const double dt = 0.004;
  const DeformationStep deform{0.01, rule};
  Expected<D> expected(body.particles);
  for (std::size_t p = 0; p < body.particles.size(); ++p) {
    const Vec<D> V = expected.v[p];
    Vec<D>& V_new = expected.v[p];
    V_new = body.value(p, fields.velocity ? *fields.velocity : body.grid.v);
    if (fields.acceleration) V_new = V + dt * body.value(p, *fields.acceleration);
    expected.x[p] += dt * (fields.before * V + fields.after * V_new);
    if (fields.drift) expected.x[p] += dt * body.value(p, *fields.drift);
    const Mat<D> F = expected.F[p], L = body.gradient(p, body.grid.v);
    expected.F[p] =
        rule == Deformation::linear ? deform.by<Deformation::linear>(F, L) : deform.by<Deformation::exponential>(F, L);
  }
  body.visit({UpdateParticle<D, is_flip>{body.particles, body.grid, fields, dt},
              UpdateDeformation<D>{body.particles, deform}});
  expected.compare(body.particles);

  MovedBody<D> by_two(basis, false);  // the gradient by a kernel of its own, velocity and position by another
  const VelocityFields<D> same = fields_of(by_two.grid);
  by_two.visit({EvaluateVelocityGradient<D>{by_two.particles, by_two.grid},
                UpdateDeformation<D>{by_two.particles, deform},
                UpdateVelocityAndPosition<D, is_flip>{by_two.particles, by_two.grid, same, dt}});
  expected.compare(by_two.particles);

  MovedBody<D> by_rate(basis, false);  // the position by the rate that is kept
  by_rate.particles.rate.resize(by_rate.particles.size());
  by_rate.visit({EvaluateVelocityGradient<D>{by_rate.particles, by_rate.grid},
                 UpdateDeformation<D>{by_rate.particles, deform},
                 UpdateVelocityAndRate<D>{by_rate.particles, by_rate.grid, fields_of(by_rate.grid), dt},
                 MoveByRate<D>{by_rate.particles, dt}});
  expected.compare(by_rate.particles);
}

template <int D>
void expect_to_move_by_any_fields(const AnyBasis& basis) {
  using Fields = VelocityFields<D>;
  const auto flip = [](const Grid<D>& grid) { return Fields{.acceleration = &grid.a, .drift = &grid.v}; };
  expect_to_move<D, true>(basis, Deformation::linear, flip);
  expect_to_move<D, true>(basis, Deformation::exponential, flip);
  expect_to_move<D, false>(basis, Deformation::exponential, flip);
  expect_to_move<D, false>(basis, Deformation::linear, [](const Grid<D>& grid) {
    return Fields{.acceleration = &grid.a, .before = 0.3, .after = 0.7};
  });
  expect_to_move<D, false>(basis, Deformation::linear, [](const Grid<D>& grid) {
    return Fields{.velocity = &grid.a, .drift = &grid.v, .before = -0.5, .after = 0.5};
  });
  expect_to_move<D, false>(basis, Deformation::linear, [](const Grid<D>&) { return Fields{.after = 1}; });
}

/// W (18), then x and F by the same velocity: the sweeps of `uvf`.
template <int D>
void expect_to_move_velocity_first(const AnyBasis& basis) {
  MovedBody<D> body(basis);
  Expected<D> expected(body.particles);
  const DeformationStep deform{0.01, Deformation::linear};
  for (std::size_t p = 0; p < body.particles.size(); ++p) {
    expected.v[p] += 0.1 * body.value(p, body.grid.a);
    expected.x[p] += 0.1 * body.value(p, body.grid.v);
    expected.F[p] += 0.01 * body.gradient(p, body.grid.v) * expected.F[p];
  }
  body.visit({UpdateVelocity<D>{body.particles, body.grid, 0.1}, UpdatePosition<D>{body.particles, body.grid, 0.1},
              UpdateDeformation<D>{body.particles, deform}});
  expected.compare(body.particles);
}

template <int D>
void expect_mass_products(const AnyBasis& basis) {
  MovedBody<D> body(basis);
  Array<Vec<D>> product(body.grid.size(), Vec<D>::Zero());
  for (std::size_t p = 0; p < body.particles.size(); ++p)
    for (const auto& [n, N, dN] : body.weights[p]) product[n] += N * body.particles.m[p] * body.value(p, body.grid.v);
  body.visit({AddMassProduct<D>{body.particles, body.grid.v, body.grid.f}});
  expect_near<D>(heads<D>(body.grid.f), product, "product");
}

/// Of one number on each node, in the component of the mass.
template <int D>
void expect_scalar_mass_products(const AnyBasis& basis) {
  MovedBody<D> body(basis);
  Array<Padded<D + 1>> u(body.grid.size());
  for (std::size_t n = 0; n < u.size(); ++n) u[n] = padded_alone<D>(std::sin(static_cast<double>(n)));
  Array<Vec<D + 1>> product(u.size(), Vec<D + 1>::Zero());
  for (std::size_t p = 0; p < body.particles.size(); ++p) {
    double sum = 0;
    for (const auto& w : body.weights[p]) sum += w.N * u[w.n][D];
    for (const auto& w : body.weights[p]) product[w.n][D] += w.N * body.particles.m[p] * sum;
  }
  body.visit({AddMassProduct<D, Padded<D + 1>>{body.particles, u, body.grid.p}});
  expect_near<D + 1>(heads<D + 1>(body.grid.p), product, "product");
}

/// y' = y^n + next k and the sum of the weighted rates; without a next stage the sum itself.
template <int D>
void expect_stages(const AnyBasis& basis) {
  for (const std::optional<double> next : {std::optional(0.006), std::optional<double>()}) {
    MovedBody<D> body(basis);
    body.particles.start_stages();
    Expected<D> now(body.particles), sum(body.particles);
    for (std::size_t p = 0; p < body.particles.size(); ++p) {
      const Vec<D> v = body.value(p, body.grid.v), a = body.value(p, body.grid.a);
      const Mat<D> rate = body.gradient(p, body.grid.v) * now.F[p];
      sum.x[p] += 0.004 * v, sum.v[p] += 0.004 * a, sum.F[p] += 0.004 * rate;
      now.x[p] = next ? Vec<D>(now.x[p] + *next * v) : sum.x[p];
      now.v[p] = next ? Vec<D>(now.v[p] + *next * a) : sum.v[p];
      now.F[p] = next ? Mat<D>(now.F[p] + *next * rate) : sum.F[p];
    }
    body.visit({AdvanceStage<D>{body.particles, body.grid, 0.004, next}});
    now.compare(body.particles);
    expect_near<D>(body.particles.stages.sum.F, sum.F, "sum");
  }
}

class Kernels : public WithEachBasis {
 protected:
  template <class Check>
  void in_every_dimension(const Check& check) {
    check(Dimension<1>{}), check(Dimension<2>{}), check(Dimension<3>{});
  }
};
INSTANTIATE_TEST_SUITE_P(, Kernels, every_basis(), word_in_name);

TEST_P(Kernels, MapMomentumAndForces) {
  in_every_dimension([this]<int D>(Dimension<D>) { expect_to_map_either_way<D>(basis); });
}
TEST_P(Kernels, UpdateParticles) {
  in_every_dimension([this]<int D>(Dimension<D>) { expect_to_move_by_any_fields<D>(basis); });
}
TEST_P(Kernels, UpdateVelocityFirst) {
  in_every_dimension([this]<int D>(Dimension<D>) { expect_to_move_velocity_first<D>(basis); });
}
TEST_P(Kernels, MultiplyByTheMass) {
  in_every_dimension([this]<int D>(Dimension<D>) {
    expect_mass_products<D>(basis);
    expect_scalar_mass_products<D>(basis);
  });
}
TEST_P(Kernels, AdvanceAStageOfRungeAndKutta) {
  in_every_dimension([this]<int D>(Dimension<D>) { expect_stages<D>(basis); });
}

}  // namespace mpmvv::solver::kernels_test
