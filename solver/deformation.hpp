#pragma once
#include "solver/types.hpp"

namespace mpmvv::solver {

/// How F follows the velocity gradient L through a step.
enum class Deformation {
  linear,      ///< F' = (I + Δt L) F       S (7), (8), W (11)
  exponential  ///< F' = exp(Δt L) F        N table 1, task 5: a rigid rotation stays one, a trace of zero keeps J
};

/// C + A B
template <int D>
inline PackedMat<D> plus_product(const auto& C, const PackedMat<D>& A, const auto& B) {
  PackedMat<D> result;
  for (int c = 0; c < D; ++c) {
    Packed<D> column = packed<D>(C.col(c));
    for (int d = 0; d < D; ++d) column += B(d, c) * A.col(d);
    result.col(c) = column;
  }
  return result;
}

/// exp(A) - I by twelve terms, in powers of A³ (Paterson and Stockmeyer): the rest, |A|¹³/13!, is round-off up to
/// |A| = 0.4, and 2e-13 at 0.6.
template <int D>
[[gnu::noinline]] PackedMat<D> exponential_less_identity(const PackedMat<D>& A) {
  constexpr double share[] = {1,         1. / 2,     1. / 6,      1. / 24,      1. / 120,      1. / 720,
                              1. / 5040, 1. / 40320, 1. / 362880, 1. / 3628800, 1. / 39916800, 1. / 479001600};
  const PackedMat<D> zero = PackedMat<D>::Zero();
  const PackedMat<D> A2 = plus_product<D>(zero, A, A), A3 = plus_product<D>(zero, A, A2);
  const auto three = [&](const double* c) -> PackedMat<D> { return c[0] * A + c[1] * A2 + c[2] * A3; };
  PackedMat<D> sum = three(share + 9);
  for (int k = 6; k >= 0; k -= 3) sum = plus_product<D>(three(share + k), A3, sum);
  return sum;
}

/// A step of F, of a length of its own.
template <int D>
struct DeformationStep {
  double dt;
  Deformation rule = Deformation::linear;

  [[gnu::always_inline]] void operator()(Mat<D>& F, const PackedMat<D>& L) const {
    PackedMat<D> increment;
    for (int d = 0; d < D; ++d) increment.col(d) = dt * L.col(d);  // at once, a plane's would go through memory
    if (rule == Deformation::exponential) return advance_exponentially(F, PackedMat<D>(increment));
    F = plus_product<D>(F, increment, F).template topRows<D>();
  }

 private:
  [[gnu::noinline]] static void advance_exponentially(Mat<D>& F, const PackedMat<D>& dt_L) {
    F = plus_product<D>(F, exponential_less_identity<D>(dt_L), F).template topRows<D>();
  }
};

}  // namespace mpmvv::solver
