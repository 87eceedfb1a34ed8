#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace mpmvv::mutation {

/// A word, number, sign or literal (a string, a character) of C++ code.
struct Token {
  enum class Kind { word, number, sign, literal };

  Kind kind = Kind::sign;
  std::size_t at = 0;        ///< first byte
  std::string_view text;     ///< of the text that was read, which must outlive it
  bool is_spaced = false;    ///< white space on either side
  bool in_brackets = false;  ///< within a template's parameters or arguments
};

enum class Literals { left_out, kept };

/// The tokens of a text laid out by the project's clang-format, which puts spaces about binary operators and none
/// inside template brackets. Comments, attributes and preprocessor lines are left out, and so are literals unless they
/// are asked for.
std::vector<Token> tokens_of(std::string_view text, Literals literals = Literals::left_out);

/// For each token that is a bracket ((), [] or {}) the index of its partner; `no_partner` for all others.
inline constexpr std::size_t no_partner = static_cast<std::size_t>(-1);
std::vector<std::size_t> bracket_partners(const std::vector<Token>& tokens);

}  // namespace mpmvv::mutation
