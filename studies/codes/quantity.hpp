#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mpmvv::codes {

/// A number that a code may write for each particle.
struct Quantity {
  std::string word;       ///< its name: s_xy
  std::string array;      ///< the array of which it is a component: s
  std::size_t component;  ///< its place in the array, row by row, from 0
  std::string mirror;     ///< the word of the component that is the same number: s_yx for s_xy; empty if there is none
  std::vector<std::string> usual;   ///< usual names of its column; those of its mirror come last
  std::vector<std::string> arrays;  ///< usual names of arrays of which its column is one, such as `stress:3`
};

/// Returns all quantities: id, X, Y, Z, x, y, z, u_x, ..., v_x, ..., m, s_xx, ..., time.
const std::vector<Quantity>& all_quantities();

/// Returns the components of an array: "X", "x", "u", "v", "s". A quantity that is no component, such as "m", is an
/// array of one.
std::vector<Quantity> quantities_of(const std::string& array);

/// Returns the place of the quantity in a file's array of so many components, from 0. Tensors of nine components stand
/// row by row, those of six as VTK orders symmetric ones: xx, yy, zz, xy, yz, xz. Of other numbers only the place of xx
/// is known; else nullopt.
std::optional<std::size_t> place_in_array(const Quantity& quantity, std::size_t components);

}  // namespace mpmvv::codes
