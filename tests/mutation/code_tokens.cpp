#include "tests/mutation/code_tokens.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace mpmvv::mutation {

namespace {

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Reads a text token by token.
class Scanner {
 public:
  Scanner(std::string_view text, Literals literals) : text_(text), keeps_literals_(literals == Literals::kept) {}

  std::vector<Token> all() {
    while (at_ < text_.size()) step();
    mark_brackets();
    return std::move(tokens_);
  }

 private:
  bool looking_at(std::string_view word) const { return text_.substr(at_).starts_with(word); }
  char next() const { return at_ + 1 < text_.size() ? text_[at_ + 1] : '\0'; }

  void step() {
    const char c = text_[at_];
    if (is_space(c)) {
      at_line_start_ = at_line_start_ || c == '\n';
      ++at_;
      return;
    }
    const bool at_line_start = std::exchange(at_line_start_, false);
    if (at_line_start && c == '#') return skip_to("\n");
    if (looking_at("//")) return skip_to("\n");
    if (looking_at("/*")) return skip_past("*/");
    if (looking_at("[[")) return skip_past("]]");
    if (looking_at("R\"") || c == '"' || c == '\'') return pass_literal(c);
    if (is_digit(c) || (c == '.' && is_digit(next()))) return add(Token::Kind::number, number_length());
    if (is_letter(c)) return add(Token::Kind::word, letters());
    add(Token::Kind::sign, sign_length());
  }

  void skip_to(std::string_view end) {
    at_ = std::min(text_.find(end, at_), text_.size());
    at_line_start_ = true;
  }
  void skip_past(std::string_view end) {
    const std::size_t found = text_.find(end, at_ + 2);
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }
  void pass_literal(char first) {
    const std::size_t begin = at_;
    if (first == 'R')
      skip_past(")" + std::string(text_.substr(at_ + 2, text_.find('(', at_) - at_ - 2)) + '"');
    else
      skip_quoted(first);
    if (keeps_literals_) tokens_.push_back({Token::Kind::literal, begin, text_.substr(begin, at_ - begin)});
  }
  void skip_quoted(char quote) {
    for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_)
      if (text_[at_] == '\\') ++at_;
    at_ = std::min(at_ + 1, text_.size());
  }

  std::size_t letters() const {
    return static_cast<std::size_t>(
               std::find_if_not(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.end(), is_letter) -
               text_.begin()) -
           at_;
  }

  /// Digits with separators, point, suffix, and an exponent with its sign.
  std::size_t number_length() const {
    std::size_t end = at_;
    const auto is_part = [&](char c) {
      const char before = text_[end - 1];
      return is_letter(c) || c == '.' || c == '\'' || ((c == '+' || c == '-') && (before == 'e' || before == 'E'));
    };
    for (++end; end < text_.size() && is_part(text_[end]);) ++end;
    return end - at_;
  }

  std::size_t sign_length() const {
    static constexpr std::array signs{"<=>", "<<=", ">>=", "...", "->", "++", "--", "+=", "-=", "*=", "/=",
                                      "%=",  "==",  "!=",  "<=",  ">=", "&&", "||", "<<", ">>", "::"};
    const bool closes = text_[at_] == '>' && at_ > 0 && !is_space(text_[at_ - 1]);  // of brackets, one by one
    for (const std::string_view sign : signs)
      if (looking_at(sign) && !closes) return sign.size();
    return 1;
  }

  void add(Token::Kind kind, std::size_t length) {
    const std::size_t end = at_ + length;
    const bool spaced = (at_ == 0 || is_space(text_[at_ - 1])) && (end == text_.size() || is_space(text_[end]));
    tokens_.push_back({kind, at_, text_.substr(at_, length), spaced});
    at_ = end;
  }

  void mark_brackets() {
    int depth = 0;
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      Token& token = tokens_[k];
      if (token.text == ";" || token.text == "{") depth = 0;
      const bool follows_word = k > 0 && tokens_[k - 1].kind == Token::Kind::word;
      if (token.text == "<" && !token.is_spaced && follows_word) ++depth;
      token.in_brackets = depth > 0;
      if (token.text == ">" && !token.is_spaced && depth > 0) --depth;
    }
  }

  std::string_view text_;
  bool keeps_literals_;
  std::size_t at_ = 0;
  bool at_line_start_ = true;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view text, Literals literals) {
  return Scanner(text, literals).all();
}

std::vector<std::size_t> bracket_partners(const std::vector<Token>& tokens) {
  std::vector<std::size_t> partners(tokens.size(), no_partner), open;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    if (tokens[k].kind != Token::Kind::sign) continue;
    const std::string_view sign = tokens[k].text;
    if (sign == "(" || sign == "[" || sign == "{") open.push_back(k);
    if ((sign != ")" && sign != "]" && sign != "}") || open.empty()) continue;
    partners[k] = open.back(), partners[open.back()] = k;
    open.pop_back();
  }
  return partners;
}

}  // namespace mpmvv::mutation
