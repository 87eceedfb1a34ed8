#pragma once
#include <algorithm>
#include <array>
#include <boost/math/differentiation/autodiff.hpp>
#include <concepts>
#include <utility>

#include "mms/elasticity.hpp"
#include "mms/energy.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// A functor that takes (std::array<T, D> X, T t) for any scalar type T and returns the displacement, std::array<T, D>.
/// Write x * x in it, never pow(x, 2), whose derivative at x = 0 is NaN in Boost 1.74.
template <class U, int D>
concept DisplacementField = requires(const U& u, const std::array<double, D>& X, double t) {
  { u(X, t) } -> std::convertible_to<std::array<double, D>>;
};

/// A solution derived by automatic differentiation from a displacement field and an energy alone. One kind of number is
/// enough, c0 + c1 r + c2 s + c3 rs. It gives the derivatives of u along two directions of (X, t), up to the mixed
/// second one, and from these
///   P_iJ = ∂W/∂F_iJ,   Div P_i = Σ_J d²/dr ds W(F + r e_i⊗e_J + s ∂F/∂X_J).
/// `Energy` is a functor that takes Matrix<T, D>.
template <int D, DisplacementField<D> Displacement, class Energy>
class Derived final : public ManufacturedSolution<D> {
 public:
  Derived(Displacement displacement, Energy energy, double density, double scale)
      : displacement_(std::move(displacement)), energy_(std::move(energy)), density_(density), scale_(scale) {}

  Vec<D> u(const Vec<D>& X, double t) const override {
    std::array<double, D> place;
    std::copy_n(X.data(), D, place.begin());
    const std::array<double, D> u = displacement_(place, t);
    return Eigen::Map<const Vec<D>>(u.data());
  }

  Vec<D> v(const Vec<D>& X, double t) const override { return part(expand(X, t, D, D), 1, 0); }
  Vec<D> a(const Vec<D>& X, double t) const override { return part(expand(X, t, D, D), 1, 1); }

  Mat<D> F(const Vec<D>& X, double t) const override {
    Mat<D> F = Mat<D>::Identity();
    for (int J = 0; J < D; ++J) F.col(J) += part(expand(X, t, J, J), 1, 0);
    return F;
  }

  Mat<D> P(const Vec<D>& X, double t) const override {
    const Mat<D> stretch = F(X, t);
    Mat<D> P;
    for (int i = 0; i < D; ++i)
      for (int J = 0; J < D; ++J) P(i, J) = energy(stretch, Mat<D>::Zero(), i, J).derivative(1, 0);
    return P;
  }

  Vec<D> b(const Vec<D>& X, double t) const override {
    Mat<D> stretch = Mat<D>::Identity();
    std::array<Mat<D>, D> dF;  // ∂F/∂X_J
    for (int J = 0; J < D; ++J)
      for (int L = J; L < D; ++L) {
        const Expansion u = expand(X, t, J, L);
        dF[J].col(L) = dF[L].col(J) = part(u, 1, 1);
        if (J == L) stretch.col(J) += part(u, 1, 0);
      }
    Vec<D> div_P = Vec<D>::Zero();
    for (int i = 0; i < D; ++i)
      for (int J = 0; J < D; ++J) div_P[i] += energy(stretch, dF[J], i, J).derivative(1, 1);
    return a(X, t) - div_P / density_;  // Div P + ρ₀ b = ρ₀ a                                            W (52)
  }

  double displacement_scale() const override { return scale_; }

  /// Empty where the displacement branches on a value, and so has no single formula.
  expression::Formulas formulas() const override {
    try {
      const auto energy = [this](const expression::Tensor& rows) {
        Matrix<expression::Traced, D> F;
        for (std::size_t i = 0; i < D; ++i) std::copy_n(rows[i].begin(), D, F[i].begin());
        return energy_(F);
      };
      return {.reference = expression::motion(expression::displacement<D>(displacement_), energy, density_)};
    } catch (const expression::NoFormula&) {
      return {};
    }
  }

 private:
  using RS = boost::math::differentiation::autodiff_fvar<double, 1, 1>;
  using Expansion = std::array<RS, D>;

  static RS along_r() { return boost::math::differentiation::make_fvar<double, 1>(0.0); }
  static RS along_s() { return boost::math::differentiation::make_fvar<double, 0, 1>(0.0); }

  /// Evaluates u with r added to coordinate j of (X, t) and s to coordinate k. Coordinate D is t.
  Expansion expand(const Vec<D>& X, double t, int j, int k) const {
    std::array<RS, D + 1> at;
    for (int d = 0; d < D; ++d) at[d] = X[d];
    at[D] = t;
    at[j] += along_r();
    at[k] += along_s();
    Expansion place;
    std::copy_n(at.begin(), D, place.begin());
    return displacement_(place, at[D]);
  }

  /// Returns d^(m+n)/dr^m ds^n of each component.
  static Vec<D> part(const Expansion& u, std::size_t m, std::size_t n) {
    Vec<D> result;
    for (int d = 0; d < D; ++d) result[d] = static_cast<double>(u[d].derivative(m, n));
    return result;
  }

  /// Returns W(F + r e_i⊗e_J + s dF).
  RS energy(const Mat<D>& F, const Mat<D>& dF, int i, int J) const {
    Matrix<RS, D> at;
    for (int k = 0; k < D; ++k)
      for (int L = 0; L < D; ++L) at[k][L] = F(k, L) + dF(k, L) * along_s();
    at[i][J] += along_r();
    return energy_(at);
  }

  Displacement displacement_;
  Energy energy_;
  double density_, scale_;
};

/// Makes a solution of your own from its displacement, which is written once. For example, for a square that is sheared
/// to and fro,
///   const auto sheared = derived<2>(
///       [](const auto& X, const auto& t) {
///         using std::sin;
///         return std::array{0.1 * X[1] * X[1] * sin(t), 0.0 * t};
///       },
///       Elasticity{1e4, 0.3, 1}, 0.1);
///   sheared.b({0.2, 0.5}, 1.0);
/// gives the body force at a point; all other fields are there, too. The law is S (46). scale: the largest |u|, m, up
/// to a factor of order one.
template <int D, DisplacementField<D> Displacement>
Derived<D, Displacement, NeoHookeanLogEnergy> derived(Displacement displacement, const Elasticity& material,
                                                      double scale) {
  return {displacement, {material.lambda(), material.mu()}, material.density, scale};
}

}  // namespace mpmvv::mms
