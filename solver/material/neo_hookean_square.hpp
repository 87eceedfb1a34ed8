#pragma once
#include <Eigen/LU>
#include <cmath>
#include <string_view>

#include "solver/material/neo_hookean.hpp"
#include "solver/types.hpp"

namespace mpmvv::solver {

/// Neo-Hookean solid, N (6): σ = λ/2 (J - 1/J) I + G/J (F Fᵀ - I).
/// In 1D and 2D the missing directions are held (uniaxial strain, plane strain).
struct NeoHookeanSquare {
  static constexpr std::string_view word = "neo-hookean-square";

  double lambda = 0;  ///< first Lamé constant, Pa
  double mu = 0;      ///< shear modulus G, Pa

  /// Kirchhoff stress τ = J σ = G F Fᵀ + (λ/2 (J² - 1) - G) I.
  template <class Scalar, int D>
  Eigen::Matrix<Scalar, D, D> kirchhoff(const Eigen::Matrix<Scalar, D, D>& F) const {
    const Scalar J = lambda == 0 ? Scalar(1) : F.determinant();
    return neo_hookean_stress(F, mu, Scalar(0.5 * lambda * (J * J - 1) - mu));
  }

  /// Strain energy per reference volume, λ/2 ((J² - 1)/2 - ln J) + G/2 (F : F - D - 2 ln J).
  template <int D>
  double energy(const Mat<D>& F) const {
    const double J = F.determinant(), log_J = std::log(J);
    return 0.5 * lambda * (0.5 * (J * J - 1) - log_J) + 0.5 * mu * (F.squaredNorm() - D - 2 * log_J);
  }
};

}  // namespace mpmvv::solver
