#include "mms/radial.hpp"

namespace mpmvv::mms {

namespace {

/// A tensor with this entry along e_R and that one along every direction across it.
template <int D>
Mat<D> along_and_across(const Vec<D>& X, double along, double across) {
  return across * Mat<D>::Identity() + (along - across) / X.squaredNorm() * X * X.transpose();
}

}  // namespace

/// The parts of the fields that depend on the point and not on time:
///   u = T over_R X,   F_RR = 1 + T slope,   F_θθ = 1 + T over_R
///   b = T {constant + M [along / F_RR² + across / (F_RR F_θθ)]} X
template <int D>
struct Radial<D>::Point {
  Point(const Radial& s, const Vec<D>& place)
      : X(place), over_R(s.profile_.over_R(X.norm())), slope(s.profile_.slope(X.norm())) {
    const double R = X.norm();
    along = -s.profile_.curvature(R) / (s.rho_ * R);
    across = -(D - 1) * s.profile_.over_R_slope(R) / (s.rho_ * R);
    constant = -s.c_pi_ * s.c_pi_ * over_R + s.mu_ * (along + across);
  }

  Vec<D> u(double T) const { return T * over_R * X; }
  double F_RR(double T) const { return 1 + T * slope; }
  double F_tt(double T) const { return 1 + T * over_R; }
  Vec<D> b(const Radial& s, double T) const {
    const double F_R = F_RR(T), F_t = F_tt(T);
    const double M = s.lambda_ == 0 ? s.mu_ : s.mu_ + s.lambda_ * (1 - s.log_J(F_R, F_t));
    return T * (constant + M * (along * F_t + across * F_R) / (F_R * F_R * F_t)) * X;
  }

  Vec<D> X;
  double over_R, slope;
  double along, across, constant;
};

template <int D>
Radial<D>::Radial(double amplitude, const Radii& radii, const Elasticity& material)
    : A_(amplitude),
      profile_(radii),
      lambda_(material.lambda()),
      mu_(material.mu()),
      rho_(material.density),
      c_pi_(std::sqrt(material.youngs_modulus / rho_) * std::numbers::pi) {}

template <int D>
double Radial<D>::log_J(double F_RR, double F_tt) const {
  return std::log(D == 2 ? F_RR * F_tt : F_RR * F_tt * F_tt);
}

template <int D>
Vec<D> Radial<D>::u(const Vec<D>& X, double t) const {
  return Point(*this, X).u(T(t));
}

template <int D>
Vec<D> Radial<D>::v(const Vec<D>& X, double t) const {
  return Point(*this, X).u(-A_ * c_pi_ * std::sin(c_pi_ * t));
}

template <int D>
Vec<D> Radial<D>::a(const Vec<D>& X, double t) const {
  return -c_pi_ * c_pi_ * u(X, t);
}

template <int D>
Mat<D> Radial<D>::F(const Vec<D>& X, double t) const {
  const Point at(*this, X);
  return along_and_across<D>(X, at.F_RR(T(t)), at.F_tt(T(t)));
}

template <int D>
Mat<D> Radial<D>::P(const Vec<D>& X, double t) const {
  const Point at(*this, X);
  const double F_RR = at.F_RR(T(t)), F_tt = at.F_tt(T(t));
  const auto stress = [&, K = log_J(F_RR, F_tt)](double F) { return (lambda_ * K + mu_ * (F * F - 1)) / F; };
  return along_and_across<D>(X, stress(F_RR), stress(F_tt));
}

template <int D>
Vec<D> Radial<D>::b(const Vec<D>& X, double t) const {
  return Point(*this, X).b(*this, T(t));
}

template <int D>
Vec<D> Radial<D>::reference_point(const Vec<D>& x, double t) const {
  return profile_.reference_radius(T(t), x.norm()) * x.normalized();
}

template <int D>
class Radial<D>::AtPoints final : public PointwiseSolution<D> {
 public:
  AtPoints(const Radial& solution, const std::vector<Vec<D>>& X) : solution_(solution) {
    for (const auto& place : X) points_.emplace_back(solution, place);
  }

  void displacement(double t, std::span<const std::uint32_t> ids, Vec<D>* u) const override {
    const double T = solution_.T(t);
    for (const auto id : ids) *u++ = points_[id].u(T);
  }

  void body_force(double t, std::span<const std::uint32_t> ids, Vec<D>* b) const override {
    const double T = solution_.T(t);
    for (const auto id : ids) *b++ = points_[id].b(solution_, T);
  }

 private:
  const Radial solution_;
  std::vector<Point> points_;
};

template <int D>
std::unique_ptr<PointwiseSolution<D>> Radial<D>::at_points(const std::vector<Vec<D>>& X) const {
  return std::make_unique<AtPoints>(*this, X);
}

template class Radial<2>;
template class Radial<3>;

}  // namespace mpmvv::mms
