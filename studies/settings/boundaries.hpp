#pragma once
#include <string>
#include <vector>

namespace mpmvv::settings {

/// The words of all faces (xmin, xmax, ymin, ...) that a boundary setting describes: one word for all, or
/// `xmin=symmetry,xmax=free` with every face named. UsageError otherwise.
std::vector<std::string> boundary_faces(const std::string& text, int dimension, const std::string& where);

/// The shortest text for the same faces: one word when all are equal.
std::string canonical_boundary(const std::string& text, int dimension, const std::string& where);

/// By axis, whether the grid may be shifted along it against the body: both faces are periodic or free.
std::vector<bool> movable_axes(const std::vector<std::string>& faces);

}  // namespace mpmvv::settings
