#include <algorithm>

#include "mms/bar.hpp"
#include "mms/cube.hpp"
#include "mms/derived.hpp"
#include "mms/square.hpp"
#include "studies/check.hpp"
#include "studies/checks/basis_function.hpp"

namespace mpmvv {

namespace {

/// How far one field of two solutions differs, and how large it is.
struct Field {
  const char* name;
  double difference = 0, scale = 0;

  template <class T>
  void add(const T& closed, const T& derived) {
    difference = std::max(difference, (closed - derived).norm());
    scale = std::max(scale, derived.norm());
  }
};

/// Largest difference of each field over random points of the unit cell and times, over the largest value of that
/// field.
template <int D, class Closed, class Displacement>
void compare(CheckResult& result, const std::string& name, double amplitude, double poissons_ratio) {
  const mms::Elasticity material{1e4, poissons_ratio, 1};
  const double wave_speed = 100, period = 2 / wave_speed;
  const Closed closed(amplitude, material);
  const mms::Derived<D, Displacement, mms::NeoHookeanLogEnergy> derived(
      {amplitude, wave_speed}, {material.lambda(), material.mu()}, material.density, amplitude);
  Field u{"u"}, v{"v"}, a{"a"}, F{"F"}, P{"P"}, b{"b"};
  Random random(20150);
  for (int k = 0; k < 2000; ++k) {
    mms::Vec<D> X;
    for (int d = 0; d < D; ++d) X[d] = random.uniform(0, 1);
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

}  // namespace

/// X-derive: closed forms against derivation from the displacement and an energy alone.
CheckResult check_derived_solutions() {
  CheckResult result;
  compare<1, mms::Bar, mms::BarDisplacement>(result, "bar", 0.05, 0);
  compare<1, mms::Bar, mms::BarDisplacement>(result, "bar_large", 0.15, 0);
  compare<2, mms::Square, mms::SquareDisplacement>(result, "square", 0.1, 0.3);
  compare<2, mms::Square, mms::SquareDisplacement>(result, "square_large", 0.3, 0.3);
  compare<3, mms::Cube, mms::CubeDisplacement>(result, "cube", 0.05, 0.3);
  compare<3, mms::Cube, mms::CubeDisplacement>(result, "cube_large", 0.15, 0.3);
  return result;
}

}  // namespace mpmvv
