#include "mms/vortex.hpp"

#include <Eigen/Geometry>

namespace mpmvv::mms {

namespace {

/// X turned by a quarter: R e_θ from R e_R.
Vec<2> crossed(const Vec<2>& X) {
  return {-X[1], X[0]};
}

Vec<2> turned(const Vec<2>& X, double angle) {
  return std::cos(angle) * X + std::sin(angle) * crossed(X);
}

}  // namespace

/// The parts of the fields that depend on the point and not on time:
///   b = Q {G across R e_θ - [(G' H)² - G² along] R e_R}
struct Vortex::Point {
  Point(const Vortex& vortex, const Vec<2>& place) : X(place) {
    const double R = X.norm(), width = vortex.radii_.outer - vortex.radii_.inner;
    const double s = (R - (vortex.radii_.inner + vortex.radii_.outer) / 2) / width, root = 1 - 4 * s * s;
    H = root * root;
    dH = -16 * s * root / width;
    const double d2H = -16 * (1 - 12 * s * s) / (width * width);
    across = -vortex.rate_ * vortex.rate_ * H - vortex.mu_rho_ * (3 * dH / R + d2H);
    along = vortex.mu_rho_ * dH * dH;
  }

  /// 2 sin(α/2), the chord, in the direction of e_θ turned by α/2.
  Vec<2> u(double G) const {
    const double half = G * H / 2, sine = std::sin(half);
    return 2 * sine * (std::cos(half) * crossed(X) - sine * X);
  }
  Vec<2> b(double G, double dG) const {
    const double swirl = dG * H;
    return turned(G * across * crossed(X) - (swirl * swirl - G * G * along) * X, G * H);
  }

  Vec<2> X;
  double H, dH, across, along;
};

Vortex::Vortex(double amplitude, const Radii& radii, double period, const Elasticity& material)
    : A_(amplitude),
      radii_(radii),
      rate_(std::numbers::pi / period),
      mu_(material.mu()),
      mu_rho_(material.mu() / material.density) {}

Vec<2> Vortex::u(const Vec<2>& X, double t) const {
  return Point(*this, X).u(G(t));
}

Vec<2> Vortex::v(const Vec<2>& X, double t) const {
  const double H = Point(*this, X).H;
  return dG(t) * H * turned(crossed(X), G(t) * H);
}

Vec<2> Vortex::a(const Vec<2>& X, double t) const {
  const double H = Point(*this, X).H, swirl = dG(t) * H;
  return turned(-rate_ * rate_ * G(t) * H * crossed(X) - swirl * swirl * X, G(t) * H);
}

Mat<2> Vortex::F(const Vec<2>& X, double t) const {
  const Point at(*this, X);
  const Vec<2> e_R = X.normalized();
  const double gamma = X.norm() * G(t) * at.dH;
  return Eigen::Rotation2D(G(t) * at.H) * (Mat<2>::Identity() + gamma * crossed(e_R) * e_R.transpose());
}

Mat<2> Vortex::P(const Vec<2>& X, double t) const {
  const Point at(*this, X);
  const Vec<2> e_R = X.normalized();
  const double gamma = X.norm() * G(t) * at.dH;
  const Mat<2> shear = crossed(e_R) * e_R.transpose();
  return mu_ * gamma * (Eigen::Rotation2D(G(t) * at.H) * (shear + shear.transpose()));
}

Vec<2> Vortex::b(const Vec<2>& X, double t) const {
  return Point(*this, X).b(G(t), dG(t));
}

Vec<2> Vortex::reference_point(const Vec<2>& x, double t) const {
  return turned(x, -G(t) * Point(*this, x).H);
}

class Vortex::AtPoints final : public PointwiseSolution<2> {
 public:
  AtPoints(const Vortex& vortex, const std::vector<Vec<2>>& X) : vortex_(vortex) {
    for (const auto& place : X) points_.emplace_back(vortex, place);
  }

  void displacement(double t, std::span<const std::uint32_t> ids, Vec<2>* u) const override {
    const double G = vortex_.G(t);
    for (const auto id : ids) *u++ = points_[id].u(G);
  }

  void body_force(double t, std::span<const std::uint32_t> ids, Vec<2>* b) const override {
    const double G = vortex_.G(t), dG = vortex_.dG(t);
    for (const auto id : ids) *b++ = points_[id].b(G, dG);
  }

 private:
  const Vortex vortex_;
  std::vector<Point> points_;
};

std::unique_ptr<PointwiseSolution<2>> Vortex::at_points(const std::vector<Vec<2>>& X) const {
  return std::make_unique<AtPoints>(*this, X);
}

}  // namespace mpmvv::mms
