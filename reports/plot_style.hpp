#pragma once
#include <string>

#include "reports/chart.hpp"

/// How the series of a figure are told apart, in colour and in grey: each has a colour of its own lightness, a marker
/// and a dash.
namespace mpmvv::reports {

struct Marker {
  int filled = 0, hollow = 0;  ///< the plotting program's point types
};

Marker marker_of(const Style& style);

/// Whether its points are hollow although they are results like others.
bool is_hollow(const Style& style);

/// "lc rgb '#0072B2'", mixed with white on request.
std::string colour_of(const Style& style, double whiteness = 0);

/// The colours of a scale from light to dark: cividis (Nuñez et al. 2018) less its lightest part, of one order of
/// lightness to any colour vision and in grey.
std::string shade_stops();

/// "dt (9,4)".
std::string dash_of(const Style& style);

}  // namespace mpmvv::reports
