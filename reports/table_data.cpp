#include "reports/table_data.hpp"

#include <fmt/format.h>

#include "reports/text.hpp"

namespace mpmvv::reports {

namespace {

using namespace template_data;

/// What all cells of a column are.
struct ColumnKind {
  bool number = true, word = true;
};

ColumnKind kind_of_column(const Table& table, std::size_t column) {
  constexpr std::size_t longest_word = 18;
  ColumnKind kind;
  for (const auto& group : table.groups)
    for (const auto& row : group.rows) {
      kind.number = kind.number && is_number(row[column]);
      kind.word = kind.word && row[column].size() <= longest_word;
    }
  return kind;
}

/// The class of a column in style.css: a number, a word that stays in its line, a text.
std::string css_class(const ColumnKind& kind) {
  return kind.number ? "n" : kind.word ? "w" : "t";
}

}  // namespace

data table_data(const Table& table) {
  std::vector<ColumnKind> kinds;
  for (std::size_t c = 0; c < table.columns.size(); ++c) kinds.push_back(kind_of_column(table, c));
  constexpr std::string_view https = "https://";
  const auto cell = [&](const std::vector<std::string>& texts, std::size_t c) {
    const bool is_address = texts[c].starts_with(https);
    return object({{"text", is_address ? texts[c].substr(https.size()) : texts[c]},
                   {"address", texts[c]},
                   {"is_address", is_address},
                   {"number", kinds[c].number},
                   {"kind", css_class(kinds[c])}});
  };
  const auto cells = [&](const std::vector<std::string>& texts, std::size_t from) {
    data list{data::type::list};
    for (std::size_t c = from; c < texts.size(); ++c) list << cell(texts, c);
    return list;
  };
  const auto row = [&](const std::vector<std::string>& texts) {
    return object({{"row_head", cell(texts, 0)}, {"cells", cells(texts, 1)}});
  };
  const auto group = [&](const Table::Group& g) {
    return object({{"group_title", g.title}, {"titled", !g.title.empty()}, {"rows", list_of(g.rows, row)}});
  };
  return object({{"table_caption", table.caption},
                 {"columns", cells(table.columns, 0)},
                 {"width", fmt::format("{}", table.columns.size())},
                 {"groups", list_of(table.groups, group)},
                 {"note", table.note},
                 {"has_note", !table.note.empty()}});
}

}  // namespace mpmvv::reports
