#include <fmt/format.h>

#include <algorithm>

#include "solver/velocity_update/velocity_updates.hpp"
#include "studies/checks/check.hpp"
#include "studies/plan/claim_reader.hpp"
#include "studies/plan/criterion_reader.hpp"
#include "studies/plan/figure_reader.hpp"
#include "studies/plan/file_tables.hpp"
#include "studies/plan/overriding.hpp"
#include "studies/plan/plan_rules.hpp"
#include "studies/plan/study.hpp"
#include "studies/settings/named.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::plan {

using settings::Setting;
using support::TomlTable;
using support::UsageError;

namespace {

/// The settings of a table; `param = { amplitude = 0.02 }` becomes `param.amplitude`.
std::vector<Setting> settings_of(const TomlTable& table, std::initializer_list<const char*> others = {}) {
  std::vector<Setting> settings;
  for (const std::string& key : table.keys()) {
    if (std::find(others.begin(), others.end(), key) != others.end()) continue;
    if (key == "param") {
      const TomlTable parameters = table.table(key).value();
      for (const std::string& name : parameters.keys())
        settings.push_back({"param." + name, parameters.scalar_text(name), parameters.where(name)});
    } else {
      settings::require_known_key(key, table.where(key));
      settings.push_back({key, table.scalar_text(key), table.where(key)});
    }
  }
  return settings;
}

/// The claims that a study names, and those that it states beside them.
void read_claim_names(const TomlTable& root, StudyPlan& plan) {
  plan.claims = root.texts("claims");
  plan.claims_where = root.where("claims");
  plan.statements = read_claims(root, plan.name);
  for (const StatedClaim& claim : plan.statements)
    if (std::ranges::find(plan.claims, claim.text.id) == plan.claims.end()) plan.claims.push_back(claim.text.id);
}

void read_sweep(const TomlTable& root, StudyPlan& plan) {
  auto sweep = root.table("sweep");
  if (!sweep) return;
  const bool is_of_problem = sweep->keys() == std::vector<std::string>{"param"};  // param.amplitude = [0.01, 0.02]
  if (is_of_problem) sweep = sweep->table("param");
  const auto keys = sweep->keys();
  if (keys.size() != 1)
    throw UsageError(fmt::format("sweep in {} has {} keys (one key with its values)", sweep->where(), keys.size()));
  const std::string& key = keys[0];
  plan.sweep = is_of_problem ? "param." + key : key;
  plan.sweep_where = sweep->where(key);
  settings::require_known_key(plan.sweep, plan.sweep_where);
  if (!settings::words_of_key(plan.sweep).empty())
    throw UsageError(fmt::format("sweep over '{}' in {}, which takes words (a key that takes numbers)", plan.sweep,
                                 plan.sweep_where));
  plan.values = sweep->numbers(key);
  if (plan.values.empty())
    throw UsageError(fmt::format("empty sweep over '{}' in {} (at least one value)", plan.sweep, plan.sweep_where));
  auto sorted = plan.values;
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    throw UsageError(fmt::format("{} twice in the sweep over '{}' in {} (once)", *twice, plan.sweep, plan.sweep_where));
  if (!std::ranges::is_sorted(plan.values, std::ranges::greater())) plan.values = std::move(sorted);
}

/// The code that settings choose; empty: our own solver.
std::string code_of(const std::vector<Setting>& settings) {
  const auto found = std::ranges::find(settings, "code", &Setting::key);
  return found == settings.end() ? "" : found->value;
}

bool is_of(const Setting& setting, const std::string& code) {
  const auto& keys = settings::setting_keys();
  const auto known = std::ranges::find(keys, setting.key, &settings::SettingKey::key);
  return known == keys.end() || known->is_of(code);
}

/// Removes from each series the fixed settings that its solver does not know but another series' solver does. A setting
/// that no series' solver knows stays, so that it is refused.
void leave_to_others(const std::vector<Setting>& fixed, std::vector<SeriesPlan>& series) {
  std::vector<std::string> codes;
  for (const SeriesPlan& one : series) codes.push_back(code_of(one.settings));
  for (const Setting& setting : fixed)
    if (std::ranges::any_of(codes, [&](const std::string& code) { return is_of(setting, code); }))
      for (std::size_t k = 0; k < series.size(); ++k)
        std::erase_if(series[k].settings, [&](const Setting& s) {
          return s.key == setting.key && s.where == setting.where && !is_of(s, codes[k]);
        });
}

void read_series(const TomlTable& root, StudyPlan& plan) {
  std::vector<Setting> fixed;
  if (const auto table = root.table("fixed")) fixed = settings_of(*table);
  for (const TomlTable& table : root.tables("series")) {
    SeriesPlan series{table.text("name"), fixed, table.where()};
    if (series.name.find_first_not_of(" \t") == std::string::npos)
      throw UsageError(fmt::format("'name' is blank in {} (a text)", table.where("name")));
    if (plan.has_series(series.name))
      throw UsageError(fmt::format("series '{}' twice in {} (names must differ)", series.name, table.where("name")));
    for (const Setting& setting : settings_of(table, {"name"})) series.settings.push_back(setting);
    plan.series.push_back(series);
  }
  leave_to_others(fixed, plan.series);
}

void read_limit(const TomlTable& root, StudyPlan& plan) {
  const auto table = root.table("limit");
  if (!table) return;
  require_known_keys(*table, "limit");
  fits::LimitSearch search;
  search.key = table->text("key");
  require_word("limit key", search.key, {"cfl", "smoothing_length"}, table->where("key"));
  search.from = table->number("from");
  search.to = table->number("to");
  search.scan_ratio = table->number("scan_ratio", search.scan_ratio);
  search.tolerance = table->number("tolerance", search.tolerance);
  const std::string stable = table->text("stable", "below");
  require_word("stable side", stable, {"below", "above"}, table->where("stable"));
  search.stable_below = stable == "below";
  try {
    fits::require_sound(search);
  } catch (const UsageError& e) {
    throw UsageError(fmt::format("{} in {}", e.what(), table->where()));
  }
  plan.limit = LimitPlan{search, series_names(*table, "series", plan), table->where()};
}

void read_replicates(const TomlTable& root, StudyPlan& plan) {
  const auto table = root.table("replicates");
  if (!table) return;
  const auto keys = table->keys();
  if (keys.size() != 1 || (plan.sweep.empty() && !plan.limit) || keys[0] == plan.sweep)
    throw UsageError(fmt::format("replicates in {} (one key with its values, beside a limit or a sweep of another)",
                                 table->where()));
  require_word("key of replicates", keys[0], {"grid_offset", "shuffle"}, table->where(keys[0]));
  plan.replicates = ReplicatePlan{keys[0], table->numbers(keys[0]), table->where(keys[0])};
  if (plan.replicates->values.size() < 2)
    throw UsageError(fmt::format("fewer than two replicates in {}", plan.replicates->where));
}

/// Throws where a fit or an extrapolation before it is of the same norm and window, and shares a series with it.
template <class Wanted>
void require_first(const std::vector<Wanted>& before, const Wanted& wanted, const std::string& where) {
  const auto& [from, to] = wanted.window;
  const bool is_repeated = std::ranges::any_of(before, [&](const Wanted& other) {
    const bool shares = wanted.series.empty() || other.series.empty() ||
                        std::ranges::find_first_of(wanted.series, other.series) != wanted.series.end();
    return shares && other.norm == wanted.norm && other.window.from == from && other.window.to == to;
  });
  if (is_repeated)
    throw UsageError(fmt::format("{} over [{}, {}] twice in {} (once for each series)", wanted.norm, from, to, where));
}

void read_extrapolations(const TomlTable& root, StudyPlan& plan) {
  for (const TomlTable& table : root.tables("extrapolate")) {
    require_known_keys(table, "extrapolate");
    ExtrapolationPlan wanted{norm_of(table, "norm"), read_window(table, "window"), {}};
    require_points(plan, wanted.window, 4, table.where("window"));
    require_step_size(plan, table.where());
    wanted.series = measured_series(plan, wanted.norm, series_names(table, "series", plan), table.where("norm"));
    require_first(plan.extrapolations, wanted, table.where());
    plan.extrapolations.push_back(wanted);
  }
}

void read_fits(const TomlTable& root, StudyPlan& plan) {
  for (const TomlTable& table : root.tables("fit")) {
    require_known_keys(table, "fit");
    FitPlan fit{norm_of(table, "norm"), read_window(table, "window"), {}, {}};
    require_points(plan, fit.window, 3, table.where("window"));
    require_step_size(plan, table.where());
    fit.series = measured_series(plan, fit.norm, series_names(table, "series", plan), table.where("norm"));
    require_first(plan.fits, fit, table.where());
    if (table.has("floor_window")) {
      fit.floor = read_window(table, "floor_window");
      require_points(plan, *fit.floor, 6, table.where("floor_window"));
    }
    plan.fits.push_back(fit);
  }
}

/// Makes every case of the study once, so that a mistake shows before the first run.
void try_cases(const StudyPlan& plan, const std::filesystem::path& file) {
  for (const SeriesPlan& series : plan.series) try {
      try_cases(plan, series);
    } catch (const UsageError& e) {
      const std::string message = e.what();
      const bool has_place = message.find(file.string()) != std::string::npos;
      throw UsageError(has_place ? message
                                 : fmt::format("{} in series '{}' of {}", message, series.name, series.where));
    }
}

/// The name of a study is the stem of its file. Reports name files by it, too.
std::string study_name(const std::filesystem::path& file) {
  const std::string name = file.stem().string();
  if (!support::is_file_stem(name))
    throw UsageError(fmt::format("study file '{}' cannot name a study ({})", file.string(), support::file_stem_rule));
  return name;
}

}  // namespace

