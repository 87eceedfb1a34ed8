#pragma once
#include <Eigen/Core>
#include <array>
#include <type_traits>

namespace mpmvv::solver {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>;

template <int D>
using Mat = Eigen::Matrix<double, D, D>;

template <int D>
using Index = std::array<int, D>;

constexpr int power(int base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// N components padded to whole vector registers, as the grid keeps them and the particle loops use them. What the
/// padding holds does not matter.
template <int N>
inline constexpr int lanes = N == 3 ? 4 : N;

template <int N>
using Packed = Eigen::Matrix<double, lanes<N>, 1>;

/// D columns of D components each, padded alike.
template <int D>
using PackedMat = Eigen::Matrix<double, lanes<D>, D>;

/// Four components put together in a register, where Eigen would go through memory.
inline Packed<4> quad(double a, double b, double c, double d) {
  using Register [[gnu::vector_size(32)]] = double;
  const Register together{a, b, c, d};
  return Packed<4>::Map(reinterpret_cast<const double*>(&together));
}

template <int D, class Vector>
auto packed(const Vector& vector) {
  if constexpr (!std::is_same_v<typename Vector::Scalar, double>)
    return vector.eval();
  else if constexpr (D == 3)
    return quad(vector[0], vector[1], vector[2], 0);
  else
    return Packed<D>(vector);
}

/// The vector with one more component.
template <int D>
Packed<D + 1> packed(const Vec<D>& vector, double last) {
  if constexpr (D == 1)
    return {vector[0], last};
  else if constexpr (D == 2)
    return quad(vector[0], vector[1], last, 0);
  else
    return quad(vector[0], vector[1], vector[2], last);
}

/// Zero with one more component.
template <int D>
Packed<D + 1> packed_alone(double last) {
  return packed<D>(Vec<D>(Vec<D>::Zero()), last);
}

}  // namespace mpmvv::solver
