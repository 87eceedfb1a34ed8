#include "studies/plan/criterion_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "studies/fits/work_precision.hpp"
#include "studies/plan/file_reference.hpp"
#include "studies/plan/file_tables.hpp"
#include "studies/plan/plan_rules.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::plan {

using claims::Criterion;
using support::UsageError;

namespace {

bool is_ratio(Criterion::Kind kind) {
  using enum claims::Criterion::Kind;
  return kind == error_ratio || kind == limit_ratio || kind == cost_ratio || kind == slope_ratio || kind == slope_share;
}

bool is_order(Criterion::Kind kind) {
  using enum claims::Criterion::Kind;
  return kind == order || kind == order_difference;
}

bool is_fit(Criterion::Kind kind) {
  using enum claims::Criterion::Kind;
  return is_order(kind) || kind == slope_ratio || kind == slope_share;
}

/// Throws where a key has no meaning for the measure: it would be left out of what is asked.
void require_no_idle_keys(const support::TomlTable& table, Criterion::Kind kind) {
  const std::vector<std::string> known = keys_of(kind);
  for (const std::string& key : table.keys())
    if (std::ranges::find(known, key) == known.end())
      throw UsageError(fmt::format("'{}' in {} has no meaning for measure '{}' (known: {})", key, table.where(key),
                                   support::to_string(kind), fmt::join(known, ", ")));
}

void read_bounds(const support::TomlTable& table, Criterion& c) {
  if (table.has("at_least")) c.at_least = table.number("at_least");
  if (table.has("at_most")) c.at_most = table.number("at_most");
  if (!c.at_least && !c.at_most)
    throw UsageError(fmt::format("criterion in {} asks nothing (at_least, at_most or both)", table.where()));
  if (c.at_least && c.at_most && *c.at_least > *c.at_most)
    throw UsageError(fmt::format("criterion in {} asks at least {} and at most {} (nothing can be both)", table.where(),
                                 *c.at_least, *c.at_most));
}

void require_searched(const StudyPlan& plan, const std::vector<std::string>& series, const std::string& where) {
  for (const std::string& name : series)
    if (std::ranges::none_of(plan.series, [&](const auto& s) { return s.name == name && plan.searches(s); }))
      throw UsageError(
          fmt::format("criterion in {} on the limit of series '{}', which the study does not search", where, name));
}

/// Throws where the measure would take a time for an exact number: another session measures another one.
void require_interval(Criterion::Kind kind, const std::string& norm, const std::string& where) {
  using enum claims::Criterion::Kind;
  if (norm == "ns_per_particle_step" && kind != slope_ratio && kind != slope_share)
    throw UsageError(
        fmt::format("norm '{}' in {} with measure '{}', which has no interval for times (slope-ratio, slope-share, or "
                    "cost-ratio with the norm of an error)",
                    norm, where, support::to_string(kind)));
}

/// The norm that a criterion names under `key`, which the named series must have.
std::string read_norm(const support::TomlTable& table, const char* key, const StudyPlan& plan,
                      const std::vector<std::string>& series, Criterion::Kind kind) {
  std::string norm = norm_of(table, key);
  require_interval(kind, norm, table.where(key));
  require_measured(plan, norm, series, table.where(key));
  return norm;
}

/// Throws unless the window, which is one of errors, holds a power of ten: costs are compared at these.
void require_decades(const fits::Window& window, const std::string& where) {
  if (!(window.from > 0) || fits::decades(window.from, window.to).empty())
    throw UsageError(fmt::format("window in {} holds no power of ten (two errors, the smaller first)", where));
}

/// Reads the norm and the window, and checks that the `compared` series have them.
void read_norm_and_window(const support::TomlTable& table, const StudyPlan& plan,
                          const std::vector<std::string>& compared, Criterion& c) {
  if (c.kind != Criterion::Kind::status) c.norm = read_norm(table, "norm", plan, compared, c.kind);
  if (c.kind == Criterion::Kind::order_difference) c.over_norm = read_norm(table, "over_norm", plan, c.series, c.kind);
  c.window = read_window(table, "window");
  if (c.kind == Criterion::Kind::cost_ratio) {
    require_cost(plan, table.where("measure"));
    require_decades(c.window, table.where("window"));
  } else {
    require_points(plan, c.window, is_fit(c.kind) ? 3 : 1, table.where("window"));
    if (is_order(c.kind)) require_step_size(plan, table.where());
  }
}

}  // namespace

Criterion read_criterion(const support::TomlTable& table, const StudyPlan& plan) {
  require_known_keys(table, "criterion");
  Criterion c;
  c.claim = table.text("claim");
  require_word("claim of this study", c.claim, plan.claims, table.where("claim"));
  c.statement = table.text("statement");
  c.kind = support::from_word<Criterion::Kind>(table.text("measure"), "measure", table.where("measure"));
  require_no_idle_keys(table, c.kind);
  c.reason = table.text("reason", "");
  if (c.kind == Criterion::Kind::shown || c.kind == Criterion::Kind::awaited) return c;
  read_bounds(table, c);
  if (c.kind == Criterion::Kind::value) {
    c.name = table.text("name");
    return c;
  }
  c.series = series_names(table, "series", plan);
  if (c.series.empty()) throw UsageError(fmt::format("criterion in {} names no series", table.where()));
  std::vector<std::string> compared = c.series;
  if (is_ratio(c.kind)) {
    c.over = series_name(table, "over", plan);
    if (std::ranges::find(c.series, c.over) != c.series.end())
      throw UsageError(fmt::format("series '{}' over itself in {} (another series)", c.over, table.where("over")));
    compared.push_back(c.over);
  }
  if (c.kind == Criterion::Kind::limit || c.kind == Criterion::Kind::limit_ratio)
    require_searched(plan, compared, table.where());
  else
    read_norm_and_window(table, plan, compared, c);
  return c;
}

}  // namespace mpmvv::plan
