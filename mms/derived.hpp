#pragma once
#include <array>
#include <concepts>

#include "mms/elasticity.hpp"
#include "mms/energy.hpp"
#include "mms/jet.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// Callable with (std::array<T, D> X, T t) for any scalar type T; returns the displacement, std::array<T, D>.
template <class U, int D>
concept DisplacementField = requires(const U& u, const std::array<double, D>& X, double t) {
  { u(X, t) } -> std::convertible_to<std::array<double, D>>;
};

/// A solution derived by automatic differentiation from a displacement field and an energy alone: from the gradient and
/// Hessian of u by (X, t), and of W by F,
///   F = I + ∂u/∂X,   P_iJ = ∂W/∂F_iJ,   Div P_i = Σ_JkL ∂²W/∂F_iJ∂F_kL ∂²u_k/∂X_L∂X_J.
/// `Energy` is callable with Matrix<T, D>.
template <int D, DisplacementField<D> Displacement, class Energy>
class Derived final : public ManufacturedSolution<D> {
 public:
  Derived(Displacement displacement, Energy energy, double density, double scale)
      : displacement_(displacement), energy_(energy), density_(density), scale_(scale) {}

  Vec<D> u(const Vec<D>& X, double t) const override {
    std::array<double, D> place;
    std::copy_n(X.data(), D, place.begin());
    const std::array<double, D> u = displacement_(place, t);
    return Eigen::Map<const Vec<D>>(u.data());
  }

  Vec<D> v(const Vec<D>& X, double t) const override { return velocity(jets(X, t)); }
  Vec<D> a(const Vec<D>& X, double t) const override { return acceleration(jets(X, t)); }
  Mat<D> F(const Vec<D>& X, double t) const override { return deformation(jets(X, t)); }

  Mat<D> P(const Vec<D>& X, double t) const override {
    const auto W = energy(deformation(jets(X, t)));
    Mat<D> P;
    for (int i = 0; i < D; ++i)
      for (int J = 0; J < D; ++J) P(i, J) = W.gradient()[place_of(i, J)];
    return P;
  }

  Vec<D> b(const Vec<D>& X, double t) const override {
    const auto u = jets(X, t);
    const auto W = energy(deformation(u));
    Vec<D> div_P = Vec<D>::Zero();
    for (int i = 0; i < D; ++i)
      for (int J = 0; J < D; ++J)
        for (int k = 0; k < D; ++k)
          for (int L = 0; L < D; ++L) div_P[i] += W.hessian()(place_of(i, J), place_of(k, L)) * u[k].hessian()(L, J);
    return acceleration(u) - div_P / density_;  // Div P + ρ₀ b = ρ₀ a                                   W (52)
  }

  double displacement_scale() const override { return scale_; }

 private:
  using DisplacementJets = std::array<Jet<D + 1>, D>;  ///< by X and t

  DisplacementJets jets(const Vec<D>& X, double t) const {
    DisplacementJets place;
    for (int J = 0; J < D; ++J) place[J] = Jet<D + 1>::variable(X[J], J);
    return displacement_(place, Jet<D + 1>::variable(t, D));
  }
  static Vec<D> velocity(const DisplacementJets& u) {
    Vec<D> v;
    for (int i = 0; i < D; ++i) v[i] = u[i].gradient()[D];
    return v;
  }
  static Vec<D> acceleration(const DisplacementJets& u) {
    Vec<D> a;
    for (int i = 0; i < D; ++i) a[i] = u[i].hessian()(D, D);
    return a;
  }
  static Mat<D> deformation(const DisplacementJets& u) {
    Mat<D> F = Mat<D>::Identity();
    for (int i = 0; i < D; ++i) F.row(i) += u[i].gradient().template head<D>();
    return F;
  }

  static constexpr int place_of(int i, int J) { return D * i + J; }  ///< of F_iJ among the variables of W

  Jet<D * D> energy(const Mat<D>& F) const {
    Matrix<Jet<D * D>, D> at;
    for (int i = 0; i < D; ++i)
      for (int J = 0; J < D; ++J) at[i][J] = Jet<D * D>::variable(F(i, J), place_of(i, J));
    return energy_(at);
  }

  Displacement displacement_;
  Energy energy_;
  double density_, scale_;
};

/// A solution of your own: its displacement, written once. For a square that is sheared to and fro,
///   const auto sheared = derived<2>(
///       [](const auto& X, const auto& t) {
///         using std::sin;
///         return std::array{0.1 * X[1] * X[1] * sin(t), 0.0 * t};
///       },
///       Elasticity{1e4, 0.3, 1}, 0.1);
///   sheared.b({0.2, 0.5}, 1.0);
/// has every field, for the law S (46). scale: the largest |u|, m, up to a factor of order one.
template <int D, DisplacementField<D> Displacement>
Derived<D, Displacement, NeoHookeanLogEnergy> derived(Displacement displacement, const Elasticity& material,
                                                      double scale) {
  return {displacement, {material.lambda(), material.mu()}, material.density, scale};
}

}  // namespace mpmvv::mms
