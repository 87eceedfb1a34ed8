#pragma once
#include <limits>

namespace mpmvv {

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

}  // namespace mpmvv
