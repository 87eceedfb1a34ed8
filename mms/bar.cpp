#include "mms/bar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mms/lanes.hpp"

namespace mpmvv::mms {

using std::numbers::pi;

namespace {

constexpr std::size_t lanes = Lanes::SizeAtCompileTime;

Vec<1> of(double value) {
  return Vec<1>(value);
}

/// Evaluates S (47) and (49) at fixed points, whose sin 2πX and cos 2πX are computed once.
class BarAtPoints final : public PointwiseSolution<1> {
 public:
  BarAtPoints(double A, double C, const std::vector<Vec<1>>& X) : A_(A), C_(C), sin_(X.size()), cos_(X.size()) {
    for (std::size_t k = 0; k < X.size(); ++k) {
      sin_[k] = std::sin(2 * pi * X[k][0]);
      cos_[k] = std::cos(2 * pi * X[k][0]);
    }
  }

  void displacement(double t, std::span<const std::uint32_t> ids, Vec<1>* u) const override {
    const double A_cos_t = A_ * std::cos(C_ * pi * t);
    for (const auto id : ids) *u++ = of(A_cos_t * sin_[id]);
  }

  void body_force(double t, std::span<const std::uint32_t> ids, std::span<const Vec<1>>, Vec<1>* b) const override {
    const double A_cos_t = A_ * std::cos(C_ * pi * t), scale = C_ * C_ * pi * pi * A_cos_t;
    const auto of_eight = [&](const std::uint32_t* id) -> Lanes {
      Lanes sine, cosine;
      for (std::size_t lane = 0; lane < lanes; ++lane)
        sine.data()[lane] = sin_[id[lane]], cosine.data()[lane] = cos_[id[lane]];
      const Lanes F = 1 + 2 * pi * A_cos_t * cosine;
      return scale * (2 / (F * F) + 1) * sine;
    };
    std::size_t k = 0;
    for (; k + lanes <= ids.size(); k += lanes) Lanes::Map(b[k].data()) = of_eight(&ids[k]);
    if (k == ids.size()) return;
    std::array<std::uint32_t, lanes> last{};
    std::copy(ids.begin() + static_cast<std::ptrdiff_t>(k), ids.end(), last.begin());
    const Lanes force = of_eight(last.data());
    std::transform(force.data(), force.data() + ids.size() - k, b + k, of);
  }
  bool reads_places() const override { return false; }

 private:
  double A_, C_;
  std::vector<double> sin_, cos_;
};

}  // namespace

Bar::Bar(double amplitude, const Elasticity& material)
    : A_(amplitude), E_(material.youngs_modulus), C_(std::sqrt(material.youngs_modulus / material.density)) {}

template <class N>
N Bar::u_at(const N& X, const N& t) const {
  using std::cos, std::sin;
  return A_ * sin(2 * pi * X) * cos(C_ * pi * t);
}

template <class N>
N Bar::F_at(const N& X, const N& t) const {
  using std::cos;
  return 1 + 2 * A_ * pi * cos(2 * pi * X) * cos(C_ * pi * t);
}

template <class N>
N Bar::b_at(const N& X, const N& t) const {
  const N stretch = F_at(X, t);
  return C_ * C_ * pi * pi * (2 / (stretch * stretch) + 1) * u_at(X, t);
}

Vec<1> Bar::u(const Vec<1>& X, double t) const {
  return of(u_at(X[0], t));
}

Vec<1> Bar::v(const Vec<1>& X, double t) const {
  return of(-A_ * C_ * pi * std::sin(2 * pi * X[0]) * std::sin(C_ * pi * t));
}

Vec<1> Bar::a(const Vec<1>& X, double t) const {
  return -C_ * C_ * pi * pi * u(X, t);
}

Mat<1> Bar::F(const Vec<1>& X, double t) const {
  return of(F_at(X[0], t));
}

Mat<1> Bar::P(const Vec<1>& X, double t) const {
  const double stretch = F(X, t)(0, 0);
  return of(E_ / 2 * (stretch - 1 / stretch));
}

Vec<1> Bar::b(const Vec<1>& X, double t) const {
  return of(b_at(X[0], t));
}

expression::Formulas Bar::formulas() const {
  const auto [X] = expression::reference_place<1>();
  const auto t = expression::time();
  return {.reference = expression::motion({u_at(X, t)}, {b_at(X, t)})};
}

std::unique_ptr<PointwiseSolution<1>> Bar::at_points(const std::vector<Vec<1>>& X) const {
  return std::make_unique<BarAtPoints>(A_, C_, X);
}

}  // namespace mpmvv::mms
