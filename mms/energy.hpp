#pragma once
#include <array>
#include <cmath>

namespace mpmvv::mms {

/// A small square matrix of any scalar type, row by row.
template <class T, std::size_t D>
using Matrix = std::array<std::array<T, D>, D>;

template <class T>
T determinant(const Matrix<T, 1>& F) {
  return F[0][0];
}
template <class T>
T determinant(const Matrix<T, 2>& F) {
  return F[0][0] * F[1][1] - F[0][1] * F[1][0];
}
template <class T>
T determinant(const Matrix<T, 3>& F) {
  return F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) - F[0][1] * (F[1][0] * F[2][2] - F[1][2] * F[2][0]) +
         F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
}

/// The stored energy of S (46), W (55): W = λ/2 (ln J)² - μ ln J + μ/2 (F:F - D). Its derivative P_iJ = ∂W/∂F_iJ is the
/// transpose of S (45) and W (54), which print the nominal stress (docs/misprints.md, M6).
struct NeoHookeanLogEnergy {
  double lambda, mu;

  template <class T, std::size_t D>
  T operator()(const Matrix<T, D>& F) const {
    using std::log;
    const T log_J = log(determinant(F));
    T F_F = T(-static_cast<double>(D));
    for (const auto& row : F)
      for (const T& entry : row) F_F += entry * entry;
    return lambda / 2 * log_J * log_J - mu * log_J + mu / 2 * F_F;
  }
};

/// The stored energy of N (6): W = λ/2 ((J² - 1)/2 - ln J) - μ ln J + μ/2 (F:F - D).
struct NeoHookeanSquareEnergy {
  double lambda, mu;

  template <class T, std::size_t D>
  T operator()(const Matrix<T, D>& F) const {
    using std::log;
    const T J = determinant(F), log_J = log(J);
    T F_F = T(-static_cast<double>(D));
    for (const auto& row : F)
      for (const T& entry : row) F_F += entry * entry;
    return lambda / 2 * ((J * J - 1) / 2 - log_J) - mu * log_J + mu / 2 * F_F;
  }
};

}  // namespace mpmvv::mms
