#pragma once
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "solver/material/neo_hookean.hpp"

namespace mpmvv::solver {

/// Neo-Hookean solid, S (46), W (55): σ = λ ln J / J I + μ/J (F Fᵀ - I); in 1D with λ = 0 it is S (50).
/// In 1D and 2D the missing directions are held (uniaxial strain, plane strain).
struct NeoHookeanLog {
  static constexpr std::string_view word = "neo-hookean-log";

  double lambda = 0;  ///< first Lamé constant, Pa
  double mu = 0;      ///< shear modulus, Pa

  /// Kirchhoff stress τ = J σ = μ F Fᵀ + (λ ln J - μ) I of `count` deformation gradients. No logarithm when λ = 0.
  template <int D>
  void kirchhoff(const Mat<D>* F, PackedMat<D>* tau, std::size_t count) const {
    constexpr std::size_t most = 64;
    Eigen::Array<double, most, 1> spherical;
    for (std::size_t begin = 0; begin < count; begin += most) {
      const std::size_t n = std::min(most, count - begin);
      if (lambda == 0) {
        spherical.setConstant(-mu);
      } else {
        for (std::size_t k = 0; k < n; ++k) spherical[static_cast<int>(k)] = F[begin + k].determinant();
        auto used = spherical.head(static_cast<Eigen::Index>(n));
        used = lambda * used.log() - mu;
      }
      for (std::size_t k = 0; k < n; ++k)
        neo_hookean_stress(F[begin + k], mu, spherical[static_cast<int>(k)], tau[begin + k]);
    }
  }

  /// Strain energy per reference volume, λ/2 (ln J)² - μ ln J + μ/2 (tr F Fᵀ - D).
  template <int D>
  double energy(const Mat<D>& F) const {
    const double log_J = std::log(F.determinant());
    return 0.5 * lambda * log_J * log_J - mu * log_J + 0.5 * mu * (F.squaredNorm() - D);
  }
};

}  // namespace mpmvv::solver
