#include "studies/codes/binary_number.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <map>

namespace mpmvv::codes {

std::optional<NumberType> number_type(std::string_view name) {
  static const std::map<std::string, NumberType> types{
      {"int8", {'i', 1}},   {"uint8", {'u', 1}}, {"int16", {'i', 2}},  {"uint16", {'u', 2}},  {"int32", {'i', 4}},
      {"uint32", {'u', 4}}, {"int64", {'i', 8}}, {"uint64", {'u', 8}}, {"float32", {'f', 4}}, {"float64", {'f', 8}},
      {"char", {'i', 1}},   {"uchar", {'u', 1}}, {"short", {'i', 2}},  {"ushort", {'u', 2}},  {"int", {'i', 4}},
      {"uint", {'u', 4}},   {"float", {'f', 4}}, {"double", {'f', 8}},
  };
  std::string small(name);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto found = types.find(small);
  return found == types.end() ? std::nullopt : std::optional(found->second);
}

double number_at(const char* place, NumberType type, bool is_big_endian) {
  unsigned char bytes[8] = {};  // the least significant one first
  std::memcpy(bytes, place, type.size);
  if (is_big_endian) std::reverse(bytes, bytes + type.size);
  std::uint64_t whole = 0;
  for (std::size_t k = type.size; k-- > 0;) whole = whole << 8 | bytes[k];
  if (type.kind == 'f') {
    if (type.size == 4) return std::bit_cast<float>(static_cast<std::uint32_t>(whole));
    return std::bit_cast<double>(whole);
  }
  if (type.kind == 'u') return static_cast<double>(whole);
  const auto unused = 64 - 8 * static_cast<int>(type.size);
  return static_cast<double>(static_cast<std::int64_t>(whole << unused) >> unused);
}

}  // namespace mpmvv::codes
