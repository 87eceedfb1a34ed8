#include "studies/support/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace mpmvv::support {

namespace {

struct Character {
  std::size_t bytes;  ///< 1 where the text does not begin with a character of UTF-8
  std::uint32_t point;
  bool good;
};

Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) -> std::uint32_t { return static_cast<unsigned char>(text[k]); };
  const std::uint32_t lead = byte(0);
  const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xc0 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf8 ? 4 : 0;
  if (bytes == 0 || bytes > text.size()) return {1, lead, false};
  std::uint32_t point = bytes == 1 ? lead : lead & (0x7fU >> bytes);
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(k) & 0xc0) != 0x80) return {1, lead, false};
    point = point << 6 | (byte(k) & 0x3f);
  }
  constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = point >= 0xd800 && point < 0xe000;
  if (point < least[bytes] || point > 0x10ffff || surrogate) return {1, lead, false};
  return {bytes, point, true};
}

bool acts_on_a_terminal(std::uint32_t point) {
  struct Range {
    std::uint32_t from, to;
  };
  // Controls; marks of direction; separators of lines and embeddings of direction; isolates of direction.
  constexpr std::array<Range, 6> ranges{
      {{0, 0x1f}, {0x7f, 0x9f}, {0x61c, 0x61c}, {0x200e, 0x200f}, {0x2028, 0x202e}, {0x2066, 0x2069}}};
  return std::any_of(ranges.begin(), ranges.end(), [point](Range r) { return r.from <= point && point <= r.to; });
}

void add_escaped(std::string& line, char byte) {
  if (byte == '\n')
    line += "\\n";
  else if (byte == '\t')
    line += "\\t";
  else if (byte == '\r')
    line += "\\r";
  else
    line += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
}

}  // namespace

std::string printable(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const Character c = first_character(text);
    const std::string_view bytes = text.substr(0, c.bytes);
    if (c.good && !acts_on_a_terminal(c.point))
      line += bytes;
    else
      for (const char byte : bytes) add_escaped(line, byte);
    text.remove_prefix(c.bytes);
  }
  return line;
}

}  // namespace mpmvv::support
