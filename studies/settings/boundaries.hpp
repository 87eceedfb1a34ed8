#pragma once
#include <string>
#include <vector>

namespace mpmvv::settings {

/// Returns the words of all faces (xmin, xmax, ymin, ...) for a boundary setting, which is one word for all of them or
/// names every face, `xmin=symmetry,xmax=free`. Throws UsageError on any other text.
std::vector<std::string> boundary_faces(const std::string& text, int dimension, const std::string& where);

/// Returns the one text that stands for these faces: one word when all are equal, else every face in the order above.
std::string canonical_boundary(const std::string& text, int dimension, const std::string& where);

/// Returns for each axis whether the grid may be shifted along it against the body: each of its faces is periodic or
/// free.
std::vector<bool> movable_axes(const std::vector<std::string>& faces);

}  // namespace mpmvv::settings
