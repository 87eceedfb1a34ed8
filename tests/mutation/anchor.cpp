#include "tests/mutation/anchor.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "tests/mutation/code_tokens.hpp"

namespace mpmvv::mutation {

namespace {

/// Finds definitions by their brackets.
class Definitions {
 public:
  explicit Definitions(const std::string& text) : tokens_(tokens_of(text)), partner_(bracket_partners(tokens_)) {}

  std::vector<Region> of(const std::string& name) const {
    std::vector<Region> found;
    for (std::size_t k = 0; k < tokens_.size(); ++k) {
      if (at(k) != name) continue;
      const std::size_t brace = body_of(k);
      if (brace != no_partner && partner_[brace] != no_partner)
        found.push_back({tokens_[k].at, tokens_[partner_[brace]].at + 1});
    }
    return found;
  }

 private:
  std::string_view at(std::size_t k) const { return k < tokens_.size() ? tokens_[k].text : std::string_view(); }
  std::size_t past(std::size_t bracket) const {
    return partner_[bracket] == no_partner ? tokens_.size() : partner_[bracket] + 1;
  }

  /// The brace that opens the body of what is defined under the name at this token.
  std::size_t body_of(std::size_t name) const {
    static constexpr std::array<std::string_view, 5> keys{"struct", "class", "union", "enum", "namespace"};
    const std::size_t next = name + 1;
    if (name > 0 && std::ranges::find(keys, at(name - 1)) != keys.end()) return brace_of_class(next);
    if (at(next) == "(") return brace_of_function(past(next));
    if (at(next) == "=" && at(next + 1) == "[") {
      const std::size_t behind = past(next + 1);
      return brace_of_function(at(behind) == "(" ? past(behind) : behind);
    }
    return no_partner;
  }

  /// The brace behind a class's bases; none for a declaration, a variable or a template's parameter.
  std::size_t brace_of_class(std::size_t k) const {
    bool has_bases = false;
    for (int depth = 0; k < tokens_.size(); ++k) {
      if (at(k) == "{") return k;
      has_bases = has_bases || at(k) == ":";
      if (at(k) == "<") ++depth;
      if (at(k) == ">" && --depth < 0) return no_partner;
      if (at(k) == ";" || at(k) == "=" || at(k) == "(" || at(k) == ")" || (at(k) == "," && depth == 0 && !has_bases))
        return no_partner;
    }
    return no_partner;
  }

  /// The brace behind a function's qualifiers, return type and, of a constructor, initialisers; none for a call.
  std::size_t brace_of_function(std::size_t k) const {
    static constexpr std::array<std::string_view, 6> ends{";", "}", ")", "]", "=", "?"};
    for (bool initialises = false; k < tokens_.size();) {
      if (at(k) == "{") {
        const bool is_initialiser = initialises && (tokens_[k - 1].kind == Token::Kind::word || at(k - 1) == ">");
        if (!is_initialiser) return k;
      }
      if (std::ranges::find(ends, at(k)) != ends.end() || (at(k) == "," && !initialises)) return no_partner;
      if (at(k) == ":") initialises = true;
      k = at(k) == "(" || at(k) == "[" || at(k) == "{" ? past(k) : k + 1;
    }
    return no_partner;
  }

  std::vector<Token> tokens_;
  std::vector<std::size_t> partner_;
};

/// A part of code that white space cannot divide.
struct Part {
  std::string_view text;
  std::size_t at;

  bool operator==(const Part& other) const { return text == other.text; }
};

/// The tokens of a text, with `>=`, `>>` and the like cut in two: whether they are one token or two depends on the
/// white space around them.
std::vector<Part> parts_of(const std::string& text) {
  std::vector<Part> parts;
  for (const Token& token : tokens_of(text, Literals::kept)) {
    std::string_view rest = token.text;
    while (rest.size() > 1 && rest.front() == '>') {
      parts.push_back({rest.substr(0, 1), token.at + (token.text.size() - rest.size())});
      rest.remove_prefix(1);
    }
    parts.push_back({rest, token.at + (token.text.size() - rest.size())});
  }
  return parts;
}

}  // namespace

bool names(const std::string& name, const std::string& path) {
  return path == name || path.ends_with("/" + name);
}

std::vector<std::string> sources_named(const std::string& name, const std::vector<std::string>& files) {
  std::vector<std::string> named;
  std::ranges::copy_if(files, std::back_inserter(named), [&](const std::string& path) {
    const bool is_source = (path.ends_with(".hpp") || path.ends_with(".cpp")) && !path.starts_with("tests/");
    return is_source && names(name, path);
  });
  return named;
}

std::vector<Region> definitions_of(const std::string& name, const std::string& text) {
  return Definitions(text).of(name);
}

bool is_same_code(const std::string& one, const std::string& other) {
  return parts_of(one) == parts_of(other);
}

std::vector<Region> occurrences_of(const std::string& code, const std::string& text) {
  const std::vector<Part> wanted = parts_of(code), all = parts_of(text);
  std::vector<Region> found;
  if (wanted.empty()) return found;
  for (auto from = all.begin();; ++from) {
    from = std::search(from, all.end(), wanted.begin(), wanted.end());
    if (from == all.end()) return found;
    const Part& last = *(from + (std::ssize(wanted) - 1));
    found.push_back({from->at, last.at + last.text.size()});
  }
}

/// The edit distance of tokens, with a free choice of where in the text to begin and to end (P. H. Sellers, J.
/// Algorithms 1 (1980) 359).
Likeness most_like(const std::string& code, const std::string& text) {
  struct Path {
    std::size_t cost = 0, begin = 0;
  };
  const std::vector<Part> wanted = parts_of(code), all = parts_of(text);
  // By the number of the code's first tokens: the cheapest way to have these end at the present token of the text.
  std::vector<Path> column;
  for (std::size_t k = 0; k <= wanted.size(); ++k) column.push_back({k, 0});
  Likeness best{{}, wanted.size(), wanted.size()};
  for (std::size_t j = 0; j < all.size(); ++j) {
    Path diagonal = std::exchange(column[0], {0, j + 1});
    for (std::size_t k = 1; k < column.size(); ++k) {
      Path path{diagonal.cost + (wanted[k - 1] == all[j] ? 0 : 1), diagonal.begin};
      for (const Path& other : {column[k], column[k - 1]})
        if (other.cost + 1 < path.cost) path = {other.cost + 1, other.begin};
      diagonal = std::exchange(column[k], path);
    }
    if (const Path& whole = column.back(); whole.cost < best.differing && whole.begin <= j)
      best = {{all[whole.begin].at, all[j].at + all[j].text.size()}, whole.cost, wanted.size()};
  }
  return best;
}

}  // namespace mpmvv::mutation
