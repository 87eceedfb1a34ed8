#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mpmvv::codes {

/// The binary type of a number.
struct NumberType {
  char kind;         ///< 'i': signed whole number, 'u': unsigned whole number, 'f': floating point
  std::size_t size;  ///< its size in bytes

  int bits() const { return kind != 'f' ? 0 : size == 4 ? 24 : 53; }  ///< bits of the mantissa; 0 for whole numbers
};

/// Returns the type with this name, in small or capital letters: Int8, UInt8, ..., Float32, Float64 as VTK writes it,
/// or char, uchar, ..., int8, ..., float, double as PLY does. Returns nullopt for any other name.
std::optional<NumberType> number_type(std::string_view name);

/// Returns the number whose first byte is at `place`.
double number_at(const char* place, NumberType type, bool is_big_endian);

}  // namespace mpmvv::codes
