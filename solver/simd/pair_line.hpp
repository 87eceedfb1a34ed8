#pragma once
#include <array>
#include <cstddef>

#include "solver/simd/double4.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

/// K >= 2 neighbouring nodes along the first axis of a plane with two components each, two nodes to a register and the
/// last one, where K is odd, in half of one.
template <int K>
class PairLine {
 public:
  /// c φ_i
  [[gnu::always_inline]] PairLine(double c, const Padded<2>* nodes) {
    load(nodes);
    for (Double4& q : quads_) q *= c;
    if constexpr (is_odd) last_ *= c;
  }

  /// N_i value
  [[gnu::always_inline]] PairLine(const double* N, const Padded<2>& value) {
    for (std::size_t k = 0; k < quads_.size(); ++k)
      quads_[k] =
          Double4{N[2 * k], N[2 * k], N[2 * k + 1], N[2 * k + 1]} * Double4{value[0], value[1], value[0], value[1]};
    if constexpr (is_odd) last_ = N[K - 1] * Double2{value[0], value[1]};
  }

  [[gnu::always_inline]] void operator+=(const PairLine& other) {
    for (std::size_t k = 0; k < quads_.size(); ++k) quads_[k] += other.quads_[k];
    if constexpr (is_odd) last_ += other.last_;
  }

  /// φ_i += c times this + d times another
  [[gnu::always_inline]] void add_to(Padded<2>* nodes, double c, double d, const PairLine& other) const {
    PairLine sum(nodes);
    for (std::size_t k = 0; k < quads_.size(); ++k) sum.quads_[k] += c * quads_[k] + d * other.quads_[k];
    if constexpr (is_odd) sum.last_ += c * last_ + d * other.last_;
    sum.store(nodes);
  }

  /// Σ_i N_i times the i-th of this
  [[gnu::always_inline]] Padded<2> weighted(const double* N) const {
    Double4 wide = Double4{N[0], N[0], N[1], N[1]} * quads_[0];
    for (std::size_t k = 1; k < quads_.size(); ++k)
      wide += Double4{N[2 * k], N[2 * k], N[2 * k + 1], N[2 * k + 1]} * quads_[k];
    Double2 narrow = __builtin_shufflevector(wide, wide, 0, 1) + __builtin_shufflevector(wide, wide, 2, 3);
    if constexpr (is_odd) narrow += N[K - 1] * last_;
    return {narrow[0], narrow[1]};
  }

 private:
  static constexpr bool is_odd = K % 2 == 1;

  [[gnu::always_inline]] explicit PairLine(const Padded<2>* nodes) { load(nodes); }

  [[gnu::always_inline]] void load(const Padded<2>* nodes) {
    for (std::size_t k = 0; k < quads_.size(); ++k) quads_[k] = load4(nodes[2 * k].data());
    if constexpr (is_odd) last_ = load2(nodes[K - 1].data());
  }
  [[gnu::always_inline]] void store(Padded<2>* nodes) const {
    for (std::size_t k = 0; k < quads_.size(); ++k) store4(quads_[k], nodes[2 * k].data());
    if constexpr (is_odd) store2(last_, nodes[K - 1].data());
  }

  std::array<Double4, K / 2> quads_;
  Double2 last_;
};

}  // namespace mpmvv::solver
