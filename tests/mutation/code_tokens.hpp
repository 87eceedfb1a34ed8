#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace mpmvv::mutation {

/// A word, number or sign of C++ code.
struct Token {
  enum class Kind { word, number, sign };

  Kind kind = Kind::sign;
  std::size_t at = 0;        ///< first byte
  std::string_view text;     ///< of the text that was read, which must outlive it
  bool is_spaced = false;    ///< white space on either side
  bool in_brackets = false;  ///< within a template's parameters or arguments
};

/// The tokens of a text laid out by the house's clang-format, which puts spaces about binary operators and none inside
/// template brackets. Comments, strings, characters, attributes and preprocessor lines are left out.
std::vector<Token> tokens_of(std::string_view text);

}  // namespace mpmvv::mutation
