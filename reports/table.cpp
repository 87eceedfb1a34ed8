#include "reports/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "reports/text.hpp"
#include "studies/claims/samples.hpp"

namespace mpmvv::reports {

using records::Series;
using records::StudyResult;
using support::not_measured;

namespace {

std::string yes(bool b) {
  return b ? "yes" : "no";
}

std::string five_decimals(double v) {
  return std::isnan(v) ? brief(v) : fmt::format("{:.5f}", v);
}

std::string floor_text(const fits::FloorFit& floor) {
  if (!floor.accepted) return floor.reason;
  return fmt::format("E0 = {}, order {}: {}", brief(floor.floor), order_text(floor.order, not_measured), floor.reason);
}

/// The table with a group for each series that has rows.
template <class RowsOf>
Table with_series(Table table, const StudyResult& study, const RowsOf& rows_of) {
  for (const Series& series : study.series)
    if (auto rows = rows_of(series); !rows.empty()) table.groups.push_back({series.name, std::move(rows)});
  return table;
}

/// The table with these rows under no title.
Table with_rows(Table table, Table::Rows rows) {
  if (!rows.empty()) table.groups.push_back({"", std::move(rows)});
  return table;
}

/// What takes the place of the cell width in a sweep over something else.
std::string step_name(const std::string& sweep) {
  return sweep == "cfl" ? "the Courant number" : sweep == "ppc" ? "1/ppc" : sweep;
}

std::string how_to_read_orders(const std::string& sweep) {
  return fmt::format(
      "The fit is C s^order over the window, s being {}. Asymptotic: the orders of neighbouring points agree there; "
      "stays or grows: they do, and the error does not fall; the range found is where they agree. Floor: an error E0 "
      "that stays as s falls, where a fit with one is accepted.",
      sweep == "cells" ? "the cell width h" : step_name(sweep));
}

/// The points that fitted orders do not take, and why; empty where they take all.
std::string left_out_of_orders(const StudyResult& study) {
  std::vector<std::string> all;
  for (const Series& series : study.series)
    for (const auto& o : series.orders)
      if (const std::string values = claims::left_out(series, o.norm); !values.empty())
        all.push_back(fmt::format("of {} in {} at {}", series.name, o.norm, values));
  return all.empty() ? "" : fmt::format(" Left out of the orders are errors {}.", fmt::join(all, "; "));
}

}  // namespace

Table fits_table(const StudyResult& study) {
  const Table table{"Fitted orders",
                    {"norm", "window", "points", "order", "C", "R²", "asymptotic", "asymptotic range found", "floor"},
                    {},
                    how_to_read_orders(study.sweep) + left_out_of_orders(study)};
  return with_series(table, study, [](const Series& series) {
    Table::Rows rows;
    for (const auto& o : series.orders) {
      const bool found = std::isfinite(o.asymptotic_from);
      rows.push_back({o.norm, window_text(o.from, o.to), claims::points_text(series, o), order_text(o),
                      brief(o.constant), o.points == 2 ? "–" : five_decimals(o.r_squared), fits::asymptotic_word(o),
                      found ? window_text(o.asymptotic_from, o.asymptotic_to) : "none",
                      o.floor ? floor_text(*o.floor) : "–"});
    }
    return rows;
  });
}

/// The orders again, with what replicates say of them.
Table replicates_table(const StudyResult& study) {
  const Table table{
      "Orders by replicates: their interval is that of the scatter; where the lack of fit has p below 0.05 no one "
      "power law fits the means, and the interval is that of their distances from the line",
      {"norm", "window", "runs", "order", "scatter", "lack of fit p"},
      {}};
  return with_series(table, study, [](const Series& series) {
    Table::Rows rows;
    for (const auto& o : series.orders)
      if (o.replicates)
        rows.push_back({o.norm, window_text(o.from, o.to), fmt::format("{}", o.replicates->observations),
                        order_text(o.order, o.replicates->half_width), brief(o.replicates->scatter),
                        brief(o.replicates->lack_of_fit)});
    return rows;
  });
}

Table extrapolations_table(const StudyResult& study) {
  const bool over_grids = study.sweep == "cells";
  const std::string finest = claims::finest_level(study.sweep);
  const Table table{
      fmt::format("Extrapolated to {}, with the uncertainty of the value of the {} (Eça and Hoekstra) and its grid "
                  "convergence index (GCI)",
                  claims::extrapolated_to(study.sweep), finest),
      {"quantity", "window", over_grids ? "grids" : "points", "model", "free order", "limit", finest, "uncertainty",
       "GCI", "remark"},
      {},
      "The free order is that of φ0 + α h^p. Outside of 0.5 to 2 a model of fixed powers is taken instead, and the "
      "free order decides only the factor of safety." +
          (over_grids ? "" : fmt::format(" Here h stands for {}.", step_name(study.sweep)))};
  return with_series(table, study, [](const Series& series) {
    Table::Rows rows;
    for (const auto& e : series.extrapolations)
      rows.push_back({e.norm, window_text(e.from, e.to), fmt::format("{}", e.points), e.model,
                      order_text(e.order, not_measured), brief(e.limit), brief(e.finest), brief(e.uncertainty),
                      brief(e.convergence_index), e.remark});
    return rows;
  });
}

Table limits_table(const StudyResult& study) {
  Table::Rows rows;
  for (const auto& series : study.series) {
    if (!series.limit) continue;
    const auto& l = *series.limit;
    const std::int64_t steps = fits::steps_at_limit(l);
    rows.push_back({series.name, l.key, l.found ? brief(l.value()) : "not found", brief(l.stable), brief(l.unstable),
                    yes(l.monotone), steps > 0 ? fmt::format("{}", steps) : "", growth_text(steps),
                    fmt::format("{}", l.probes.size())});
  }
  return with_rows(
      {"Stability limits",
       {"series", "key", "limit", "stable at", "unstable at", "monotone", "steps", "growth seen", "probes"},
       {},
       "Steps: of the run at the stable end. An instability has to grow from round-off in them. Growth "
       "seen: the least per step that does, 10^(12/steps) - 1. Where runs are longer, slower growth shows, "
       "and the limit lies nearer to the stable end of the search. A stable run of fewer than 40 steps, in which "
       "growth that doubles on each step does not show, does not count for a criterion: the limit may then lie "
       "anywhere beyond the last stable run of 40 steps."},
      rows);
}

Table values_table(const StudyResult& study) {
  Table::Rows rows;
  for (const auto& v : study.values) rows.push_back({v.name, brief(v.value), v.meaning});
  return with_rows({"Measured values", {"name", "value", "meaning"}, {}}, rows);
}

std::vector<Table> tables_of(const StudyResult& study, int dimension) {
  std::vector<Table> tables{limits_table(study),           fits_table(study),   replicates_table(study),
                            extrapolations_table(study),   values_table(study), cheapest_table(study),
                            points_table(study, dimension)};
  std::erase_if(tables, &Table::empty);
  return tables;
}

}  // namespace mpmvv::reports
