#pragma once
#include <string>

namespace mpmvv::reports {

/// The label of an axis of errors: the quantity in words, with its unit, as in "RMS displacement error (m)" for `l2`.
/// A quantity that runs do not have stands as it is; without one it is "error".
std::string error_axis_label(const std::string& quantity);

/// The label of an axis of the key that a stability limit is searched in: "CFL number" for `cfl`.
std::string limit_axis_label(const std::string& key);

}  // namespace mpmvv::reports
