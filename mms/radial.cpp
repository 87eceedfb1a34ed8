#include "mms/radial.hpp"

#include <utility>

#include "mms/lanes.hpp"

namespace mpmvv::mms {

namespace {

/// Returns the tensor with the entry `along` for e_R and the entry `across` for every direction across it.
template <int D>
Mat<D> along_and_across(const Vec<D>& X, double along, double across) {
  return across * Mat<D>::Identity() + (along - across) / X.squaredNorm() * X * X.transpose();
}

}  // namespace

template <int D>
Radial<D>::Radial(double amplitude, const Radii& radii, const Elasticity& material)
    : A_(amplitude),
      profile_(radii),
      lambda_(material.lambda()),
      mu_(material.mu()),
      rho_(material.density),
      c_pi_(std::sqrt(material.youngs_modulus / rho_) * std::numbers::pi) {}

template <int D>
template <class N>
N Radial<D>::J(const N& F_RR, const N& F_tt) {
  if constexpr (D == 2) return F_RR * F_tt;
  return F_RR * F_tt * F_tt;
}

template <int D>
typename Radial<D>::Stretches Radial<D>::stretches(double R, double t) const {
  return {1 + T(t) * profile_.slope(R), 1 + T(t) * profile_.over_R(R)};
}

template <int D>
Vec<D> Radial<D>::u(const Vec<D>& X, double t) const {
  return T(t) * profile_.over_R(X.norm()) * X;
}

template <int D>
Vec<D> Radial<D>::v(const Vec<D>& X, double t) const {
  return -A_ * c_pi_ * std::sin(c_pi_ * t) * profile_.over_R(X.norm()) * X;
}

template <int D>
Vec<D> Radial<D>::a(const Vec<D>& X, double t) const {
  return -c_pi_ * c_pi_ * u(X, t);
}

template <int D>
Mat<D> Radial<D>::F(const Vec<D>& X, double t) const {
  const auto [F_RR, F_tt] = stretches(X.norm(), t);
  return along_and_across<D>(X, F_RR, F_tt);
}

template <int D>
Mat<D> Radial<D>::P(const Vec<D>& X, double t) const {
  const auto [F_RR, F_tt] = stretches(X.norm(), t);
  const double K = std::log(J(F_RR, F_tt));
  const auto stress = [&](double F) { return (lambda_ * K + mu_ * (F * F - 1)) / F; };
  return along_and_across<D>(X, stress(F_RR), stress(F_tt));
}

/// Puts both brackets of b over one denominator, because a division takes much longer than a product. With a = w'' and
/// c = (D - 1) (w/R)':
///   b/R = -T {c²π² w/R + [μ F_RR² F_θθ (a + c) + M (a F_θθ + c F_RR)] / (ρ₀ R F_RR² F_θθ)}
template <int D>
template <class N, class S>
N Radial<D>::b_over_R(const N& R2, const S& T) const {
  using std::log, std::sqrt;
  const N R = sqrt(R2), over_R = profile_.over_R(R);
  const N F_RR = 1 + T * profile_.slope(R), F_tt = 1 + T * over_R;
  const N a = profile_.curvature(R), c = (D - 1) * profile_.over_R_slope(R);
  const N denominator = F_RR * F_RR * F_tt, with_M = a * F_tt + c * F_RR;
  N sum = mu_ * (denominator * (a + c) + with_M);
  if (lambda_ != 0) sum += lambda_ * (1 - log(J(F_RR, F_tt))) * with_M;
  return -T * (c_pi_ * c_pi_ * over_R + sum / (rho_ * R * denominator));
}

template <int D>
Vec<D> Radial<D>::b(const Vec<D>& X, double t) const {
  return b_over_R(X.squaredNorm(), T(t)) * X;
}

template <int D>
expression::Formulas Radial<D>::formulas() const {
  const auto X = expression::reference_place<D>();
  expression::Traced R2 = 0;
  for (const auto& coordinate : X) R2 += coordinate * coordinate;
  const auto over_R = b_over_R(R2, A_ * cos(c_pi_ * expression::time()));
  expression::Vector b;
  for (const auto& coordinate : X) b.push_back(over_R * coordinate);
  const RadialDisplacement<D> displacement{A_, profile_, c_pi_ / std::numbers::pi};
  return {.reference = expression::motion(expression::displacement<D>(displacement), b)};
}

template <int D>
Vec<D> Radial<D>::reference_point(const Vec<D>& x, double t) const {
  return profile_.reference_radius(T(t), x.norm()) * x.normalized();
}

/// Evaluates points in lanes. The time is all that they share.
template <int D>
class Radial<D>::AtPoints final : public PointwiseSolution<D> {
 public:
  AtPoints(Radial solution, std::vector<Vec<D>> X) : solution_(std::move(solution)), X_(std::move(X)) {}

  void displacement(double t, std::span<const std::uint32_t> ids, Vec<D>* u) const override {
    const double T = solution_.T(t);
    for (const auto id : ids) *u++ = T * solution_.profile_.over_R(X_[id].norm()) * X_[id];
  }

  void body_force(double t, std::span<const std::uint32_t>, std::span<const Vec<D>> X, Vec<D>* b) const override {
    in_lanes<D>(X, b, [this, T = solution_.T(t)](const std::array<Lanes, D>& place) {
      Lanes R2 = place[0] * place[0];
      for (std::size_t d = 1; d < D; ++d) R2 += place[d] * place[d];
      const Lanes b_over_R = solution_.b_over_R(R2, T);
      std::array<Lanes, D> force;
      for (std::size_t d = 0; d < D; ++d) force[d] = b_over_R * place[d];
      return force;
    });
  }
  bool reads_places() const override { return true; }

 private:
  const Radial solution_;
  const std::vector<Vec<D>> X_;
};

template <int D>
std::unique_ptr<PointwiseSolution<D>> Radial<D>::at_points(const std::vector<Vec<D>>& X) const {
  return std::make_unique<AtPoints>(*this, X);
}

template class Radial<2>;
template class Radial<3>;

}  // namespace mpmvv::mms
