#pragma once
#include <array>
#include <boost/math/differentiation/autodiff.hpp>

#include "mms/energy.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// A solution derived by automatic differentiation from a displacement field and an energy alone. Only one kind
/// of number is needed, c0 + c1 r + c2 s + c3 rs: second derivatives of u along two directions of (X, t), and from them
///   P_iJ = ∂W/∂F_iJ,   Div P_i = Σ_J d²/dr ds W(F + r e_i⊗e_J + s ∂F/∂X_J).
/// `Displacement` is callable with (std::array<T, D> X, T t) for any scalar type T and returns std::array<T, D>;
/// `Energy` is callable with Matrix<T, D>. In both write x * x, never pow(x, 2) (NUMERICS.md, "Tools").
template <int D, class Displacement, class Energy>
class Derived final : public ManufacturedSolution<D> {
 public:
  Derived(Displacement displacement, Energy energy, double density, double scale)
      : displacement_(displacement), energy_(energy), density_(density), scale_(scale) {}

  Vec<D> u(const Vec<D>& X, double t) const override { return derivative(X, t, 0, 0, D, D); }
  Vec<D> v(const Vec<D>& X, double t) const override { return derivative(X, t, 1, 0, D, D); }
  Vec<D> a(const Vec<D>& X, double t) const override { return derivative(X, t, 1, 1, D, D); }

  Mat<D> F(const Vec<D>& X, double t) const override {
    Mat<D> F = Mat<D>::Identity();
    for (int J = 0; J < D; ++J) F.col(J) += derivative(X, t, 1, 0, J, J);
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
    const Mat<D> stretch = F(X, t);
    Vec<D> div_P = Vec<D>::Zero();
    for (int J = 0; J < D; ++J) {
      Mat<D> dF;  // ∂F/∂X_J
      for (int L = 0; L < D; ++L) dF.col(L) = derivative(X, t, 1, 1, L, J);
      for (int i = 0; i < D; ++i) div_P[i] += energy(stretch, dF, i, J).derivative(1, 1);
    }
    return a(X, t) - div_P / density_;  // Div P + ρ₀ b = ρ₀ a                                            W (52)
  }

  double displacement_scale() const override { return scale_; }

 private:
  using RS = boost::math::differentiation::autodiff_fvar<double, 1, 1>;

  static RS along_r() { return boost::math::differentiation::make_fvar<double, 1>(0.0); }
  static RS along_s() { return boost::math::differentiation::make_fvar<double, 0, 1>(0.0); }

  /// d^(m+n)/dr^m ds^n of u with r added to the coordinate `j` and s to `k` of (X, t); D stands for t.
  Vec<D> derivative(const Vec<D>& X, double t, std::size_t m, std::size_t n, int j, int k) const {
    std::array<RS, D + 1> at;
    for (int d = 0; d < D; ++d) at[static_cast<std::size_t>(d)] = X[d];
    at[D] = t;
    at[static_cast<std::size_t>(j)] += along_r();
    at[static_cast<std::size_t>(k)] += along_s();
    std::array<RS, D> place;
    std::copy_n(at.begin(), D, place.begin());
    const std::array<RS, D> u = displacement_(place, at[D]);
    Vec<D> result;
    for (int d = 0; d < D; ++d) result[d] = static_cast<double>(u[static_cast<std::size_t>(d)].derivative(m, n));
    return result;
  }

  /// W(F + r e_i⊗e_J + s dF)
  RS energy(const Mat<D>& F, const Mat<D>& dF, int i, int J) const {
    Matrix<RS, D> at;
    for (int k = 0; k < D; ++k)
      for (int L = 0; L < D; ++L)
        at[static_cast<std::size_t>(k)][static_cast<std::size_t>(L)] = F(k, L) + dF(k, L) * along_s();
    at[static_cast<std::size_t>(i)][static_cast<std::size_t>(J)] += along_r();
    return energy_(at);
  }

  Displacement displacement_;
  Energy energy_;
  double density_, scale_;
};

}  // namespace mpmvv::mms
