#pragma once
#include <Eigen/Core>

namespace mpmvv::solver {

/// Returns τ = μ F Fᵀ + s I, the Kirchhoff stress of every neo-Hookean law. The laws differ in s.
template <class Scalar, int D>
[[gnu::always_inline]] inline Eigen::Matrix<Scalar, D, D> neo_hookean_stress(const Eigen::Matrix<Scalar, D, D>& F,
                                                                             double mu, const Scalar& s) {
  Eigen::Matrix<Scalar, D, D> tau;
  for (int c = 0; c < D; ++c)
    for (int r = 0; r <= c; ++r) {
      Scalar product = F(r, 0) * F(c, 0);
      for (int d = 1; d < D; ++d) product += F(r, d) * F(c, d);
      tau(r, c) = tau(c, r) = r == c ? Scalar(mu * product + s) : Scalar(mu * product);
    }
  return tau;
}

}  // namespace mpmvv::solver
