#pragma once
#include <string>

namespace mpmvv::cli {

inline constexpr double mm_per_inch = 25.4, points_per_inch = 72;

/// "84mm", "8.4cm", "3.3in" or "240pt" in mm; UsageError of the option when it is no such length, or beyond these ends.
double length_of(const std::string& option, const std::string& text, double least, double most);

}  // namespace mpmvv::cli
