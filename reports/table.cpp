#include "reports/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/chart.hpp"
#include "reports/text.hpp"
#include "studies/work_precision.hpp"

namespace mpmvv {

namespace {

constexpr std::size_t longest_series = 40;

/// What was measured anywhere in the study.
std::set<std::string> measured_quantities(const StudyResult& study) {
  std::set<std::string> names;
  for (const auto& series : study.series)
    for (const auto& point : series.points)
      for (const auto& [name, value] : point.y)
        if (!std::isnan(value)) names.insert(name);
  return names;
}

std::set<std::string> fitted_norms(const StudyResult& study) {
  std::set<std::string> norms;
  for (const auto& series : study.series)
    for (const auto& order : series.orders) norms.insert(order.norm);
  return norms;
}

/// Order of the segment that ends at x.
std::string segment_order(const Series& series, const std::string& norm, double x) {
  for (const auto& order : series.orders) {
    if (order.norm != norm) continue;
    const auto segment = std::ranges::find(order.segments, x, &SegmentOrder::to);
    if (segment != order.segments.end()) return order_text(segment->order, not_measured);
  }
  return "–";
}

std::string aligned(double v) {
  return std::isnan(v) ? "–" : fmt::format("{:.3e}", v);
}

std::string yes(bool b) {
  return b ? "yes" : "no";
}

std::string floor_text(const FloorFit& floor) {
  if (!floor.accepted) return "refused: " + floor.reason;
  return fmt::format("E0 = {}, order {}: {}", brief(floor.floor), order_text(floor.order, not_measured), floor.reason);
}

}  // namespace

Table points_table(const StudyResult& study) {
  const auto quantities = measured_quantities(study);
  const auto norms = fitted_norms(study);
  Table table{"Results at each point", {study.sweep, "status"}, {}};
  for (const auto& q : quantities) {
    table.columns.push_back(q);
    if (norms.contains(q)) table.columns.push_back("order");
  }
  for (const auto& series : study.series) {
    if (series.points.empty() || series.points.size() > longest_series) continue;
    Table::Group group{series.name, {}};
    for (const auto& point : series.points) {
      const std::string why = point.reason.empty() ? "" : ": " + point.reason;
      std::vector<std::string> row{brief(point.x), to_string(point.status) + why};
      for (const auto& q : quantities) {
        const auto y = point.y.find(q);
        row.push_back(y == point.y.end() ? "–" : aligned(y->second));
        if (norms.contains(q)) row.push_back(segment_order(series, q, point.x));
      }
      group.rows.push_back(std::move(row));
    }
    table.groups.push_back(std::move(group));
  }
  return table;
}

Table fits_table(const StudyResult& study) {
  Table table{"Fitted orders",
              {"norm", "window", "points", "order", "C", "R²", "asymptotic", "asymptotic range found", "floor"},
              {}};
  for (const auto& series : study.series) {
    Table::Group group{series.name, {}};
    for (const auto& o : series.orders) {
      const bool found = std::isfinite(o.asymptotic_from);
      group.rows.push_back({o.norm, fmt::format("{} to {}", brief(o.from), brief(o.to)), fmt::format("{}", o.points),
                            order_text(o.order, o.half_width), brief(o.constant), fmt::format("{:.5f}", o.r_squared),
                            yes(o.asymptotic),
                            found ? fmt::format("{} to {}", brief(o.asymptotic_from), brief(o.asymptotic_to)) : "none",
                            o.floor ? floor_text(*o.floor) : "–"});
    }
    if (!group.rows.empty()) table.groups.push_back(std::move(group));
  }
  return table;
}

/// The orders again, with what replicates say of them.
Table replicates_table(const StudyResult& study) {
  Table table{
      "Orders by replicates: their interval is that of the scatter alone; a small p of the lack of fit says that "
      "no one power law fits the means",
      {"norm", "window", "runs", "order", "scatter", "lack of fit p"},
      {}};
  for (const auto& series : study.series) {
    Table::Group group{series.name, {}};
    for (const auto& o : series.orders)
      if (o.replicates)
        group.rows.push_back({o.norm, fmt::format("{} to {}", brief(o.from), brief(o.to)),
                              fmt::format("{}", o.replicates->observations),
                              order_text(o.order, o.replicates->half_width), brief(o.replicates->scatter),
                              brief(o.replicates->lack_of_fit)});
    if (!group.rows.empty()) table.groups.push_back(std::move(group));
  }
  return table;
}

Table extrapolations_table(const StudyResult& study) {
  Table table{
      "Extrapolated to h = 0, with the uncertainty of the finest grid's value (Eça and Hoekstra) and its grid "
      "convergence index",
      {"quantity", "window", "grids", "model", "free order", "limit", "finest grid", "uncertainty", "GCI"},
      {}};
  for (const auto& series : study.series) {
    Table::Group group{series.name, {}};
    for (const auto& e : series.extrapolations)
      group.rows.push_back({e.norm, fmt::format("{} to {}", brief(e.from), brief(e.to)), fmt::format("{}", e.points),
                            e.model, order_text(e.order, not_measured), brief(e.limit), brief(e.finest),
                            brief(e.uncertainty), brief(e.convergence_index)});
    if (!group.rows.empty()) table.groups.push_back(std::move(group));
  }
  return table;
}

Table limits_table(const StudyResult& study) {
  Table table{"Stability limits", {"series", "key", "limit", "stable at", "unstable at", "monotone", "probes"}, {}};
  Table::Group group;
  for (const auto& series : study.series) {
    if (!series.limit) continue;
    const auto& l = *series.limit;
    group.rows.push_back({series.name, l.key, l.found ? brief(l.value()) : "not found", brief(l.stable),
                          brief(l.unstable), yes(l.monotone), fmt::format("{}", l.probes.size())});
  }
  if (!group.rows.empty()) table.groups.push_back(std::move(group));
  return table;
}

Table values_table(const StudyResult& study) {
  Table table{"Measured values", {"name", "value", "meaning"}, {}};
  Table::Group group;
  for (const auto& v : study.values) group.rows.push_back({v.name, brief(v.value), v.meaning});
  if (!group.rows.empty()) table.groups.push_back(std::move(group));
  return table;
}

namespace {

/// A series and what it costs to come down to some error.
struct Bid {
  std::string name;
  double cost = 0;
};

/// Series that reach the error, cheapest first.
std::vector<Bid> bids(double error, const StudyResult& study, const Figure& figure) {
  std::vector<Bid> result;
  for (const Series* series : figure_series(study, figure)) {
    const double cost = cost_to_reach(error, pareto_front(work_points(*series, figure.quantity)));
    if (std::isfinite(cost)) result.push_back({series->name, cost});
  }
  std::ranges::stable_sort(result, {}, &Bid::cost);
  return result;
}

/// The powers of ten among a figure's errors.
std::vector<double> error_decades(const StudyResult& study, const Figure& figure) {
  double least = INFINITY, largest = 0;
  for (const Series* series : figure_series(study, figure))
    for (const WorkPoint& p : work_points(*series, figure.quantity))
      least = std::min(least, p.error), largest = std::max(largest, p.error);
  return largest > 0 ? decades(least, largest) : std::vector<double>{};
}

}  // namespace

Table cheapest_table(const StudyResult& study) {
  Table table{"Cheapest series for a given error (step seconds on one core, power laws between measured runs)",
              {"error", "cheapest", "s", "next", "s", "times as much", "do not reach it"},
              {}};
  for (const Figure& figure : study.figures) {
    if (figure.kind != "work-precision") continue;
    const std::size_t all = figure_series(study, figure).size();
    Table::Group group{fmt::format("{}: {}", figure.name, figure.quantity), {}};
    for (const double error : error_decades(study, figure)) {
      const auto ranked = bids(error, study, figure);
      const bool rival = ranked.size() > 1;
      group.rows.push_back({fmt::format("{:.0e}", error), ranked[0].name, brief(ranked[0].cost),
                            rival ? ranked[1].name : "–", rival ? brief(ranked[1].cost) : "–",
                            rival ? fmt::format("{:.2f}", ranked[1].cost / ranked[0].cost) : "–",
                            fmt::format("{} of {}", all - ranked.size(), all)});
    }
    if (!group.rows.empty()) table.groups.push_back(std::move(group));
  }
  return table;
}

std::vector<Table> tables_of(const StudyResult& study) {
  std::vector<Table> tables{points_table(study),     cheapest_table(study),       fits_table(study),
                            replicates_table(study), extrapolations_table(study), limits_table(study),
                            values_table(study)};
  std::erase_if(tables, &Table::empty);
  return tables;
}

namespace {

std::string latex_row(const std::vector<std::string>& cells) {
  std::vector<std::string> escaped;
  for (const auto& cell : cells) escaped.push_back(latex_text(cell));
  return fmt::format("{} \\\\\n", fmt::join(escaped, " & "));
}

std::string latex_table(const Table& table) {
  std::string text = fmt::format("\n% {}\n\\begin{{tabular}}{{{}}}\n\\toprule\n", latex_text(table.caption),
                                 std::string(table.columns.size(), 'l'));
  text += latex_row(table.columns);
  for (const auto& group : table.groups) {
    text += "\\midrule\n";
    if (!group.title.empty())
      text +=
          fmt::format("\\multicolumn{{{}}}{{l}}{{\\emph{{{}}}}} \\\\\n", table.columns.size(), latex_text(group.title));
    for (const auto& row : group.rows) text += latex_row(row);
  }
  return text + "\\bottomrule\n\\end{tabular}\n\\par\\medskip\n";
}

}  // namespace

std::string latex_tables(const std::string& title, const std::vector<Table>& tables) {
  std::string text = fmt::format("% {}\n% needs \\usepackage{{booktabs}}\n", latex_text(title));
  for (const auto& table : tables) text += latex_table(table);
  return text;
}

}  // namespace mpmvv
