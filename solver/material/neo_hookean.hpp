#pragma once
#include "solver/types.hpp"

namespace mpmvv::solver {

/// τ = μ F Fᵀ + s I: the Kirchhoff stress of every neo-Hookean law, which differ in s.
template <int D>
void neo_hookean_stress(const Mat<D>& F, double mu, double s, PackedMat<D>& tau) {
  const PackedMat<D> identity = PackedMat<D>::Identity();
  Packed<D> columns[D];
  for (int c = 0; c < D; ++c) columns[c] = packed<D>(mu * F.col(c));
  for (int c = 0; c < D; ++c) {
    Packed<D> column = s * identity.col(c);
    for (int d = 0; d < D; ++d) column += F(c, d) * columns[d];
    tau.col(c) = column;
  }
}

}  // namespace mpmvv::solver
