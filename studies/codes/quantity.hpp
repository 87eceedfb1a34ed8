#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace mpmvv::codes {

/// A number that a code may write of each particle.
struct Quantity {
  std::string word;                ///< F_xy
  std::string array;               ///< that it is a component of: F
  std::size_t component;           ///< of the array, row by row
  std::vector<std::string> usual;  ///< names of columns that have it, in many codes' files
};

/// id, X, Y, Z, x, y, z, u_x, ..., v_x, ..., m, V, F_xx, ..., s_xx, ..., time.
const std::vector<Quantity>& all_quantities();

/// The components of an array: "X", "x", "u", "v", "F", "s"; a number of its own is an array of one.
std::vector<Quantity> quantities_of(const std::string& array);

}  // namespace mpmvv::codes
