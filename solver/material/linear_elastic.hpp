#pragma once
#include <cstddef>
#include <string_view>

#include "solver/types.hpp"

namespace mpmvv::solver {

/// Linear elasticity for small displacement gradients, N §3.3: P = λ tr ε I + 2 G ε with ε = (F + Fᵀ)/2 - I, taken as
/// stress per reference area, so that it has a potential and the equation of motion is linear in reference coordinates.
/// Rotations strain it: they must be small too. In 1D and 2D the missing directions are held.
struct LinearElastic {
  static constexpr std::string_view word = "linear-elastic";

  double lambda = 0;  ///< first Lamé constant, Pa
  double mu = 0;      ///< shear modulus G, Pa

  /// Kirchhoff stress τ = P Fᵀ of `count` deformation gradients; symmetric for a symmetric F alone.
  template <int D>
  void kirchhoff(const Mat<D>* F, PackedMat<D>* tau, std::size_t count) const {
    for (std::size_t k = 0; k < count; ++k) {
      const Mat<D> strain = small_strain<D>(F[k]);
      const Mat<D> P = lambda * strain.trace() * Mat<D>::Identity() + 2 * mu * strain;
      for (int c = 0; c < D; ++c) {
        Packed<D> column = F[k](c, 0) * packed<D>(P.col(0));
        for (int d = 1; d < D; ++d) column += F[k](c, d) * packed<D>(P.col(d));
        tau[k].col(c) = column;
      }
    }
  }

  /// Strain energy per reference volume, λ/2 (tr ε)² + G ε : ε.
  template <int D>
  double energy(const Mat<D>& F) const {
    const Mat<D> strain = small_strain<D>(F);
    return 0.5 * lambda * strain.trace() * strain.trace() + mu * strain.squaredNorm();
  }

 private:
  template <int D>
  static Mat<D> small_strain(const Mat<D>& F) {
    return 0.5 * (F + F.transpose()) - Mat<D>::Identity();
  }
};

}  // namespace mpmvv::solver
