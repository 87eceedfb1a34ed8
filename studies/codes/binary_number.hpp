#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mpmvv::codes {

/// How a number is stored.
struct NumberType {
  char kind;         ///< 'i' signed and 'u' unsigned whole numbers, 'f' others
  std::size_t size;  ///< bytes

  int bits() const { return kind != 'f' ? 0 : size == 4 ? 24 : 53; }  ///< of the mantissa
};

/// Int8, UInt8, ..., Float32, Float64 as VTK says, and as PLY says: char, uchar, ..., int8, ..., float, double.
std::optional<NumberType> number_type(std::string_view name);

/// The number that is stored from there on.
double number_at(const char* place, NumberType type, bool is_big_endian);

}  // namespace mpmvv::codes
