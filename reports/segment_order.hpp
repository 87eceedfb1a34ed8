#pragma once
#include <string>

#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// The order of a norm between the swept value x and the usable one below it; NaN where none was fitted or there is
/// none below.
double segment_order(const records::Series& series, const std::string& norm, double x);

}  // namespace mpmvv::reports
