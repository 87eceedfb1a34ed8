#include <algorithm>

#include "mms/bar.hpp"
#include "mms/derived.hpp"
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

/// Largest difference of each field over random points and times, over the largest value of that field.
template <int D>
void compare(CheckResult& result, const std::string& name, const mms::ManufacturedSolution<D>& closed,
             const mms::ManufacturedSolution<D>& derived, double lower, double upper, double period) {
  Field u{"u"}, v{"v"}, a{"a"}, F{"F"}, P{"P"}, b{"b"};
  Random random(20150);
  for (int k = 0; k < 2000; ++k) {
    mms::Vec<D> X;
    for (int d = 0; d < D; ++d) X[d] = random.uniform(lower, upper);
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
  const mms::Elasticity material{1e4, 0, 1};
  for (const auto& [amplitude, name] : {std::pair{0.05, "bar"}, std::pair{0.15, "bar_large"}}) {
    const mms::Derived<1, mms::BarDisplacement, mms::NeoHookeanLogEnergy> derived(
        {amplitude, 100}, {material.lambda(), material.mu()}, material.density, amplitude);
    compare<1>(result, name, mms::Bar(amplitude, material), derived, 0, 1, 0.02);
  }
  return result;
}

}  // namespace mpmvv