const Setting* SeriesPlan::setting(const std::string& key) const {
  const auto last = std::find_if(settings.rbegin(), settings.rend(), [&](const Setting& s) { return s.key == key; });
  return last == settings.rend() ? nullptr : &*last;
}

bool StudyPlan::has_series(const std::string& wanted) const {
  return std::any_of(series.begin(), series.end(), [&](const SeriesPlan& s) { return s.name == wanted; });
}

bool StudyPlan::searches(const SeriesPlan& one) const {
  return limit && (limit->series.empty() || std::ranges::find(limit->series, one.name) != limit->series.end());
}

/// A series whose velocity update takes no order gives one run at all orders of a sweep: a level line in its figure.
bool varies_with(const SeriesPlan& series, const std::string& key) {
  if (key != "order") return true;
  const Setting* update = series.setting("velocity_update");
  return update && solver::expands_inverse(settings::named<solver::AnyVelocityUpdate>(update->value));
}

cases::Case case_at(const SeriesPlan& series, const std::string& key, double value, const std::string& where) {
  auto settings = series.settings;
  if (varies_with(series, key)) settings.push_back({key, fmt::format("{}", value), where});
  return settings::make_case(settings);
}

std::vector<SeriesPlan> replicates_of(const StudyPlan& plan, const SeriesPlan& series) {
  if (!plan.replicates) return {series};
  std::vector<SeriesPlan> replicates;
  for (const double value : plan.replicates->values) {
    replicates.push_back(series);
    replicates.back().settings.push_back({plan.replicates->key, fmt::format("{}", value), plan.replicates->where});
  }
  return replicates;
}

