#pragma once
#include <Eigen/Core>
#include <array>

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

}  // namespace mpmvv::solver
