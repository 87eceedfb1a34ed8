#pragma once
#include <string_view>

#include "solver/types.hpp"

namespace mpmvv::solver {

/// Linear elasticity for small displacement gradients, N §3.3: P = λ tr ε I + 2 G ε with ε = (F + Fᵀ)/2 - I. P is taken
/// as stress per reference area, so that it has a potential and the equation of motion is linear in reference
/// coordinates. Rotations cause strain, so they must be small, too. In 1D and 2D the missing directions are held
/// (uniaxial strain, plane strain).
struct LinearElastic {
  static constexpr std::string_view word = "linear-elastic";

  double lambda = 0;  ///< first Lamé constant, Pa
  double mu = 0;      ///< shear modulus G, Pa

  /// Kirchhoff stress τ = P Fᵀ. In general it is symmetric only if F is symmetric.
  template <class Scalar, int D>
  Eigen::Matrix<Scalar, D, D> kirchhoff(const Eigen::Matrix<Scalar, D, D>& F) const {
    const auto strain = small_strain(F);
    const Scalar spherical = lambda * strain.trace();
    Eigen::Matrix<Scalar, D, D> P = (2 * mu) * strain;
    for (int d = 0; d < D; ++d) P(d, d) += spherical;
    return P * F.transpose();
  }

  /// Strain energy per reference volume, λ/2 (tr ε)² + G ε : ε.
  template <int D>
  double energy(const Mat<D>& F) const {
    const Mat<D> strain = small_strain(F);
    return 0.5 * lambda * strain.trace() * strain.trace() + mu * strain.squaredNorm();
  }

 private:
  template <class Scalar, int D>
  static Eigen::Matrix<Scalar, D, D> small_strain(const Eigen::Matrix<Scalar, D, D>& F) {
    return 0.5 * (F + F.transpose()) - Eigen::Matrix<Scalar, D, D>::Identity();
  }
};

}  // namespace mpmvv::solver
