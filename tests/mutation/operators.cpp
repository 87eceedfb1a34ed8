#include "tests/mutation/operators.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string_view>
#include <utility>

#include "tests/mutation/code_tokens.hpp"

namespace mpmvv::mutation {

namespace {

/// The folders that decide a result of our own solver, and the fits to results.
constexpr std::array computing{"mms/",          "solver/",           "studies/cases/", "studies/checks/",
                               "studies/fits/", "studies/problems/", "studies/runs/",  "studies/settings/"};

/// Collects the mutations of one text.
class MutationFinder {
 public:
  MutationFinder(std::string file, const std::string& text) : file_(std::move(file)), tokens_(tokens_of(text)) {}

  std::vector<Edit> all() {
    for (k_ = 0; k_ < tokens_.size(); ++k_) {
      if (here().in_brackets || in_assertion()) continue;
      if (here().kind == Token::Kind::sign) change_sign();
      if (here().kind == Token::Kind::number) change_number();
      if (here().kind == Token::Kind::word) change_word();
    }
    return std::move(edits_);
  }

 private:
  const Token& here() const { return tokens_[k_]; }

  /// The text of the token so many places on; empty beyond the ends.
  std::string_view near(std::ptrdiff_t places) const {
    const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(k_) + places;
    return 0 <= k && k < std::ssize(tokens_) ? tokens_[static_cast<std::size_t>(k)].text : "";
  }

  void add(const Token& token, std::string after) {
    edits_.push_back({file_, token.at, std::string(token.text), std::move(after)});
  }

  /// Within a static_assert, up to its end.
  bool in_assertion() {
    if (here().text == "static_assert") asserting_ = true;
    if (here().text == ";") asserting_ = false;
    return asserting_;
  }

  bool follows_operand() const {
    static const std::set<std::string_view> no_operands{"return", "case", "else", "operator"};
    if (k_ == 0) return false;
    const Token& before = tokens_[k_ - 1];
    if (before.kind == Token::Kind::sign) return before.text == ")" || before.text == "]";
    return !no_operands.contains(before.text);
  }

  void change_sign() {
    static const std::multimap<std::string_view, const char*> binary{{"+", "-"},  {"-", "+"}, {"*", "/"},  {"/", "*"},
                                                                     {"<", "<="}, {"<", ">"}, {">", ">="}, {">", "<"}};
    static const std::map<std::string_view, const char*> always{{"+=", "-="}, {"-=", "+="}, {"*=", "/="}, {"/=", "*="},
                                                                {"<=", "<"},  {">=", ">"},  {"==", "!="}, {"!=", "=="}};
    const std::string_view sign = here().text;
    if (here().is_spaced && follows_operand()) {
      const auto [first, last] = binary.equal_range(sign);
      for (auto it = first; it != last; ++it) add(here(), it->second);
    }
    if (sign == "-" && !here().is_spaced && !follows_operand()) add(here(), "");
    if (const auto it = always.find(sign); it != always.end()) add(here(), it->second);
  }

  void change_number() {
    static const std::map<std::string, const char*> known{{"0", "1"},     {"1", "0"},     {"2", "3"},   {"3", "2"},
                                                          {"0.0", "1.0"}, {"1.0", "0.0"}, {"0.5", "1"}, {"1.", "2."}};
    const bool is_pure_virtual = near(-1) == "=" && (near(-2) == ")" || near(-2) == "const");
    if (is_pure_virtual || near(-1) == "case") return;
    const std::string number(here().text);
    if (const auto it = known.find(number); it != known.end())
      add(here(), it->second);
    else if (number.find_first_not_of("0123456789.e-") == std::string::npos)
      add(here(), "(2 * " + number + ")");
  }

  void change_word() {
    const std::string_view word = here().text;
    if (word == "true") add(here(), "false");
    if (word == "false") add(here(), "true");
    if (near(-1) == "[" && near(1) == "]") change_index();
    if (near(-1) == "(" && near(1) == "," && near(3) == ")") exchange_indices();
  }

  void change_index() {
    static const std::map<std::string_view, const char*> partners{{"i", "j"}, {"j", "i"}};
    if (here().text == "d") add(here(), "0");
    if (const auto it = partners.find(here().text); it != partners.end() && is_in_reach(it->second))
      add(here(), it->second);
  }

  /// (c, d) becomes (d, c) where both are indices.
  void exchange_indices() {
    static const std::set<std::string_view> indices{"c", "d", "e", "i", "j", "k", "J", "L"};
    if (!indices.contains(here().text) || !indices.contains(near(2))) return;
    add(here(), std::string(near(2)));
    Edit& edit = edits_.back();
    const Token& other = tokens_[k_ + 2];
    edit.before += ", " + std::string(other.text);
    edit.after += ", " + std::string(here().text);
    // Left out where a line ends between them: they are not divided by ", " then.
    if (other.at + other.text.size() != edit.at + edit.before.size()) edits_.pop_back();
  }

  /// Whether a name occurs a few lines above.
  bool is_in_reach(std::string_view name) const {
    const std::size_t reach = std::min<std::size_t>(k_, 60);
    const auto end = tokens_.begin() + static_cast<std::ptrdiff_t>(k_);
    return std::any_of(end - static_cast<std::ptrdiff_t>(reach), end, [&](const Token& t) { return t.text == name; });
  }

  std::string file_;
  std::vector<Token> tokens_;
  std::size_t k_ = 0;
  bool asserting_ = false;
  std::vector<Edit> edits_;
};

}  // namespace

std::vector<Edit> mutations_of(const std::string& file, const std::string& text) {
  return MutationFinder(file, text).all();
}

std::vector<Edit> shuffled(std::vector<Edit> edits, std::uint64_t seed) {
  std::mt19937_64 draw(seed);  // the standard fixes its numbers, but not those of distributions or of std::shuffle
  for (std::size_t left = edits.size(); left > 1; --left) std::swap(edits[left - 1], edits[draw() % left]);
  return edits;
}

std::vector<std::string> mutated_files(const std::vector<std::string>& files) {
  std::vector<std::string> chosen;
  std::ranges::copy_if(files, std::back_inserter(chosen), [](const std::string& file) {
    const bool is_code = file.ends_with(".hpp") || file.ends_with(".cpp");
    return is_code && std::ranges::any_of(computing, [&](const char* folder) { return file.starts_with(folder); });
  });
  std::ranges::sort(chosen);
  return chosen;
}

}  // namespace mpmvv::mutation
