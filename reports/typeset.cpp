#include "reports/typeset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>
#include <vector>

#include "reports/text.hpp"
#include "reports/utf8.hpp"

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

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Letters that mean a quantity wherever they stand alone. The others are words, units or names as well.
bool is_quantity(char c) {
  return std::string_view("cdefhijklnpqrtuvwxyzCEFGLPQRTUVXYZ").find(c) != std::string_view::npos;
}

/// À to ɏ.
bool is_latin_letter(std::string_view character) {
  const unsigned code = code_point(character);
  return code >= 0xC0 && code < 0x250 && code != 0xD7 && code != 0xF7;
}

/// α to ω, and the other forms of θ, φ and ε. Capitals are upright everywhere.
bool is_small_greek(std::string_view character) {
  const unsigned code = code_point(character);
  return (code >= 0x3B1 && code <= 0x3C9) || code == 0x3D1 || code == 0x3D5 || code == 0x3F5;
}

/// The Greek letter of this name; empty for other words.
std::string greek(const std::string& word) {
  static const std::map<std::string_view, const char*> letters{
      {"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"},  {"delta", "δ"}, {"epsilon", "ε"}, {"zeta", "ζ"}, {"eta", "η"},
      {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"},    {"nu", "ν"},      {"xi", "ξ"},   {"pi", "π"},
      {"rho", "ρ"},   {"sigma", "σ"}, {"tau", "τ"},    {"phi", "φ"},   {"chi", "χ"},     {"psi", "ψ"},  {"omega", "ω"}};
  const auto found = letters.find(word);
  return found == letters.end() ? "" : found->second;
}

/// Cuts a text into runs, from its left to its right.
class Cutter {
 public:
  explicit Cutter(const std::string& text) : text_(text) {}

  std::vector<Run> runs() {
    while (at_ < text_.size())
      if (!sign() && !power() && !between_words() && !greek_letter() && !word()) add(Run::Kind::text, take(1));
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

  /// "^-3", "^p"
  bool power() {
    if (!rest().starts_with("^")) return false;
    const std::size_t sign = rest().substr(1).starts_with("-") ? 1 : 0, from = at_ + 1 + sign;
    std::size_t length = length_of(from, [](char c) { return is_digit(c) || c == '.'; });
    if (length == 0 && length_of(from, is_letter) == 1) length = 1;
    while (length > 0 && text_[from + length - 1] == '.') --length;  // a sentence's full stop
    if (length == 0) return false;
    take(1);
    add(Kind::raised, take(sign + length));
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

  /// Whether a letter here would be a part of a word that goes on before it: of "Léon", "it's", "B-spline", "i.e.".
  bool goes_on_before() const {
    const std::string_view before = std::string_view(text_).substr(0, at_);
    const std::string_view last = last_character(before);
    if (last.empty()) return false;
    if (is_latin_letter(last)) return true;
    const char c = last[0];
    if (c == '-') return before.size() > 2 && is_word(before[before.size() - 2]) && is_word(before[before.size() - 3]);
    if (c == '.') return before.size() > 1 && is_letter(before[before.size() - 2]);
    return c == '\'' || is_letter(c) || last == "μ" || last == "\u00B5";
  }

  /// The same behind the letter.
  bool goes_on_behind() const {
    const std::string_view after = rest().substr(1);
    if (after.empty()) return false;
    const bool has_two = after.size() > 2 && is_word(after[2]);
    if (after[0] == '-') return after.size() > 1 && is_letter(after[1]) && has_two;
    if (after[0] == '.') return after.size() > 1 && is_letter(after[1]);
    return after[0] == '\'' || is_latin_letter(first_character(after));
  }

  bool is_symbol(const std::string& word) const {
    if (!greek(word).empty()) return at_ == 0 || text_[at_ - 1] != '\\';
    if (word.size() != 1 || !is_letter(word[0]) || goes_on_before() || goes_on_behind()) return false;
    if (is_quantity(word[0])) return true;
    const auto after = rest().substr(1);
    return after.starts_with(" =") || after.starts_with("=") || after.starts_with("_");
  }

  /// "σ", but not the "μ" of "μs".
  bool greek_letter() {
    const std::string letter(first_character(rest()));
    if (!is_small_greek(letter)) return false;
    const bool is_unit = letter == "μ" && length_of(at_ + letter.size(), is_letter) > 0;
    add(is_unit ? Kind::text : Kind::symbol, take(letter.size()));
    if (!is_unit) index();
    return true;
  }

  /// What stands lowered behind a symbol: "_xx".
  void index(std::size_t most = std::string::npos) {
    const std::size_t length = rest().starts_with("_") ? length_of(at_ + 1, is_word) : 0;
    if (length == 0 || length > most) return;
    take(1);
    add(Kind::lowered, take(length));
  }

  bool word() {
    constexpr std::size_t most_of_a_name = 2;  // CFL_X
    const std::size_t length = length_of(at_, is_word);
    if (length == 0) return false;
    if (number(length)) return true;
    const std::string name = text_.substr(at_, length);
    const bool symbol = is_symbol(name);
    if (symbol)
      add(Kind::symbol, greek(name).empty() ? name : greek(name));
    else
      add(Kind::text, name == "us" && follows_number() ? "μs" : name);
    take(length);
    const bool capitals = std::ranges::all_of(name, [](char c) { return c >= 'A' && c <= 'Z'; });
    if (symbol)
      index();
    else if (capitals)
      index(most_of_a_name);
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

/// Whether what is raised or lowered is a symbol, or the two of a component: "h", "xx". Longer ones are words.
bool is_italic(const std::string& text) {
  constexpr std::size_t most = 2;
  return text.size() <= most && std::ranges::all_of(text, is_letter);
}

std::string enhanced(const Run& run) {
  const std::string inner = is_italic(run.text) ? "/:Italic " + run.text : run.text;
  switch (run.kind) {
    case Run::Kind::text:
      return with_escapes(run.text);
    case Run::Kind::symbol:
      return fmt::format("{{/:Italic {}}}", run.text);
    case Run::Kind::raised:
      return fmt::format("^{{{}}}", inner);
    case Run::Kind::lowered:
      return fmt::format("_{{{}}}", inner);
  }
  return "";
}

std::string latex(const Run& run) {
  const bool is_word = std::ranges::any_of(run.text, is_letter) && !is_italic(run.text);
  const std::string inner = is_word ? fmt::format("\\mathrm{{{}}}", run.text) : run.text;
  switch (run.kind) {
    case Run::Kind::text:
      return replace_all(latex_text(run.text), "   ", "\\quad ");
    case Run::Kind::symbol:
      return fmt::format("${}$", in_mathematics(run.text));
    case Run::Kind::raised:
      return fmt::format("$^{{{}}}$", inner);
    case Run::Kind::lowered:
      return fmt::format("$_{{{}}}$", inner);
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
