#include "cli/markdown.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "cli/console.hpp"
#include "cli/lines.hpp"
#include "cli/table.hpp"

namespace mpmvv::cli {

namespace {

/// The text without the marks of links, code and bold type. Code among other words gets quotes.
std::string plain(const std::string& text) {
  static const std::regex link(R"(\[([^\]]*)\]\([^)]*\))"), weight(R"(\*\*)"), codes(R"((`[^`]*`(, )?)*)"), code("`");
  const std::string bare = std::regex_replace(std::regex_replace(text, link, "$1"), weight, "");
  return std::regex_replace(bare, code, std::regex_match(bare, codes) ? "" : "'");
}

std::vector<std::string> two_or_more(std::vector<std::string> cells) {
  cells.resize(std::max<std::size_t>(cells.size(), 2));
  return cells;
}

/// A table by the keys of its first column: beside each its meaning, and in brackets what the other columns say.
class Keys {
 public:
  explicit Keys(std::vector<std::string> heads)
      : heads_(two_or_more(std::move(heads))),
        main_(heads_.back() == "meaning" ? heads_.size() - 1 : 1),
        table_({{heads_[0]}, {heads_[main_], Table::Kind::prose}}, 0) {}

  void add(std::vector<std::string> cells) {
    cells.resize(heads_.size());
    std::vector<std::string> others;
    for (std::size_t k = 1; k < cells.size(); ++k)
      if (k != main_ && !cells[k].empty()) others.push_back(cells[k] == needed ? needed : heads_[k] + " " + cells[k]);
    table_.add(
        {cells[0], others.empty() ? cells[main_] : fmt::format("{} ({})", cells[main_], fmt::join(others, "; "))});
  }

  void print() const { table_.print(); }

 private:
  static constexpr const char* needed = "required";  ///< says enough without the head of its column

  std::vector<std::string> heads_;
  std::size_t main_;
  Table table_;
};

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  for (std::size_t begin = 1; begin < row.size();) {
    const std::size_t end = std::min(row.find(" |", begin), row.size());
    const std::size_t text = std::min(row.find_first_not_of(' ', begin), end);
    cells.push_back(plain(row.substr(text, end - text)));
    begin = end + 2;
  }
  return cells;
}

}  // namespace

void print_markdown(const std::string& text) {
  if (!output_columns()) return print_text(text);
  std::istringstream in(text);
  std::optional<Keys> keys;
  std::string paragraph;
  const auto end_part = [&] {
    if (keys) keys->print();
    if (!paragraph.empty()) print_indented(plain(paragraph), 0);
    keys.reset(), paragraph.clear();
  };
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("|---")) continue;
    if (line.starts_with('|') && keys)
      keys->add(cells_of(line));
    else if (line.starts_with('|'))
      keys.emplace(cells_of(line));
    else if (line.empty() || line.starts_with('#'))
      end_part(), print("{}\n", plain(line.substr(std::min(line.find_first_not_of("# "), line.size()))));
    else
      paragraph += (paragraph.empty() ? "" : " ") + line;
  }
  end_part();
}

}  // namespace mpmvv::cli
