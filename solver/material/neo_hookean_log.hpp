#pragma once
#include <Eigen/LU>
#include <cmath>
#include <string_view>

#include "solver/material/neo_hookean.hpp"
#include "solver/types.hpp"

namespace mpmvv::solver {

/// Neo-Hookean solid, S (46), W (55): σ = λ ln J / J I + μ/J (F Fᵀ - I); in 1D with λ = 0 it is S (50).
/// In 1D and 2D the missing directions are held (uniaxial strain, plane strain).
struct NeoHookeanLog {
  static constexpr std::string_view word = "neo-hookean-log";

  double lambda = 0;  ///< first Lamé constant, Pa
  double mu = 0;      ///< shear modulus, Pa

  /// Kirchhoff stress τ = J σ = μ F Fᵀ + (λ ln J - μ) I. The logarithm is not computed when λ = 0.
  template <class Scalar, int D>
  Eigen::Matrix<Scalar, D, D> kirchhoff(const Eigen::Matrix<Scalar, D, D>& F) const {
    using std::log;
    const Scalar spherical = lambda == 0 ? Scalar(-mu) : Scalar(lambda * log(F.determinant()) - mu);
    return neo_hookean_stress(F, mu, spherical);
  }

  /// Strain energy per reference volume, λ/2 (ln J)² - μ ln J + μ/2 (tr F Fᵀ - D).
  template <int D>
  double energy(const Mat<D>& F) const {
    const double log_J = std::log(F.determinant());
    return 0.5 * lambda * log_J * log_J - mu * log_J + 0.5 * mu * (F.squaredNorm() - D);
  }
};

}  // namespace mpmvv::solver
