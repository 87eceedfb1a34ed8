#include "reports/latex_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <utility>

#include "reports/norm_symbol.hpp"
#include "reports/text.hpp"
#include "reports/typeset.hpp"

namespace mpmvv::reports {

namespace {

constexpr const char* dash = "–";

/// A number as it stands within mathematics: "1.23 \times 10^{-4}" of "1.23e-04".
std::string in_mathematics_mode(const std::string& number) {
  const auto e = number.find('e');
  if (e == std::string::npos) return replace_all(number, "inf", "\\infty");
  std::string digits = number.substr(0, e);
  const int power = std::atoi(number.c_str() + e + 1);
  if (power == 0) return digits;
  return fmt::format("{}10^{{{}}}", digits == "1" ? "" : digits + " \\times ", power);
}

bool is_written_number(const std::string& text) {
  return text != dash && is_number(text);
}

std::size_t index_of(const std::vector<std::string>& columns, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(columns, name) - columns.begin());
}

/// Calls look(cell) with each cell of a column.
template <class Look>
void for_each_cell(const Table& table, std::size_t column, const Look& look) {
  for (const auto& group : table.groups)
    for (const auto& row : group.rows) look(row[column]);
}

/// The table without the columns in which nothing stands.
Table without_empty_columns(Table table) {
  for (std::size_t c = table.columns.size(); c-- > 0;) {
    bool is_empty = true;
    for_each_cell(table, c, [&](const std::string& cell) { is_empty = is_empty && (cell == dash || cell.empty()); });
    if (!is_empty) continue;
    const auto at = static_cast<std::ptrdiff_t>(c);
    table.columns.erase(table.columns.begin() + at);
    for (auto& group : table.groups)
      for (auto& row : group.rows) row.erase(row.begin() + at);
  }
  return table;
}

/// The cells of a row; of the column `norm` the symbol.
std::vector<std::string> set_cells(const std::vector<std::string>& row, std::size_t norm_column) {
  std::vector<std::string> set;
  for (std::size_t c = 0; c < row.size(); ++c)
    set.push_back(c == norm_column ? norm_symbol(row[c]).symbol : latex_cell(row[c]));
  return set;
}

/// "Here $\ell_2 = ...$"; empty for a table without norms.
std::string definitions_in(const Table& table, std::size_t norm_column) {
  std::vector<std::string> norms, definitions;
  if (norm_column == table.columns.size()) return "";
  for_each_cell(table, norm_column, [&](const std::string& norm) {
    if (std::ranges::find(norms, norm) != norms.end()) return;
    norms.push_back(norm);
    definitions.push_back(norm_symbol(norm).definition);
  });
  return fmt::format("\\noindent {}.\\par\\medskip\n", fmt::join(definitions, "; "));
}

std::size_t longest_in(const Table& table, std::size_t column) {
  std::size_t longest = table.columns[column].size();
  for_each_cell(table, column, [&](const std::string& cell) { longest = std::max(longest, cell.size()); });
  return longest;
}

/// About how wide a text is in points, in letters of 8 points.
double width_in_points(const std::string& text) {
  constexpr double letter = 4.4, capital = 6, power = 47;
  if (is_written_number(text) && text.find('e') != std::string::npos) return power;
  double width = 0;
  for (const unsigned char byte : text)
    if ((byte & 0xC0u) != 0x80) width += std::isupper(byte) != 0 ? capital : letter;  // a byte that starts a character
  return width;
}

double width_in_points(const Table& table, std::size_t column) {
  double width = width_in_points(table.columns[column]);
  for_each_cell(table, column, [&](const std::string& cell) { width = std::max(width, width_in_points(cell)); });
  return width;
}

/// The width of a column whose texts are broken: that of its longest word.
double longest_word_in_points(const Table& table, std::size_t column) {
  double width = 0;
  const auto consider = [&](const std::string& text) {
    std::istringstream words(text);
    for (std::string word; words >> word;) width = std::max(width, width_in_points(word));
  };
  consider(table.columns[column]);
  for_each_cell(table, column, consider);
  return width;
}

/// The width that the table takes at least; columns that are broken share the rest of the line equally.
double least_width(const Table& table, const std::vector<bool>& is_broken) {
  constexpr double gap = 6;
  double others = 0, widest_word = 0;
  for (std::size_t c = 0; c < is_broken.size(); ++c) {
    others += gap + (is_broken[c] ? 0 : width_in_points(table, c));
    if (is_broken[c]) widest_word = std::max(widest_word, longest_word_in_points(table, c));
  }
  return others + static_cast<double>(std::ranges::count(is_broken, true)) * widest_word;
}

/// The columns whose texts are broken: prose, and as many more as it takes, those that become the narrowest by it
/// first.
std::vector<bool> broken_columns(const Table& table) {
  constexpr std::size_t prose = 20;
  constexpr double text_width = 355;
  std::vector<bool> is_broken;
  std::vector<std::pair<double, std::size_t>> gains;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    is_broken.push_back(longest_in(table, c) > prose);
    gains.emplace_back(width_in_points(table, c) - longest_word_in_points(table, c), c);
  }
  std::ranges::stable_sort(gains, std::greater{}, &std::pair<double, std::size_t>::first);
  for (const auto& [gain, c] : gains) {
    const double width = least_width(table, is_broken);
    std::vector<bool> with_one_more = is_broken;
    with_one_more[c] = true;
    if (width > text_width && least_width(table, with_one_more) < width) is_broken = with_one_more;
  }
  return is_broken;
}

/// Other columns are as wide as their texts, those that are broken share the rest of the line.
std::string column_types(const Table& table) {
  std::string types;
  for (const bool is_broken : broken_columns(table)) types += is_broken ? ">{\\raggedright\\arraybackslash}X" : "l";
  return types;
}

