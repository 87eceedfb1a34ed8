#include "tests/mutation/mutant_schemata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "tests/mutation/code_tokens.hpp"

namespace mpmvv::mutation {

namespace {

constexpr std::size_t none = no_partner;

template <std::size_t N>
bool is_one_of(std::string_view text, const std::array<std::string_view, N>& words) {
  return std::ranges::find(words, text) != words.end();
}

/// The blocks and statements of a text, found by its brackets.
class Statements {
 public:
  explicit Statements(const std::string& text) : tokens_(tokens_of(text)), partner_(bracket_partners(tokens_)) {}

  /// The code that has to stand twice, with the edit and without, so that the edit can be chosen: a statement, or from
  /// there the rest of the block, which sees what the statement declares. None where that cannot be.
  std::optional<Region> around(const Region& edit, bool declares) const {
    std::optional<Region> found;
    for (std::size_t brace = tokens_.size(); brace-- > 0;) {
      if (at(brace) != "{" || partner_[brace] == none || !inside(brace).holds(edit) || !is_body(brace)) continue;
      if (is_constant(brace)) return std::nullopt;
      if (!found) found = statement_in(brace, edit, declares);
      if (!found) return std::nullopt;
    }
    return found;
  }

  /// Whether the statement that begins at a byte declares what others may see.
  bool declares(std::size_t byte) const {
    const auto token = std::ranges::lower_bound(tokens_, byte, {}, &Token::at);
    const auto k = static_cast<std::size_t>(token - tokens_.begin());
    return k < tokens_.size() && !stands_alone(k, after_statement(k, tokens_.size()));
  }

 private:
  static constexpr std::array<std::string_view, 3> opening{"(", "[", "{"}, closing{")", "]", "}"};

  std::string_view at(std::size_t k) const { return k < tokens_.size() ? tokens_[k].text : std::string_view(); }
  std::size_t end_of(std::size_t k) const { return tokens_[k].at + tokens_[k].text.size(); }
  Region inside(std::size_t brace) const { return {end_of(brace), tokens_[partner_[brace]].at}; }

  /// Whether a brace opens the body of a function, a lambda or a control statement.
  bool is_body(std::size_t brace) const {
    static constexpr std::array<std::string_view, 7> before_body{"const", "noexcept", "override", "mutable",
                                                                 "else",  "do",       "try"};
    static constexpr std::array<std::string_view, 6> of_types{"::", "<", ">", "&", "*", ","};
    if (brace == 0) return false;
    std::size_t k = brace - 1;
    if (at(k) == ")" || is_one_of(at(k), before_body)) return true;
    if (at(k) == "]") return partner_[k] != none && opens_lambda(partner_[k]);
    while (k > 0 && (tokens_[k].kind == Token::Kind::word || is_one_of(at(k), of_types))) --k;
    return at(k) == "->" && k > 0 && at(k - 1) == ")";
  }

  bool opens_lambda(std::size_t bracket) const {
    return bracket > 0 && tokens_[bracket - 1].kind == Token::Kind::sign && at(bracket - 1) != "]" &&
           at(bracket - 1) != ")";
  }

  /// Whether a body is a constexpr function's.
  bool is_constant(std::size_t brace) const {
    std::size_t k = brace;
    while (k > 0 && !is_one_of(at(k - 1), std::array<std::string_view, 3>{";", "{", "}"})) {
      --k;
      if (is_one_of(at(k), closing) && partner_[k] != none) k = partner_[k];
    }
    for (; k < brace; ++k)
      if ((at(k) == "constexpr" || at(k) == "consteval") && (k == 0 || at(k - 1) != "if")) return true;
    return false;
  }

  /// In a block, the statement that holds the edit, or from there the rest of the block.
  std::optional<Region> statement_in(std::size_t brace, const Region& edit, bool declares) const {
    const std::size_t close = partner_[brace];
    for (std::size_t k = brace + 1; k < close;) {
      const std::size_t end = after_statement(k, close);
      const Region statement{std::min(tokens_[k].at, edit.begin), end_of(end - 1)};
      if (statement.end > edit.begin) {
        if (statement.holds(edit) && !declares && stands_alone(k, end)) return statement;
        const Region rest{statement.begin, end_of(close - 1)};
        return has_labels(k, close) || !rest.holds(edit) ? std::nullopt : std::optional(rest);
      }
      k = end;
    }
    return std::nullopt;
  }

  bool has_labels(std::size_t begin, std::size_t end) const {
    for (std::size_t k = begin; k < end; ++k) {
      if (at(k) == "case" || at(k) == "default") return true;
      if (is_one_of(at(k), opening) && partner_[k] != none) k = partner_[k];
    }
    return false;
  }

  /// Whether a statement surely declares nothing that what follows it could see. Where this is not sure it counts as a
  /// declaration.
  bool stands_alone(std::size_t begin, std::size_t end) const {
    static constexpr std::array<std::string_view, 11> words{"if",     "for",   "while",    "do",    "switch", "try",
                                                            "return", "break", "continue", "throw", "{"};
    return is_one_of(at(begin), words) || is_assignment_or_call(begin, end);
  }

