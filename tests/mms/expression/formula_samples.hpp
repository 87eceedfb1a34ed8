#pragma once
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mms/catalogue.hpp"
#include "mms/expression/dialect.hpp"

namespace mpmvv::mms {

/// Values of the variables X, Y, Z, x, y, z and t.
using PlaceAndTime = std::array<double, 7>;

/// An expression of a solution, and what the solution itself gives at some places.
struct FormulaSample {
  std::string what;  ///< "b_x of ring, reference"
  bool is_of_reference;
  expression::Traced formula;
  std::vector<PlaceAndTime> places;
  std::vector<double> expected;

  /// Of what is rounded: displacements are differences of positions, which are of order one.
  double scale() const {
    double largest = what.starts_with("u") ? 1 : 0;
    for (const double value : expected) largest = std::max(largest, std::abs(value));
    return largest == 0 ? 1 : largest;
  }
};

template <int D>
Vec<D> point_of(const Values& values, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Vec<D> X;
  for (int d = 0; d < D; ++d) X[d] = unit(random);
  const auto inner = values.find("inner_radius");
  if (inner == values.end()) return X;
  const double R = inner->second + unit(random) * (values.at("outer_radius") - inner->second);
  return (X.array() - 0.5).matrix().normalized() * R;
}

template <int D>
std::vector<FormulaSample> samples_of(const Entry& entry, const Values& given) {
  const Values values = complete(entry, given);
  const auto solution = make<D>(entry.name, values);
  const double span = values.contains("period") ? values.at("period") : 0.02;
  std::mt19937 random(1);
  std::vector<FormulaSample> all;
  const auto add = [&](const char* form, const expression::Fields& fields) {
    const std::string of = " of " + std::string(entry.name) + ", " + form;
    const std::size_t first = all.size();
    const auto add_vector = [&](const char* name, const expression::Vector& components) {
      for (const auto& component : components) all.push_back({name + of, form[0] == 'r', component, {}, {}});
    };
    add_vector("u", fields.u);
    add_vector("v", fields.v);
    add_vector("b", fields.b);
    for (const auto& row : fields.F) add_vector("F", row);
    for (int k = 0; k < 20; ++k) {
      const Vec<D> X = point_of<D>(values, random);
      const double t = span * std::uniform_real_distribution<double>(0, 1)(random);
      const Vec<D> u = solution->u(X, t), v = solution->v(X, t), b = solution->b(X, t);
      const Mat<D> F = solution->F(X, t).transpose();  // so that its rows come one after another
      std::vector<double> expected;
      for (const Vec<D>& vector : {u, v, b}) expected.insert(expected.end(), vector.data(), vector.data() + D);
      expected.insert(expected.end(), F.data(), F.data() + D * D);
      PlaceAndTime place{};
      for (std::size_t d = 0; d < D; ++d) place[d] = X.data()[d], place[3 + d] = X.data()[d] + u.data()[d];
      place[6] = t;
      for (std::size_t n = 0; n < expected.size(); ++n) {
        all[first + n].places.push_back(place);
        all[first + n].expected.push_back(expected[n]);
      }
    }
  };
  const expression::Formulas formulas = solution->formulas();
  if (formulas.reference) add("reference", *formulas.reference);
  if (formulas.inverse) add("inverse", *formulas.inverse);
  return all;
}

/// Of every solution that has formulas, with its own parameters, and with another lateral contraction; or with that one
/// alone where it takes any.
inline std::vector<FormulaSample> formula_samples(bool with_its_own = true) {
  std::vector<FormulaSample> all;
  for (const Entry& entry : catalogue()) {
    std::vector<Values> choices{{}};
    if (complete(entry, {}).contains("poissons_ratio")) choices.push_back({{"poissons_ratio", 0.2}});
    if (!with_its_own) choices.erase(choices.begin(), choices.end() - 1);
    for (const Values& given : choices) {
      const auto more = std::visit([&]<int D>(Make<D>) { return samples_of<D>(entry, given); }, entry.make);
      all.insert(all.end(), more.begin(), more.end());
    }
  }
  return all;
}

inline const expression::Dialect& dialect(const std::string& name) {
  for (const auto& each : expression::dialects())
    if (each.name == name) return each;
  throw std::logic_error("no dialect " + name);
}

}  // namespace mpmvv::mms
