#include <functional>

#include "mms/at_rest.hpp"
#include "mms/bar.hpp"
#include "mms/cube.hpp"
#include "mms/derived.hpp"
#include "mms/inverse.hpp"
#include "mms/radial.hpp"
#include "mms/square.hpp"
#include "mms/vortex.hpp"
#include "studies/checks/basis_function.hpp"
#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"

namespace mpmvv::checks {

namespace {

/// The largest difference of one field between two solutions, and the largest norm of the field.
struct Field {
  const char* name;
  double difference = 0, scale = 0;

  template <class T>
  void add(const T& closed, const T& derived) {
    keep_larger(difference, (closed - derived).norm());
    keep_larger(scale, derived.norm());
  }
};

/// Returns a random reference point of a body.
template <int D>
using Place = std::function<mms::Vec<D>(Random&)>;

template <int D>
mms::Vec<D> in_unit_cell(Random& random) {
  mms::Vec<D> X;
  for (int d = 0; d < D; ++d) X[d] = random.uniform(0, 1);
  return X;
}

template <int D>
Place<D> between(const mms::Radii& radii) {
  return [radii](Random& random) {
    mms::Vec<D> X;
    do {
      for (int d = 0; d < D; ++d) X[d] = random.uniform(-radii.outer, radii.outer);
    } while (X.norm() < radii.inner || X.norm() > radii.outer);
    return X;
  };
}

/// Adds, for each field, the largest difference between closed form and derived solution over random points and times,
/// divided by the largest norm of that field.
template <int D, class Displacement>
void compare(CheckResult& result, const std::string& name, const mms::ManufacturedSolution<D>& closed,
             const Displacement& displacement, const mms::Elasticity& material, double period, const Place<D>& place) {
  const auto derived = mms::derived<D>(displacement, material, closed.displacement_scale());
  Field u{"u"}, v{"v"}, a{"a"}, F{"F"}, P{"P"}, b{"b"};
  Random random(20150);
  for (int k = 0; k < 2000; ++k) {
    const mms::Vec<D> X = place(random);
    const double t = random.uniform(0, period);
    u.add(closed.u(X, t), derived.u(X, t));
    v.add(closed.v(X, t), derived.v(X, t));
    a.add(closed.a(X, t), derived.a(X, t));
    F.add(closed.F(X, t), derived.F(X, t));
    P.add(closed.P(X, t), derived.P(X, t));
    b.add(closed.b(X, t), derived.b(X, t));
  }
  for (const Field& field : {u, v, a, F, P, b})
    result.add(name + "_" + field.name, field.difference / field.scale,
               name + ": largest relative difference of " + field.name + ", closed form and derived, 2000 points");
}

constexpr double wave_speed = 100, period = 2 / wave_speed;

mms::Elasticity material_with(double poissons_ratio) {
  return {wave_speed * wave_speed, poissons_ratio, 1};
}

template <int D, class Closed, class Displacement>
void compare_in_unit_cell(CheckResult& result, const std::string& name, double amplitude, double poissons_ratio) {
  const auto material = material_with(poissons_ratio);
  compare<D>(result, name, Closed(amplitude, material), Displacement{amplitude, wave_speed}, material, period,
             &in_unit_cell<D>);
}

template <int D>
void compare_radial(CheckResult& result, const std::string& name, double amplitude, double poissons_ratio) {
  const auto material = material_with(poissons_ratio);
  const mms::Radii radii(0.5, 1);
  compare<D>(result, name, mms::Radial<D>(amplitude, radii, material),
             mms::RadialDisplacement<D>{amplitude, radii, wave_speed}, material, period, between<D>(radii));
}

void compare_from_rest(CheckResult& result) {
  using BarDisplacement = mms::AtRestDisplacement<1, 2>;
  using SquareDisplacement = mms::AtRestDisplacement<2, 1>;
  using CubeDisplacement = mms::AtRestDisplacement<3, 2>;
  using InverseDisplacement = mms::SquareInverseDisplacement;
  compare_in_unit_cell<1, mms::BarAtRest, BarDisplacement>(result, "bar_rest", 0.05, 0);
  compare_in_unit_cell<1, mms::BarAtRest, BarDisplacement>(result, "bar_rest_large", 0.15, 0);
  compare_in_unit_cell<2, mms::SquareAtRest, SquareDisplacement>(result, "square_rest", 0.02, 0.3);
  compare_in_unit_cell<2, mms::SquareAtRest, SquareDisplacement>(result, "square_rest_large", 0.3, 0.3);
  compare_in_unit_cell<3, mms::CubeAtRest, CubeDisplacement>(result, "cube_rest", 0.02, 0.3);
  compare_in_unit_cell<3, mms::CubeAtRest, CubeDisplacement>(result, "cube_rest_large", 0.15, 0.3);
  compare_in_unit_cell<2, mms::SquareInverse, InverseDisplacement>(result, "square_inverse", 0.02, 0.3);
  compare_in_unit_cell<2, mms::SquareInverse, InverseDisplacement>(result, "square_inverse_large", 0.3, 0.3);
}

void compare_vortex(CheckResult& result) {
  const mms::Elasticity material{1000, 0.3, 1000};
  const mms::Radii radii(0.75, 1.25);
  constexpr double amplitude = 1, turning_time = 1;
  compare<2>(result, "vortex", mms::Vortex(amplitude, radii, turning_time, material),
             mms::VortexDisplacement{amplitude, radii, turning_time}, material, 2 * turning_time, between<2>(radii));
}

}  // namespace

/// Compares closed forms with solutions derived from the displacement and a stored energy alone, claim X-derive.
CheckResult check_derived_solutions() {
  CheckResult result;
  compare_in_unit_cell<1, mms::Bar, mms::BarDisplacement>(result, "bar", 0.05, 0);
  compare_in_unit_cell<1, mms::Bar, mms::BarDisplacement>(result, "bar_large", 0.15, 0);
  compare_in_unit_cell<2, mms::Square, mms::SquareDisplacement>(result, "square", 0.1, 0.3);
  compare_in_unit_cell<2, mms::Square, mms::SquareDisplacement>(result, "square_large", 0.3, 0.3);
  compare_in_unit_cell<3, mms::Cube, mms::CubeDisplacement>(result, "cube", 0.05, 0.3);
  compare_in_unit_cell<3, mms::Cube, mms::CubeDisplacement>(result, "cube_large", 0.15, 0.3);
  compare_from_rest(result);
  compare_radial<2>(result, "ring", 0.1, 0);
  compare_radial<2>(result, "ring_nu", 0.1, 0.3);
  compare_radial<2>(result, "ring_large", 0.38, 0.3);
  compare_radial<3>(result, "shell", 0.1, 0.3);
  compare_radial<3>(result, "shell_large", 0.38, 0.3);
  compare_vortex(result);
  return result;
}

}  // namespace mpmvv::checks
