#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/forecast.hpp"
#include "cli/outputs.hpp"
#include "cli/shipped.hpp"
#include "studies/plan/claim_reader.hpp"
#include "studies/plan/study_runner.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using plan::Overriding;
using records::Series;

namespace {

struct StudyOptions {
  std::vector<std::string> files;
  std::string db;
  std::vector<std::string> settings, where_taken;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  bool plan = false, json = false;
};

/// A line that rewrites itself on a terminal; nothing elsewhere.
std::function<void(const plan::Progress&)> progress_line() {
  if (!isatty(STDERR_FILENO)) return {};
  return [](const plan::Progress& p) {
    note("\r\033[K[{}/{}] {}", p.done, p.total, p.label);
    if (p.done == p.total) note("\r\033[K");
    std::fflush(stderr);
  };
}

std::string number_or_status(const records::Point& point, const std::string& quantity) {
  if (point.status != records::Status::ok) return to_string(point.status);
  const auto y = point.y.find(quantity);
  return y == point.y.end() ? "-" : fmt::format("{:.4e}", y->second);
}

/// Quantities to print: those that are fitted or drawn, and cost where it was measured.
std::vector<std::string> quantities_of(const records::StudyResult& study) {
  std::vector<std::string> quantities;
  const auto add = [&quantities](const std::string& q) {
    if (std::find(quantities.begin(), quantities.end(), q) == quantities.end()) quantities.push_back(q);
  };
  for (const records::Figure& figure : study.figures) add(figure.quantity);
  for (const Series& series : study.series)
    for (const fits::ObservedOrder& order : series.orders) add(order.norm);
  for (const Series& series : study.series)
    for (const records::Point& point : series.points)
      if (point.y.contains("step_seconds")) add("step_seconds");
  return quantities;
}

/// The errors of all series by swept value; curves of a check are left to the report.
void print_errors(const records::StudyResult& study, const std::string& quantity) {
  constexpr std::size_t longest_table = 40;
  if (study.series.empty() || study.series[0].points.empty() || study.series[0].points.size() > longest_table) return;
  print("  {} by {}\n", quantity, study.sweep);
  for (const Series& series : study.series) {
    print("    {}\n", series.name);
    for (const records::Point& point : series.points)
      print("      {:>10.6g}  {}\n", point.x, number_or_status(point, quantity));
  }
}

void print_replicates(const fits::ReplicateFit& fit) {
  print("    replicates: {} runs that scatter by {:.2g} of the error, order ± {:.2f}, lack of fit p = {:.2g}\n",
        fit.observations, fit.scatter, fit.half_width, fit.lack_of_fit);
}

void print_order(const Series& series, const fits::ObservedOrder& order) {
  const std::string interval = std::isnan(order.half_width) ? "" : fmt::format(" ± {:.2f}", order.half_width);
  print("  order {:.2f}{} of '{}' in {} over [{:g}, {:g}], {}\n", order.order, interval, series.name, order.norm,
        order.from, order.to, order.asymptotic ? "asymptotic" : "not asymptotic");
  if (order.floor)
    print("    floor {} ({})\n", order.floor->accepted ? fmt::format("{:.3e}", order.floor->floor) : "none",
          order.floor->reason);
  if (order.replicates) print_replicates(*order.replicates);
}

void print_extrapolation(const Series& series, const fits::Extrapolation& e) {
  const std::string index = std::isnan(e.convergence_index) ? "" : fmt::format(" (GCI {:.2g})", e.convergence_index);
  print("  '{}' in {} over [{:g}, {:g}]: {}, free order {:.2f}, limit {:.5g}, finest grid {:.5g} ± {:.2g}{}{}\n",
        series.name, e.norm, e.from, e.to, e.model, e.order, e.limit, e.finest, e.uncertainty, index,
        e.remark.empty() ? "" : "; " + e.remark);
}

void print_limit(const Series& series) {
  if (!series.limit) return;
  const fits::StabilityLimit& limit = *series.limit;
  if (!limit.found)
    print("  no {} limit of '{}' in the range searched\n", limit.key, series.name);
  else
    print("  {} limit of '{}' between {:.4g} (stable) and {:.4g} (unstable), {} probes{}\n", limit.key, series.name,
          limit.stable, limit.unstable, limit.probes.size(), limit.monotone ? "" : ", NOT MONOTONE");
}

void print_study(const records::StudyResult& study) {
  print("{}: {}\n", study.name, study.title);
  for (const std::string& quantity : quantities_of(study)) print_errors(study, quantity);
  for (const Series& series : study.series) {
    for (const fits::ObservedOrder& order : series.orders) print_order(series, order);
    for (const fits::Extrapolation& extrapolation : series.extrapolations) print_extrapolation(series, extrapolation);
    print_limit(series);
  }
  for (const records::Value& value : study.values) print("  {} = {:.6g}  {}\n", value.name, value.value, value.meaning);
  for (const records::ClaimPart& part : study.parts)
    print("  {} {}: {}\n    {}\n", part.claim, to_string(part.verdict), part.statement, part.evidence);
}

settings::Setting setting_from(const std::string& text, const char* option) {
  const auto equals = text.find('=');
  if (equals == 0 || equals == std::string::npos)
    throw support::UsageError(fmt::format("{} {} (key=value, as in {} shuffle=1)", option, text, option));
  return {text.substr(0, equals), text.substr(equals + 1), option};
}

std::vector<Overriding> overriding_settings(const StudyOptions& options) {
  std::vector<Overriding> all;
  for (const std::string& text : options.settings) all.push_back({setting_from(text, "--set")});
  for (const std::string& text : options.where_taken) all.push_back({setting_from(text, "--set-where-taken"), true});
  return all;
}

/// A setting of `--set-where-taken` that no series takes is a mistake of the user: UsageError with the refusal.
void require_taken(const std::vector<Overriding>& settings, const std::vector<plan::StudyPlan>& plans) {
  for (std::size_t k = 0; k < settings.size(); ++k) {
    std::string refusal;
    bool taken = false;
    for (const plan::StudyPlan& plan : plans) {
      if (plan.overridden.empty()) continue;  // a check
      taken = taken || plan.overridden[k].series > 0;
      if (!plan.overridden[k].refusal.empty()) refusal = plan.overridden[k].refusal;
    }
    if (!taken && !refusal.empty())
      throw support::UsageError(
          fmt::format("no series takes {} = {} ({})", settings[k].setting.key, settings[k].setting.value, refusal));
  }
}

std::vector<plan::StudyPlan> read_plans(const StudyOptions& options) {
  const std::vector<Overriding> overriding = overriding_settings(options);
  std::vector<plan::StudyPlan> plans;
  for (const std::string& file : options.files) {
    plans.push_back(plan::read_study(file, overriding));
    for (const plan::Overridden& done : plans.back().overridden) note("{}: {}\n", plans.back().name, done.what);
    for (std::size_t k = 0; k + 1 < plans.size(); ++k)
      if (plans[k].name == plans.back().name)
        throw support::UsageError(fmt::format("two study files named '{}' (stems must differ)", plans.back().name));
  }
  require_taken(overriding, plans);
  std::vector<std::filesystem::path> folders;
  for (const std::string& file : options.files) folders.push_back(std::filesystem::path(file).parent_path());
  folders.push_back(shipped("studies"));
  plan::state_claims(plans, folders);
  require_apart("--db", options.db, {options.files.begin(), options.files.end()});
  return plans;
}

int study(const StudyOptions& options) {
  const std::vector<plan::StudyPlan> plans = read_plans(options);
  if (options.plan) {
    print_forecast(plans, options.db, options.jobs, options.json);
    return 0;
  }
  store::Store store(options.db, store::Store::Mode::create_or_write);
  plan::require_one_voice(plans, store.statements(store::current_provenance().digest), options.db);
  plan::RunnerCounts counts;
  const auto outcomes = plan::run_studies(plans, store, {options.jobs, progress_line()}, counts);
  std::size_t failed = 0;
  for (const plan::StudyOutcome& outcome : outcomes) {
    failed += outcome.failed;
    if (outcome.trouble.empty())
      print_study(outcome.result);
    else
      note("study {} is not kept: {}\n", outcome.result.name, outcome.trouble);
  }
  const auto lost = std::ranges::count_if(outcomes, [](const auto& outcome) { return !outcome.trouble.empty(); });
  print("{} cases run, {} taken from {}, {} failed{}\n", counts.ran, counts.reused, options.db, failed,
        lost > 0 ? fmt::format("; studies not kept: {}", lost) : "");
  return failed == 0 && lost == 0 ? 0 : 1;
}

}  // namespace

void add_study(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<StudyOptions>();
  CLI::App* command = app.add_subcommand("study", "Run what study files describe and the store does not hold yet");
  command->add_option("files", options->files, "study files (TOML)")->required();
  command->add_option("--db", options->db, "results store (SQLite)")->required();
  command
      ->add_option("--set", options->settings,
                   "key=value for every case of the studies (repeatable): a trial, to be kept in a store of its own")
      ->allow_extra_args(false);
  command->add_option("--set-where-taken", options->where_taken, "as --set, in the series alone that take it")
      ->allow_extra_args(false);
  command->add_option("--jobs", options->jobs, "cases at once (default: all cores)")->check(CLI::Range(1, 1024));
  CLI::Option* plan =
      command->add_flag("--plan", options->plan, "run nothing: print what would run, how long, and why");
  command->add_flag("--json", options->json, "print the plan as one JSON object")->needs(plan);
  command->callback([options, &exit_code] { exit_code = study(*options); });
}

}  // namespace mpmvv::cli
