#pragma once
#include <string>

namespace mpmvv::cli {

inline constexpr double least_width = 40, greatest_width = 400;  ///< of a figure, in mm

/// --width, --height and --font-size of a figure, given as "84mm", "8.4cm", "3.3in" or "8pt". UsageError when one is no
/// such length, or too small or large.
double figure_width(const std::string& text);      ///< in mm
double figure_height(const std::string& text);     ///< in mm
double figure_font_size(const std::string& text);  ///< in points

}  // namespace mpmvv::cli
