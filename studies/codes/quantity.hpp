#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace mpmvv::codes {

/// A number that a code may write for each particle.
struct Quantity {
  std::string word;                ///< its name: F_xy
  std::string array;               ///< the array of which it is a component: F
  std::size_t component;           ///< its place in the array, row by row, from 0
  std::vector<std::string> usual;  ///< usual names of its column; for s_yx also those of s_xy, as s is symmetric
};

/// Returns all quantities: id, X, Y, Z, x, y, z, u_x, ..., v_x, ..., m, V, F_xx, ..., s_xx, ..., time.
const std::vector<Quantity>& all_quantities();

/// Returns the components of an array: "X", "x", "u", "v", "F", "s". A quantity that is no component, such as "m", is
/// an array of one.
std::vector<Quantity> quantities_of(const std::string& array);

}  // namespace mpmvv::codes
