#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// Mean, root mean square and maximum of errors, such as the displacement errors δ_p of the particles, W (64). All
/// three are NaN if one error is, or if there is none.
class ErrorNorms {
 public:
  /// Adds the error δ of a particle. It counts for as many particles as this one stands for, itself and its images.
  void add(double delta, int particles = 1) {
    sum_ += particles * delta;
    sum_of_squares_ += particles * delta * delta;
    largest_ = std::max(largest_, delta);
    count_ += particles;
  }

  double l1() const { return sum_ / static_cast<double>(count_); }
  double l2() const { return std::sqrt(sum_of_squares_ / static_cast<double>(count_)); }
  double linf() const { return std::isnan(l1()) ? l1() : largest_; }

 private:
  double sum_ = 0, sum_of_squares_ = 0, largest_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace mpmvv::runs
