#pragma once
#include <Eigen/LU>
#include <array>

#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

/// How F follows the velocity gradient L through a step.
enum class Deformation {
  linear,      ///< F' = (I + Δt L) F       S (7), (8), W (11)
  exponential  ///< F' = exp(Δt L) F        N table 1, task 5: a rigid rotation stays one, a trace of zero keeps J
};

/// C + A B
template <int D, class Matrix>
[[gnu::always_inline]] inline Matrix plus_product(const auto& C, const Matrix& A, const auto& B) {
  Matrix result;
  for (int c = 0; c < D; ++c) {
    auto column = padded<D>(C.col(c));
    for (int d = 0; d < D; ++d) column += B(d, c) * A.col(d);
    result.col(c) = column;
  }
  return result;
}

/// The c_j of A^D = Σ_{j<D} c_j A^j, by the theorem of Cayley and Hamilton.
template <int D, class Matrix>
std::array<typename Matrix::Scalar, D> characteristic(const Matrix& A) {
  const auto minor = [&A](int i, int j) { return A(i, i) * A(j, j) - A(i, j) * A(j, i); };
  if constexpr (D == 1)
    return {A(0, 0)};
  else if constexpr (D == 2)
    return {-minor(0, 1), A(0, 0) + A(1, 1)};
  else
    return {A.template topRows<3>().eval().determinant(), -(minor(0, 1) + minor(0, 2) + minor(1, 2)),
            A(0, 0) + A(1, 1) + A(2, 2)};
}

/// a A + b I, column by column: at once it would go through memory.
template <int D>
inline PaddedMat<D> sum_with_identity(double a, const PaddedMat<D>& A, double b) {
  PaddedMat<D> sum;
  for (int d = 0; d < D; ++d) sum.col(d) = a * A.col(d) + Padded<D>(b * Padded<D>::Unit(d));
  return sum;
}

/// exp(A) - I by twelve terms, Horner's scheme on the multiples of I, A and A² that powers come down to: the rest,
/// |A|¹³/13!, is round-off up to |A| = 0.4, and 2e-13 at 0.6.
template <int D, class Matrix>
[[gnu::noinline]] Matrix exponential_less_identity(const Matrix& A) {
  using Number = typename Matrix::Scalar;
  constexpr double share[] = {1,         1. / 2,     1. / 6,      1. / 24,      1. / 120,      1. / 720,
                              1. / 5040, 1. / 40320, 1. / 362880, 1. / 3628800, 1. / 39916800, 1. / 479001600};
  const std::array<Number, D> c = characteristic<D>(A);
  std::array<Number, D> x;
  x.fill(0);
  for (int k = 11; k >= 0; --k) {
    x[0] += share[k];
    const Number highest = x[D - 1];
    for (std::size_t j = D - 1; j > 0; --j) x[j] = x[j - 1] + c[j] * highest;
    x[0] = c[0] * highest;
  }
  if constexpr (D == 1) return Matrix(x[0]);
  if constexpr (D == 2) return sum_with_identity<D>(x[1], A, x[0]);
  if constexpr (D == 3) {
    const PaddedMat<D> linear = sum_with_identity<D>(x[2], A, x[1]), zero = PaddedMat<D>::Zero();
    return sum_with_identity<D>(1, plus_product<D>(zero, A, linear), x[0]);
  }
}

/// A step of F, of a length of its own.
template <int D>
struct DeformationStep {
  double dt;
  Deformation rule = Deformation::linear;

  /// F'
  template <class Matrix>
  [[gnu::always_inline]] auto operator()(const auto& F, const Matrix& L) const {
    Matrix increment;
    for (int d = 0; d < D; ++d) increment.col(d) = dt * L.col(d);  // at once, a plane's would go through memory
    if (rule == Deformation::exponential) increment = exponential_less_identity<D>(increment);
    return plus_product<D>(F, increment, F).template topRows<D>().eval();
  }
};

}  // namespace mpmvv::solver
