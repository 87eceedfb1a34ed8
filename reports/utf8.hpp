#pragma once
#include <cstddef>
#include <string_view>

/// Characters of texts in UTF-8.
namespace mpmvv::reports {

/// Bytes of the character that starts with this one; 1 for a byte that starts none.
inline std::size_t utf8_length(unsigned char lead) {
  return lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
}

/// The character at the beginning of a text; empty where the text is.
inline std::string_view first_character(std::string_view text) {
  return text.empty() ? text : text.substr(0, utf8_length(static_cast<unsigned char>(text[0])));
}

/// The character at the end of a text; empty where the text is.
inline std::string_view last_character(std::string_view text) {
  if (text.empty()) return text;
  std::size_t begin = text.size() - 1;
  while (begin > 0 && (static_cast<unsigned char>(text[begin]) & 0xC0u) == 0x80) --begin;
  return text.substr(begin);
}

/// The number of a character; 0 for an empty text.
inline unsigned code_point(std::string_view character) {
  constexpr unsigned lead_bits[] = {0, 0xFF, 0x1F, 0x0F, 0x07};
  if (character.empty()) return 0;
  unsigned code = static_cast<unsigned char>(character[0]) & lead_bits[character.size()];
  for (const char c : character.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  return code;
}

}  // namespace mpmvv::reports
