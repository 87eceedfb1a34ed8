#pragma once
#include <limits>

/// The two numbers that no measurement should be.
namespace mpmvv {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace mpmvv
