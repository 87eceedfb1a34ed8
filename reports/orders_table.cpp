#include "reports/orders_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/chart.hpp"
#include "reports/text.hpp"
#include "reports/typeset.hpp"

namespace mpmvv::reports {

namespace {

Table::Rows orders_of(const records::StudyResult& study) {
  Table::Rows rows;
  for (const auto& series : study.series)
    for (const auto& o : series.orders)
      rows.push_back({series.name, o.norm, fmt::format("{} to {}", brief(o.from), brief(o.to)),
                      fmt::format("{}", o.points), order_text(o),
                      o.floor && o.floor->accepted ? brief(o.floor->floor) : "–", fits::asymptotic_word(o)});
  return rows;
}

/// "s-fig10 (cells): Orders of the bases. Made with --set: ppc = 2 in 2 of 2 series."
std::string title_of(const records::StudyResult& study) {
  const std::string trial = trial_sentence(study);
  return fmt::format("{} ({}): {}{}", study.name, study.sweep, study.title, trial.empty() ? "" : ". " + trial);
}

/// A row in LaTeX. It begins with an empty group, so that LaTeX does not take the first cell for an argument of the
/// line before.
std::string row_text(const std::vector<std::string>& cells) {
  std::vector<std::string> set;
  for (const auto& cell : cells) set.push_back(typeset(cell, Notation::latex));
  return fmt::format("{{}}{} \\\\\n", fmt::join(set, " & "));
}

}  // namespace

Table orders_table(const std::vector<const records::StudyResult*>& studies) {
  Table table{"Fitted orders ± half of their intervals; the window is in the swept key",
              {"series", "norm", "window", "points", "order", "floor", "asymptotic"},
              {}};
  for (const auto* study : studies)
    if (auto rows = orders_of(*study); !rows.empty()) table.groups.push_back({title_of(*study), std::move(rows)});
  return table;
}

std::string latex_long_table(const Table& table) {
  if (table.empty()) return "";
  std::string text = "% needs \\usepackage{booktabs,longtable}\n";
  text += fmt::format("\\begin{{longtable}}{{{}}}\n", std::string(table.columns.size(), 'l'));
  text += fmt::format("\\caption{{{}}} \\\\\n", typeset(table.caption, Notation::latex));
  text += "\\toprule\n" + row_text(table.columns) + "\\midrule\n\\endfirsthead\n";
  text += "\\toprule\n" + row_text(table.columns) + "\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n";
  for (const auto& group : table.groups) {
    if (&group != &table.groups.front()) text += "\\addlinespace\n";
    text +=
        fmt::format("\\multicolumn{{{}}}{{l}}{{\\emph{{{}}}}} \\\\*\n", table.columns.size(), latex_text(group.title));
    for (const auto& row : group.rows) text += row_text(row);
  }
  return text + "\\end{longtable}\n";
}

}  // namespace mpmvv::reports
