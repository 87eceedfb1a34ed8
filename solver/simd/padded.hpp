#pragma once
#include "solver/simd/double4.hpp"
#include "solver/types.hpp"

/// Vectors as the grid keeps them and the loops over particles use them: one of three components is padded to four, so
/// that it fills a vector register. What the padding holds does not matter.
namespace mpmvv::solver {

template <int N>
inline constexpr int padded_size = N == 3 ? 4 : N;

template <int N>
using Padded = Eigen::Matrix<double, padded_size<N>, 1>;

/// D columns of D components each, every column padded.
template <int D>
using PaddedMat = Eigen::Matrix<double, padded_size<D>, D>;

/// Returns a vector of four components. It is put together in a register, where Eigen would go through memory.
inline Padded<4> padded_of(double a, double b, double c, double d) {
  const Double4 together{a, b, c, d};
  return Padded<4>::Map(reinterpret_cast<const double*>(&together));
}

template <int D, class Vector>
auto padded(const Vector& vector) {
  if constexpr (D == 3)
    return padded_of(vector[0], vector[1], vector[2], 0);
  else
    return typename Vector::PlainObject(vector);
}

/// Returns the vector with `last` as one more component.
template <int D>
Padded<D + 1> padded(const Vec<D>& vector, double last) {
  if constexpr (D == 1)
    return {vector[0], last};
  else if constexpr (D == 2)
    return padded_of(vector[0], vector[1], last, 0);
  else
    return padded_of(vector[0], vector[1], vector[2], last);
}

/// Returns D zeros, with `last` as one more component.
template <int D>
Padded<D + 1> padded_alone(double last) {
  return padded<D>(Vec<D>(Vec<D>::Zero()), last);
}

}  // namespace mpmvv::solver