  /// Whether it is a chain of names, calls and indices, and then an assignment or the end.
  bool is_assignment_or_call(std::size_t begin, std::size_t end) const {
    static constexpr std::array<std::string_view, 9> assignments{"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^="};
    static constexpr std::array<std::string_view, 6> between_names{".", "->", "::", ",", "++", "--"};
    if (at(begin) == "auto") return false;
    std::size_t k = begin;
    while (at(k) == "*" || at(k) == "++" || at(k) == "--") ++k;
    bool wants_name = true;
    for (; k < end; ++k) {
      if (is_one_of(at(k), assignments)) return true;
      if (at(k) == ";") return k > begin && (at(k - 1) == ")" || at(k - 1) == "++" || at(k - 1) == "--");
      const bool is_name = tokens_[k].kind == Token::Kind::word;
      if (is_one_of(at(k), between_names)) {
        wants_name = true;
      } else if ((at(k) == "(" || at(k) == "[") && partner_[k] != none) {
        k = partner_[k];
        wants_name = false;
      } else if (is_name && wants_name) {
        wants_name = false;
      } else {
        return false;
      }
    }
    return false;
  }

  /// The token behind the statement that begins at k, in a block that ends at `close`.
  std::size_t after_statement(std::size_t k, std::size_t close) const {
    if (k >= close) return close;
    if (at(k) == "{") return std::min(past(k), close);
    if (at(k) == "if") {
      const std::size_t end = after_statement(past_head(k), close);
      return at(end) == "else" ? after_statement(end + 1, close) : end;
    }
    if (at(k) == "for" || at(k) == "while" || at(k) == "switch") return after_statement(past_head(k), close);
    if (at(k) == "case" || at(k) == "default") {
      while (k < close && at(k) != ":") ++k;
      return std::min(k + 1, close);
    }
    if (at(k) == "try") {
      std::size_t end = past(k + 1);
      while (at(end) == "catch") end = past(past_head(end));
      return std::min(end, close);
    }
    while (k < close && at(k) != ";") k = is_one_of(at(k), opening) ? past(k) : k + 1;
    return std::min(k + 1, close);
  }

  std::size_t past(std::size_t bracket) const {
    return bracket < tokens_.size() && partner_[bracket] != none ? partner_[bracket] + 1 : bracket + 1;
  }
  /// The token behind the next parentheses.
  std::size_t past_head(std::size_t k) const {
    while (k < tokens_.size() && at(k) != "(") ++k;
    return past(k);
  }

  std::vector<Token> tokens_;
  std::vector<std::size_t> partner_;  ///< of each bracket
};

struct PlacedChoice {
  const Choice* choice;
  Region region;
};

/// Writes a text with its choices.
class Writer {
 public:
  /// Includes the header by its path relative to the file, because the test of the layers takes paths from the top of
  /// the tree for includes of rooms.
  Writer(const std::string& text, const std::string& file) : text_(text) {
    std::string up;
    for (const char c : file)
      if (c == '/') up += "../";
    result_.text = fmt::format("#include \"{}{}\"\n", up, choice_header);
  }

  /// Choices in the order of their regions' begins, larger ones first.
  void write(const Region& part, const std::vector<PlacedChoice>& choices) {
    std::size_t at = part.begin;
    for (auto c = choices.begin(); c != choices.end();) {
      const PlacedChoice& first = *c;
      if (first.region.begin < at) {  // overlaps what has been written: left out
        ++c;
        continue;
      }
      std::vector<PlacedChoice> within;
      for (++c; c != choices.end() && first.region.holds(c->region); ++c) within.push_back(*c);
      copy({at, first.region.begin});
      write_both(first, within);
      at = first.region.end;
    }
    copy({at, part.end});
  }

  Schemata result() && { return std::move(result_); }

 private:
  void copy(const Region& part) { result_.text += text_.substr(part.begin, part.end - part.begin); }

  void write_both(const PlacedChoice& placed, const std::vector<PlacedChoice>& within) {
    const Edit& edit = placed.choice->edit;
    result_.text += fmt::format("if (mpmvv::chosen_mutant == {}) {{\n", placed.choice->number);
    const int first_line = line_of(result_.text, result_.text.size());
    copy({placed.region.begin, edit.at});
    result_.text += edit.after;
    copy({edit.at + edit.before.size(), placed.region.end});
    const std::size_t place = result_.places.size();
    result_.places.push_back({placed.choice->number, first_line, line_of(result_.text, result_.text.size()), 0});
    result_.text += "\n} else {\n";
    write(placed.region, within);
    result_.text += "\n}";
    result_.places[place].last_line_of_both = line_of(result_.text, result_.text.size());
  }

  const std::string& text_;
  Schemata result_;
};

}  // namespace

const char* const choice_header = "chosen_mutant.hpp";
const char* const choice_variable = "MPMVV_CHOSEN_MUTANT";

std::string choice_header_text() {
  return fmt::format(
      "#pragma once\n#include <cstdlib>\nnamespace mpmvv {{\n"
      "inline const int chosen_mutant = std::getenv(\"{0}\") ? std::atoi(std::getenv(\"{0}\")) : 0;\n}}\n",
      choice_variable);
}

Schemata schemata_of(const std::string& text, const std::vector<Choice>& choices) {
  const Statements statements(text);
  std::vector<PlacedChoice> placed;
  for (const Choice& choice : choices) {
    const Region edit{choice.edit.at, choice.edit.at + choice.edit.before.size()};
    auto region = statements.around(edit, false);
    if (region && Statements(edited(choice.edit, text)).declares(region->begin)) region = statements.around(edit, true);
    if (region) placed.push_back({&choice, *region});
  }
  std::ranges::stable_sort(placed, [](const PlacedChoice& a, const PlacedChoice& b) {
    return a.region.begin != b.region.begin ? a.region.begin < b.region.begin : a.region.end > b.region.end;
  });
  Writer writer(text, choices.empty() ? "" : choices.front().edit.file);
  writer.write({0, text.size()}, placed);
  return std::move(writer).result();
}

}  // namespace mpmvv::mutation
