#pragma once
#include <Eigen/Core>
#include <cmath>

namespace mpmvv::checks {

// These functions find the worst of many numbers. The result is NaN once one of the numbers is NaN, because a NaN must
// not pass for a small number.

inline void keep_larger(double& so_far, double value) {
  if (!(value <= so_far) && !std::isnan(so_far)) so_far = value;
}

inline void keep_smaller(double& so_far, double value) {
  if (!(value >= so_far) && !std::isnan(so_far)) so_far = value;
}

template <class Numbers>
double largest_of(const Eigen::DenseBase<Numbers>& numbers) {
  return numbers.derived().template maxCoeff<Eigen::PropagateNaN>();
}

}  // namespace mpmvv::checks
