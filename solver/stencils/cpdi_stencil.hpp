#pragma once
#include "solver/stencils/stencil.hpp"

namespace mpmvv::solver {

/// The nodes of a particle whose domain is a parallelepiped with the columns of R as edges, by convected particle
/// domain interpolation: Sadeghirad, Brannon and Burghardt, Int. J. Numer. Meth. Engng 86 (2011) 1435, N §2.1. In the
/// domain each grid function N_i is replaced by the multilinear interpolant of its values at the corners,
///   x_c = x_p + R s_c/2, s_c in {-1, 1}^D.
/// The particle takes the mean of the interpolant, and the mean of its gradient,
///   N_ip = 2^-D Σ_c N_i(x_c),   ∇N_ip = 2^(1-D) R^-T Σ_c s_c N_i(x_c).
/// As the N_i add up to one and are exact on linear fields, Σ_i N_ip = 1, Σ_i ∇N_ip = 0, and both are exact on linear
/// fields. ∇N is not the derivative of N. Nodes are visited corner by corner. If the nodes of all corners are put
/// together, each with its N_ip and ∇N_ip, visiting them takes 0.7 of the time, but finding them takes longer than that
/// saves.
template <int D, int K>
struct CpdiStencil {
  static constexpr int corners = 1 << D;

  /// Returns component d of s_c.
  static constexpr int sign(int c, int d) { return (c >> d & 1) != 0 ? 1 : -1; }

  std::array<Weights<D, K>, corners> at;  ///< the nodes of each corner, with N_i(x_c)
  PaddedMat<D> slope;                     ///< 2^(1-D) R^-T, per length, by columns: ∇N_ip = slope Σ_c s_c N_i(x_c)

  /// Returns Σ_i N_ip φ_i.
  template <class V>
  V gather(const Array<V>& field) const {
    V sum = at[0].gather(field);
    for (int c = 1; c < corners; ++c) sum += at[c].gather(field);
    return share * sum;
  }

  /// Returns Σ_i N_ip φ_i and Σ_i φ_i ⊗ ∇N_ip.
  ValueAndGradient<D> gather_with_gradient(const Array<Padded<D>>& field) const {
    Padded<D> sum = Padded<D>::Zero();
    PaddedMat<D> differences = PaddedMat<D>::Zero();  // Σ_c φ(x_c) ⊗ s_c
    for (int c = 0; c < corners; ++c) {
      const Padded<D> value = at[c].gather(field);
      sum += value;
      for (int d = 0; d < D; ++d) differences.col(d) += sign(c, d) * value;
    }
    ValueAndGradient<D> result{share * sum, PaddedMat<D>::Zero()};
    for (int d = 0; d < D; ++d)
      for (int e = 0; e < D; ++e) result.gradient.col(d) += slope(d, e) * differences.col(e);
    return result;
  }

  /// φ_i += N_ip value
  template <class V>
  void scatter(const V& value, Array<V>& field) const {
    const V part = share * value;
    for (const auto& corner : at) corner.scatter(part, field);
  }

  /// φ_i += N_ip value + gradient ∇N_ip
  void scatter(const ValueAndGradient<D>& source, Array<Padded<D>>& field) const {
    PaddedMat<D> differences = PaddedMat<D>::Zero();  // gradient slope
    for (int e = 0; e < D; ++e)
      for (int d = 0; d < D; ++d) differences.col(e) += slope(d, e) * source.gradient.col(d);
    for (int c = 0; c < corners; ++c) {
      Padded<D> part = share * source.value;
      for (int d = 0; d < D; ++d) part += sign(c, d) * differences.col(d);
      at[c].scatter(part, field);
    }
  }

 private:
  static constexpr double share = 1.0 / corners;
};

}  // namespace mpmvv::solver
