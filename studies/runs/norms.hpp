#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// Mean, root mean square and maximum of the particles' displacement errors δ_p, W (64). One NaN makes all three NaN.
class ErrorNorms {
 public:
  void add(double delta) {
    sum_ += delta;
    sum_of_squares_ += delta * delta;
    largest_ = std::max(largest_, delta);
    ++count_;
  }

  double l1() const { return sum_ / static_cast<double>(count_); }
  double l2() const { return std::sqrt(sum_of_squares_ / static_cast<double>(count_)); }
  double linf() const { return std::isnan(sum_) ? sum_ : largest_; }

 private:
  double sum_ = 0, sum_of_squares_ = 0, largest_ = 0;
  std::size_t count_ = 0;
};

}  // namespace mpmvv::runs
