#include "studies/plan/figure_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "studies/plan/file_tables.hpp"
#include "studies/plan/plan_rules.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::plan {

using records::Figure;
using support::TomlTable;
using support::UsageError;

namespace {

std::string read_name(const TomlTable& table, const StudyPlan& plan) {
  std::string name = table.text("name", plan.name);
  if (!support::is_file_stem(name))
    throw UsageError(fmt::format("figure name '{}' in {} ({})", name, table.where("name"), support::file_stem_rule));
  for (const Figure& other : plan.figures)
    if (other.name == name)
      throw UsageError(fmt::format("figure '{}' twice in {} (names must differ)", name, table.where("name")));
  return name;
}

bool is_logarithmic(const TomlTable& table, const char* key) {
  const std::string scale = table.text(key, "log");
  require_word(key, scale, {"log", "linear"}, table.where(key));
  return scale == "log";
}

void read_range(const TomlTable& table, const char* key, bool log, std::optional<double>& low,
                std::optional<double>& high) {
  if (!table.has(key)) return;
  const auto ends = table.numbers(key);
  if (ends.size() != 2 || !(ends[0] < ends[1]))
    throw UsageError(fmt::format("{} in {} (two numbers, the smaller first)", key, table.where(key)));
  if (log && !(ends[0] > 0))
    throw UsageError(fmt::format("{} in {} begins at {:g} on a logarithmic axis (above 0, or a linear {}scale)", key,
                                 table.where(key), ends[0], key[0]));
  low = ends[0], high = ends[1];
}

/// Throws when the study lacks what the figure's kind needs, or a key has no meaning for that kind.
void require_drawable(const StudyPlan& plan, const Figure& figure, const TomlTable& table) {
  if (figure.kind == Figure::Kind::work_precision) require_cost(plan, table.where("kind"));
  std::vector<const char*> meaningless;
  if (figure.kind != Figure::Kind::curves) meaningless = {"marks", "slopes"};
  if (figure.kind == Figure::Kind::particles) meaningless.insert(meaningless.end(), {"quantity", "xscale", "yscale"});
  for (const char* key : meaningless)
    if (table.has(key))
      throw UsageError(fmt::format("'{}' in {} has no meaning in a figure of kind '{}'", key, table.where(key),
                                   to_string(figure.kind)));
  if (!figure.slopes.empty() && !(figure.log_x && figure.log_y))
    throw UsageError(fmt::format("'slopes' in {} on a linear axis (xscale and yscale \"log\")", table.where("slopes")));
  if (std::ranges::find(figure.slopes, 0.0) != figure.slopes.end())
    throw UsageError(fmt::format("slope 0 in {} (a power other than 0)", table.where("slopes")));
}

}  // namespace

Figure read_figure(const TomlTable& table, const StudyPlan& plan) {
  require_known_keys(table, "figure");
  Figure figure;
  figure.kind = support::from_word<Figure::Kind>(table.text("kind", "curves"), "figure kind", table.where("kind"));
  figure.name = read_name(table, plan);
  figure.caption = table.text("caption");
  figure.xlabel = table.text("xlabel");
  figure.ylabel = table.text("ylabel");
  figure.log_x = is_logarithmic(table, "xscale");
  figure.log_y = is_logarithmic(table, "yscale");
  figure.quantity = table.has("quantity") ? norm_of(table, "quantity") : plan.check.empty() ? "l2" : "y";
  figure.series =
      figure.kind == Figure::Kind::particles && plan.check.empty()
          ? series_with_particles(plan, series_names(table, "series", plan), table.where("kind"))
          : measured_series(plan, figure.quantity, series_names(table, "series", plan), table.where("quantity"));
  figure.marks = series_names(table, "marks", plan);
  if (table.has("slopes")) figure.slopes = table.numbers("slopes");
  const bool is_of_particles =
      figure.kind == Figure::Kind::particles;  // its axes are lengths, but in 1D errors upright
  read_range(table, "x_range", figure.log_x && !is_of_particles, figure.x_min, figure.x_max);
  read_range(table, "y_range", figure.log_y && !is_of_particles, figure.y_min, figure.y_max);
  require_drawable(plan, figure, table);
  return figure;
}

}  // namespace mpmvv::plan
