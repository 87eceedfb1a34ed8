#include "mms/vortex.hpp"

#include <Eigen/Geometry>
#include <utility>

#include "mms/lanes.hpp"

namespace mpmvv::mms {

namespace {

/// Returns X turned by a quarter turn: R e_θ from R e_R.
Vec<2> crossed(const Vec<2>& X) {
  return {-X[1], X[0]};
}

Vec<2> turned(const Vec<2>& X, double angle) {
  return std::cos(angle) * X + std::sin(angle) * crossed(X);
}

}  // namespace

Vortex::Vortex(double amplitude, const Radii& radii, double period, const Elasticity& material)
    : A_(amplitude),
      radii_(radii),
      rate_(std::numbers::pi / period),
      mu_(material.mu()),
      mu_rho_(material.mu() / material.density) {}

template <class N>
Vortex::Profile<N> Vortex::profile(const N& R) const {
  const double slope = 1 / (radii_.outer - radii_.inner);  // ds/dR; to multiply by it costs less than to divide
  const N s = (R - (radii_.inner + radii_.outer) / 2) * slope, root = 1 - 4 * s * s;
  return {root * root, -16 * slope * s * root, -16 * slope * slope * (1 - 12 * s * s)};
}

/// Takes u as a chord: it has the length 2 R sin(α/2) and the direction of e_θ turned by α/2.
template <class N>
std::array<N, 2> Vortex::displacement(const std::array<N, 2>& X, double G) const {
  using std::cos, std::sin, std::sqrt, mms::cos, mms::sin;
  const N half = G / 2 * profile<N>(sqrt(X[0] * X[0] + X[1] * X[1])).H, cosine = cos(half), sine = sin(half);
  return {-2 * sine * (cosine * X[1] + sine * X[0]), 2 * sine * (cosine * X[0] - sine * X[1])};
}

Vec<2> Vortex::u(const Vec<2>& X, double t) const {
  const auto [x, y] = displacement(std::array{X[0], X[1]}, G(t));
  return {x, y};
}

Vec<2> Vortex::v(const Vec<2>& X, double t) const {
  const double H = profile(X.norm()).H;
  return dG(t) * H * turned(crossed(X), G(t) * H);
}

Vec<2> Vortex::a(const Vec<2>& X, double t) const {
  const double H = profile(X.norm()).H, swirl = dG(t) * H;
  return turned(-rate_ * rate_ * G(t) * H * crossed(X) - swirl * swirl * X, G(t) * H);
}

Mat<2> Vortex::F(const Vec<2>& X, double t) const {
  const auto [H, dH, d2H] = profile(X.norm());
  const Vec<2> e_R = X.normalized();
  const double gamma = X.norm() * G(t) * dH;
  return Eigen::Rotation2D(G(t) * H) * (Mat<2>::Identity() + gamma * crossed(e_R) * e_R.transpose());
}

Mat<2> Vortex::P(const Vec<2>& X, double t) const {
  const auto [H, dH, d2H] = profile(X.norm());
  const Vec<2> e_R = X.normalized();
  const double gamma = X.norm() * G(t) * dH;
  const Mat<2> shear = crossed(e_R) * e_R.transpose();
  return mu_ * gamma * (Eigen::Rotation2D(G(t) * H) * (shear + shear.transpose()));
}

template <class N, class S>
Vortex::Parts<N> Vortex::parts(const N& R, const S& G, const S& dG) const {
  const auto [H, dH, d2H] = profile(R);
  return {.along = G * G * mu_rho_ * dH * dH - dG * dG * H * H,
          .across = G * (-rate_ * rate_ * H - mu_rho_ * (3 * dH / R + d2H)),
          .alpha = G * H};
}

template <class N>
std::array<N, 2> Vortex::b_at(const std::array<N, 2>& X, double G, double dG) const {
  using std::cos, std::sin, std::sqrt, mms::cos, mms::sin;
  const auto [along, across, alpha] = parts<N>(sqrt(X[0] * X[0] + X[1] * X[1]), G, dG);
  const N cosine = cos(alpha), sine = sin(alpha);
  const N of_X = along * cosine - across * sine, of_crossed = along * sine + across * cosine;
  return {of_X * X[0] - of_crossed * X[1], of_X * X[1] + of_crossed * X[0]};
}

Vec<2> Vortex::b(const Vec<2>& X, double t) const {
  const auto [x, y] = b_at(std::array{X[0], X[1]}, G(t), dG(t));
  return {x, y};
}

/// The radius does not change, so that Q R e_R is x, and b is a shorter expression of x than of X.
expression::Formulas Vortex::formulas() const {
  const auto t = expression::time();
  const auto G = A_ * sin(rate_ * t), dG = A_ * rate_ * cos(rate_ * t);
  const auto parts_at = [&](const auto& place) {
    return parts(sqrt(place[0] * place[0] + place[1] * place[1]), G, dG);
  };
  const VortexDisplacement displacement{A_, radii_, std::numbers::pi / rate_};
  const auto X = expression::reference_place<2>(), x = expression::current_place<2>();
  const auto [along_X, across_X, alpha_X] = parts_at(X);
  const auto of_X = along_X * cos(alpha_X) - across_X * sin(alpha_X),
             of_crossed = along_X * sin(alpha_X) + across_X * cos(alpha_X);
  const auto [along, across, alpha] = parts_at(x);
  return {.reference = expression::motion(expression::displacement<2>(displacement),
                                          {of_X * X[0] - of_crossed * X[1], of_X * X[1] + of_crossed * X[0]}),
          .inverse =
              expression::inverse_motion({cos(alpha) * x[0] + sin(alpha) * x[1], cos(alpha) * x[1] - sin(alpha) * x[0]},
                                         {along * x[0] - across * x[1], along * x[1] + across * x[0]})};
}

Vec<2> Vortex::reference_point(const Vec<2>& x, double t) const {
  return turned(x, -G(t) * profile(x.norm()).H);
}

/// Evaluates points in lanes. The time is all that they share.
class Vortex::AtPoints final : public PointwiseSolution<2> {
 public:
  AtPoints(Vortex vortex, std::vector<Vec<2>> X) : vortex_(std::move(vortex)), X_(std::move(X)) {}

  void displacement(double t, std::span<const std::uint32_t> ids, Vec<2>* u) const override {
    in_lanes<2>(
        ids.size(), [this, ids](std::size_t k) -> const Vec<2>& { return X_[ids[k]]; }, u,
        [this, G = vortex_.G(t)](const auto& at) { return vortex_.displacement(at, G); });
  }

  [[gnu::flatten]] void body_force(double t, std::span<const std::uint32_t>, std::span<const Vec<2>> X,
                                   Vec<2>* b) const override {
    in_lanes<2>(X, b, [this, G = vortex_.G(t), dG = vortex_.dG(t)](const auto& at) { return vortex_.b_at(at, G, dG); });
  }
  bool reads_places() const override { return true; }

 private:
  const Vortex vortex_;
  const std::vector<Vec<2>> X_;
};

std::unique_ptr<PointwiseSolution<2>> Vortex::at_points(const std::vector<Vec<2>>& X) const {
  return std::make_unique<AtPoints>(*this, X);
}

}  // namespace mpmvv::mms
