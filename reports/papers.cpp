#include "reports/papers.hpp"

#include <fmt/format.h>

#include <cctype>

#include "page_template.hpp"
#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::reports {

namespace {

PaperFigure figure_from(const support::TomlTable& table) {
  table.allow_only({"number", "panels", "differs", "without", "wide", "to_scale", "upwards", "group"});
  PaperFigure figure{table.text("number"),      table.texts("panels"),     table.text("differs", ""),
                     table.text("without", ""), table.flag("wide", false), table.flag("to_scale", false)};
  if (const auto axis = table.table("upwards")) {
    axis->allow_only({"quantity", "label", "factor"});
    figure.upwards = {axis->text("quantity"), axis->text("label"), axis->number("factor")};
  }
  for (const auto& group : table.tables("group")) {
    group.allow_only({"series"});
    figure.groups.push_back(group.texts("series"));
  }
  if (figure.panels.empty() == figure.without.empty())
    throw support::UsageError(
        fmt::format("figure {} in {} (either panels, or why it is without)", figure.number, table.where()));
  return figure;
}

Paper paper_from(const support::TomlTable& table) {
  table.allow_only({"key", "source", "series", "figure"});
  Paper paper{table.text("key"), table.text("source"), {}, table.texts("series")};
  for (const auto& figure : table.tables("figure")) paper.figures.push_back(figure_from(figure));
  return paper;
}

}  // namespace

bool Paper::has(const std::string& study) const {
  const char letter = static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])));
  return study.starts_with(std::string{letter, '-'});
}

std::vector<Paper> read_papers(const std::string& text, const std::string& name) {
  std::vector<Paper> all;
  for (const auto& table : support::TomlTable::parse(text, name).tables("paper")) all.push_back(paper_from(table));
  return all;
}

const std::vector<Paper>& papers() {
  static const auto all = read_papers(std::string(papers_text), "reports/papers.toml");
  return all;
}

}  // namespace mpmvv::reports
