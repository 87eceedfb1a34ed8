#pragma once
#include <limits>

namespace mpmvv::support {

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

}  // namespace mpmvv::support
