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

}  // namespace mpmvv::solver
