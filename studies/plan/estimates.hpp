#pragma once
#include "studies/cases/case.hpp"

namespace mpmvv::plan {

/// Number of particles times steps, more for an expanded inverse: to run long cases first.
double work_estimate(const cases::Case& c);

/// Seconds that a check takes, of which nothing is known; the longest take some.
inline constexpr double about_check = 5;

/// Upper estimate of the memory that a run of this case takes, in bytes, where only one in so many particles is run.
double memory_estimate(const cases::Case& c, int images = 1);

}  // namespace mpmvv::plan
