#pragma once
#include <Eigen/LU>
#include <array>
#include <cstddef>

namespace mpmvv::solver {

/// How F follows the velocity gradient L through a step.
enum class Deformation {
  linear,      ///< F' = (I + Δt L) F       S (7), (8), W (11)
  exponential  ///< F' = exp(Δt L) F        N table 1, task 5: keeps rigid rotations rigid, and J where tr L = 0
};

/// Returns the coefficients c_j of A^D = Σ_{j<D} c_j A^j, by the theorem of Cayley and Hamilton.
template <class Number, int D>
std::array<Number, D> characteristic(const Eigen::Matrix<Number, D, D>& A) {
  const auto minor = [&A](int i, int j) { return A(i, i) * A(j, j) - A(i, j) * A(j, i); };
  if constexpr (D == 1)
    return {A(0, 0)};
  else if constexpr (D == 2)
    return {-minor(0, 1), A(0, 0) + A(1, 1)};
  else
    return {A.determinant(), -(minor(0, 1) + minor(0, 2) + minor(1, 2)), A(0, 0) + A(1, 1) + A(2, 2)};
}

/// Returns exp(A) - I, summed to twelve terms. Every power of A is a sum of multiples of I, A and A², and Horner's
/// scheme works on these multiples alone. The remainder, |A|¹³/13!, is round-off up to |A| = 0.4, and 2e-13 at 0.6.
template <class Number, int D>
[[gnu::noinline, gnu::flatten]] Eigen::Matrix<Number, D, D> exponential_less_identity(
    const Eigen::Matrix<Number, D, D>& A) {
  constexpr double share[] = {1,         1. / 2,     1. / 6,      1. / 24,      1. / 120,      1. / 720,
                              1. / 5040, 1. / 40320, 1. / 362880, 1. / 3628800, 1. / 39916800, 1. / 479001600};
  const std::array<Number, D> c = characteristic(A);
  std::array<Number, D> x;
  x.fill(0);
  for (int k = 11; k >= 0; --k) {
    x[0] += share[k];
    const Number highest = x[D - 1];
    for (std::size_t j = D - 1; j > 0; --j) x[j] = x[j - 1] + c[j] * highest;
    x[0] = c[0] * highest;
  }
  Eigen::Matrix<Number, D, D> sum = Eigen::Matrix<Number, D, D>::Zero();
  if constexpr (D == 2) sum = A * x[1];
  if constexpr (D == 3) sum = A.lazyProduct(A * x[2] + Eigen::Matrix<Number, D, D>::Identity() * x[1]);
  sum.diagonal().array() += x[0];
  return sum;
}

/// The update of F over a time `dt`, which may be a part of the time step.
struct DeformationStep {
  double dt;
  Deformation rule = Deformation::linear;

  /// Returns F' by the rule `that`. The caller has checked that `rule` is `that`: as a template parameter it costs no
  /// branch.
  template <Deformation that, class Matrix>
  [[gnu::always_inline]] Matrix by(const Matrix& F, const Matrix& L) const {
    Matrix increment = dt * L;
    if constexpr (that == Deformation::exponential) increment = exponential_less_identity(increment);
    return F + increment.lazyProduct(F);
  }
};

}  // namespace mpmvv::solver
