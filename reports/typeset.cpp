#include "reports/typeset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>
#include <vector>

#include "reports/text.hpp"

namespace mpmvv::reports {

namespace {

struct Run {
  enum class Kind { text, symbol, raised, lowered };
  Kind kind = Kind::text;
  std::string text;
};

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Letters that mean a quantity wherever they stand alone.
bool is_quantity(char c) {
  return std::string_view("cdhklnprtxyzCEFRTV").find(c) != std::string_view::npos;
}

/// The Greek letter of this name; empty for other words.
std::string greek(const std::string& word) {
  static const std::map<std::string_view, const char*> letters{{"sigma", "σ"}, {"phi", "φ"},    {"rho", "ρ"},
                                                               {"delta", "δ"}, {"lambda", "λ"}, {"nu", "ν"}};
  const auto found = letters.find(word);
  return found == letters.end() ? "" : found->second;
}

/// Cuts a text into runs, from its left to its right.
class Cutter {
 public:
  explicit Cutter(const std::string& text) : text_(text) {}

  std::vector<Run> runs() {
    while (at_ < text_.size())
      if (!sign() && !power() && !between_words() && !word()) add(Run::Kind::text, take(1));
    return std::move(runs_);
  }

 private:
  using Kind = Run::Kind;

  std::string_view rest() const { return std::string_view(text_).substr(at_); }

  std::string take(std::size_t length) {
    const std::string taken = text_.substr(at_, length);
    at_ += length;
    return taken;
  }

  template <class Belongs>
  std::size_t length_of(std::size_t from, const Belongs& belongs) const {
    std::size_t end = from;
    while (end < text_.size() && belongs(text_[end])) ++end;
    return end - from;
  }

  void add(Kind kind, const std::string& text) {
    if (kind == Kind::text && !runs_.empty() && runs_.back().kind == Kind::text)
      runs_.back().text += text;
    else
      runs_.push_back({kind, text});
  }

  /// "-0.5" at the beginning or behind a space.
  bool sign() {
    const bool begins = at_ == 0 || text_[at_ - 1] == ' ';
    if (!begins || !rest().starts_with("-") || at_ + 1 >= text_.size() || !is_digit(text_[at_ + 1])) return false;
    take(1), add(Kind::text, "−");
    return true;
  }

  /// "^-3"
  bool power() {
    if (!rest().starts_with("^")) return false;
    const std::size_t sign = rest().substr(1).starts_with("-") ? 1 : 0;
    const std::size_t digits = length_of(at_ + 1 + sign, [](char c) { return is_digit(c) || c == '.'; });
    if (digits == 0) return false;
    take(1);
    add(Kind::raised, take(sign + digits));
    return true;
  }

  /// A minus sign or a times sign between two terms.
  bool between_words() {
    if (rest().starts_with(" - ")) {
      take(3), add(Kind::text, " − ");
      return true;
    }
    if (!rest().starts_with(" x ") || at_ == 0 || at_ + 3 >= text_.size()) return false;
    if (!is_digit(text_[at_ - 1]) || !is_digit(text_[at_ + 3])) return false;
    take(3), add(Kind::text, " × ");
    return true;
  }

  bool follows_number() const { return at_ >= 2 && text_[at_ - 1] == ' ' && is_digit(text_[at_ - 2]); }

  /// Within a word that was begun before, or in a letter beyond ASCII, no symbol begins; but "Δt" is one.
  bool may_begin_symbol() const {
    if (at_ == 0) return true;
    const char before = text_[at_ - 1];
    if (static_cast<unsigned char>(before) >= 0x80) return std::string_view(text_).substr(0, at_).ends_with("Δ");
    return before != '-' && before != '\'' && !std::isalpha(static_cast<unsigned char>(before));
  }

  bool is_symbol(const std::string& word) const {
    if (!greek(word).empty()) return true;
    if (word.size() != 1 || !may_begin_symbol()) return false;
    const auto after = rest().substr(1);
    if (!after.empty() && (static_cast<unsigned char>(after[0]) >= 0x80 && !after.starts_with("²"))) return false;
    if (is_quantity(word[0])) return !after.starts_with("-") && !after.starts_with("'");
    return after.starts_with(" =") || after.starts_with("_");
  }

  bool word() {
    const std::size_t length = length_of(at_, is_word);
    if (length == 0) return false;
    if (number(length)) return true;
    const std::string name = text_.substr(at_, length);
    const std::size_t below = text_.substr(at_ + length, 1) == "_" ? length_of(at_ + length + 1, is_word) : 0;
    const bool symbol = is_symbol(name);
    if (symbol)
      add(Kind::symbol, greek(name).empty() ? name : greek(name));
    else
      add(Kind::text, name == "us" && follows_number() ? "μs" : name);
    take(length);
    const bool capitals = std::ranges::all_of(name, [](char c) { return c >= 'A' && c <= 'Z'; });
    if (below == 0 || below > 2 || !(symbol || capitals)) return true;
    take(1);
    add(Kind::lowered, take(below));
    return true;
  }

  /// "4e-6", and any other number.
  bool number(std::size_t length) {
    if (!is_digit(text_[at_])) return false;
    const std::size_t mantissa = length_of(at_, [](char c) { return is_digit(c) || c == '.'; });
    const std::size_t sign = text_.substr(at_ + mantissa, 2) == "e-" ? 1 : 0;
    const std::size_t digits =
        text_.substr(at_ + mantissa, 1) == "e" ? length_of(at_ + mantissa + 1 + sign, is_digit) : 0;
    if (digits == 0) {
      const bool factor = length == mantissa + 1 && is_quantity(text_[at_ + mantissa]);
      add(Kind::text, take(factor ? mantissa : std::max(length, mantissa)));
      return true;
    }
    const std::string digits_before = take(mantissa);
    add(Kind::text, digits_before == "1" ? "10" : digits_before + "·10");
    take(1);
    add(Kind::raised, take(sign + digits));
    return true;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::vector<Run> runs_;
};

std::string with_escapes(const std::string& text) {
  std::string result;
  for (const char c : text)
    result +=
        std::string_view("^_{}@&~\\").find(c) == std::string_view::npos ? std::string(1, c) : std::string("\\") + c;
  return result;
}

/// "\sigma" of "$\sigma$".
std::string in_mathematics(const std::string& text) {
  const std::string set = latex_text(text);
  return set.starts_with('$') ? set.substr(1, set.size() - 2) : set;
}

std::string enhanced(const Run& run) {
  switch (run.kind) {
    case Run::Kind::text:
      return with_escapes(run.text);
    case Run::Kind::symbol:
      return fmt::format("{{/:Italic {}}}", run.text);
    case Run::Kind::raised:
      return fmt::format("^{{{}}}", run.text);
    case Run::Kind::lowered:
      return fmt::format("_{{{}}}", run.text);
  }
  return "";
}

std::string latex(const Run& run) {
  switch (run.kind) {
    case Run::Kind::text:
      return replace_all(latex_text(run.text), "   ", "\\quad ");
    case Run::Kind::symbol:
      return fmt::format("${}$", in_mathematics(run.text));
    case Run::Kind::raised:
      return fmt::format("$^{{{}}}$", run.text);
    case Run::Kind::lowered:
      return fmt::format("$_{{{}}}$", run.text);
  }
  return "";
}

}  // namespace

std::string typeset(const std::string& text, Notation notation) {
  if (notation == Notation::plain) return text;
  std::string result;
  for (const Run& run : Cutter(text).runs()) result += notation == Notation::latex ? latex(run) : enhanced(run);
  return result;
}

}  // namespace mpmvv::reports
