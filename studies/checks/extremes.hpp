#pragma once
#include <Eigen/Core>
#include <cmath>

namespace mpmvv::checks {

// The worst of many numbers. It is NaN once one of them is: what is no number must not pass for a small one.

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