/// A title over all columns; a long one takes several lines.
std::string group_line(const Table& table, const std::string& title) {
  constexpr std::size_t one_line = 60;
  return fmt::format("\\multicolumn{{{}}}{{{}}}{{\\emph{{{}}}}} \\\\", table.columns.size(),
                     title.size() > one_line ? "p{0.95\\linewidth}" : "l", latex_text(title));
}

/// The width of a long table's first column: that of its texts, or what the other columns leave of the line.
std::string first_width(const Table& table, std::size_t norm_column) {
  constexpr double gap = 6, symbol = 35, least = 40;
  double others = gap;
  for (std::size_t c = 1; c < table.columns.size(); ++c)
    others += gap + (c == norm_column ? symbol : width_in_points(table, c));
  return fmt::format(
      "\\dimexpr\\ifdim\\dimexpr\\linewidth-{0:.0f}pt<{2}pt {2}pt\\else\\ifdim\\dimexpr\\linewidth-{0:.0f}pt<{1:.0f}pt"
      "\\linewidth-{0:.0f}pt\\else{1:.0f}pt\\fi\\fi\\relax",
      others, width_in_points(table, 0), least);
}

/// The table in pieces that a page has room for; the note stands below the last one.
std::vector<Table> pieces_of(const Table& table) {
  constexpr std::size_t most_rows = 15;
  std::vector<Table> pieces;
  std::size_t rows = most_rows;
  for (const auto& group : table.groups)
    for (std::size_t r = 0; r < group.rows.size(); ++r, ++rows) {
      if (rows >= most_rows) pieces.push_back({table.caption, table.columns, {}}), rows = 0;
      if (r == 0 || rows == 0) pieces.back().groups.push_back({group.title, {}});
      pieces.back().groups.back().rows.push_back(group.rows[r]);
    }
  if (!pieces.empty()) pieces.back().note = table.note;
  return pieces;
}

std::string latex_table(const Table& table) {
  const std::string types = column_types(table);
  const bool has_prose = types.find('X') != std::string::npos;
  const std::string name = has_prose ? "tabularx" : "tabular", width = has_prose ? "{\\linewidth}" : "";
  std::string text = fmt::format(
      "\n% {}\n{{\\noindent\\footnotesize\\setlength{{\\tabcolsep}}{{3pt}}%\n\\begin{{{}}}{}{{{}}}\n\\toprule\n",
      latex_text(table.caption), name, width, types);
  std::vector<std::string> heads;
  for (const std::string& column : table.columns) heads.push_back(latex_text(column));
  text += latex_line(heads);
  for (const auto& group : table.groups) {
    text += "\\midrule\n";
    if (!group.title.empty()) text += group_line(table, group.title) + "\n";
    for (const auto& row : group.rows) text += latex_line(set_cells(row, row.size()));
  }
  const std::string note = table.note.empty() ? "" : "\\par " + latex_text(table.note) + "\n";
  return fmt::format("{}\\bottomrule\n\\end{{{}}}\n{}\\par}}\\medskip\n", text, name, note);
}

}  // namespace

std::string latex_cell(const std::string& text) {
  const std::string sign = " ± ";
  if (is_written_number(text)) return fmt::format("${}$", in_mathematics_mode(text));
  const auto at = text.find(sign);
  if (at == std::string::npos) return typeset(text, Notation::latex);
  const std::string number = text.substr(0, at), half_width = text.substr(at + sign.size());
  if (!is_written_number(number) || !is_written_number(half_width)) return typeset(text, Notation::latex);
  return fmt::format("${} \\pm {}$", in_mathematics_mode(number), in_mathematics_mode(half_width));
}

/// It begins with an empty group where LaTeX would take its first cell for an argument of the line before.
std::string latex_line(const std::vector<std::string>& cells) {
  const std::string line = fmt::format("{} \\\\\n", fmt::join(cells, " & "));
  return line.starts_with('[') || line.starts_with('*') ? "{}" + line : line;
}

std::string latex_long_table(const Table& whole) {
  if (whole.empty()) return "";
  const Table table = without_empty_columns(whole);
  const std::size_t norm_column = index_of(table.columns, "norm");
  std::vector<std::string> heads;
  for (const auto& column : table.columns) heads.push_back(typeset(column, Notation::latex));
  const std::string head = "\\toprule\n" + latex_line(heads) + "\\midrule\n";
  std::string text = fmt::format(
      "{{\\footnotesize\\setlength{{\\tabcolsep}}{{3pt}}\\setlength{{\\LTcapwidth}}"
      "{{\\linewidth}}\n\\begin{{longtable}}{{>{{\\raggedright}}p{{{}}}{}}}\n",
      first_width(table, norm_column), std::string(table.columns.size() - 1, 'l'));
  text += fmt::format("\\caption{{{}}} \\\\\n", typeset(table.caption, Notation::latex));
  text += head + "\\endfirsthead\n" + head + "\\endhead\n\\bottomrule\n\\endfoot\n";
  for (const auto& group : table.groups) {
    if (&group != &table.groups.front()) text += "\\addlinespace\n";
    text += group_line(table, group.title) + "*\n";
    for (const auto& row : group.rows) text += latex_line(set_cells(row, norm_column));
  }
  return text + "\\end{longtable}\n" + definitions_in(table, norm_column) + "\\par}\n";
}

std::string latex_tables(const std::vector<Table>& tables) {
  std::string text;
  for (const auto& table : tables)
    for (const auto& piece : pieces_of(table)) text += latex_table(piece);
  return text;
}

std::string latex_head(const std::string& title) {
  return fmt::format("% {}\n% needs \\usepackage{{amsmath,booktabs,longtable,tabularx}}\n", latex_text(title));
}

}  // namespace mpmvv::reports