std::vector<cases::Case> replicates_at(const StudyPlan& plan, const SeriesPlan& series, double value) {
  std::vector<cases::Case> cases;
  for (const SeriesPlan& one : replicates_of(plan, series))
    cases.push_back(case_at(one, plan.sweep, value, plan.sweep_where));
  return cases;
}

StudyPlan read_study(const std::filesystem::path& file, const std::vector<Overriding>& overriding) {
  study_name(file);
  return parse_study(support::require_file(file, "a study file, TOML"), file, overriding);
}

StudyPlan parse_study(const std::string& text, const std::filesystem::path& file,
                      const std::vector<Overriding>& overriding) {
  const std::string name = study_name(file);
  const TomlTable root = TomlTable::parse(text, file.string());
  require_known_keys(root, "");
  StudyPlan plan;
  plan.name = name;
  plan.text = text;
  plan.title = root.text("title");
  read_claim_names(root, plan);
  plan.check = root.text("check", "");
  if (!plan.check.empty()) {
    checks::find_check(plan.check, root.where("check"));
    for (const char* key : {"fixed", "series", "sweep", "limit", "replicates"})
      if (root.has(key))
        throw UsageError(fmt::format("'{}' in {} beside a check (a check brings its own)", key, root.where(key)));
  }
  read_series(root, plan);
  read_sweep(root, plan);
  read_limit(root, plan);
  read_replicates(root, plan);
  for (const SeriesPlan& series : plan.series) require_no_idle_settings(plan, series);
  override_series(overriding, plan);
  if (plan.check.empty() && plan.series.empty())
    throw UsageError(
        fmt::format("{} describes nothing to run (series with a sweep or a limit, or a check)", file.string()));
  if (plan.check.empty() && plan.sweep.empty() && !plan.limit)
    throw UsageError(fmt::format("{} has series but neither sweep nor limit", file.string()));
  read_fits(root, plan);
  read_extrapolations(root, plan);
  for (const TomlTable& table : root.tables("figure")) plan.figures.push_back(read_figure(table, plan));
  for (const TomlTable& table : root.tables("criterion")) plan.criteria.push_back(read_criterion(table, plan));
  try_cases(plan, file);
  return plan;
}

}  // namespace mpmvv::plan
