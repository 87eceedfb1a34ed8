#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <thread>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/forecast.hpp"
#include "cli/help.hpp"
#include "cli/interruption.hpp"
#include "cli/numbers.hpp"
#include "cli/outputs.hpp"
#include "cli/progress_line.hpp"
#include "cli/shipped.hpp"
#include "cli/study_text.hpp"
#include "studies/codes/external_run.hpp"
#include "studies/plan/claim_reader.hpp"
#include "studies/plan/external_series.hpp"
#include "studies/plan/study_runner.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using plan::Overriding;

namespace {

struct StudyOptions {
  std::vector<std::string> names;
  std::string studies, db;
  std::vector<std::string> settings, where_taken;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  bool plan = false, json = false, verbose = false;
};

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

/// Where claims may be stated that the studies name: beside them, and among the studies that come with the program.
std::vector<std::filesystem::path> claim_folders(const std::vector<std::string>& files) {
  std::vector<std::filesystem::path> folders;
  for (const std::string& file : files)
    if (const auto folder = std::filesystem::path(file).parent_path();
        std::ranges::find(folders, folder) == folders.end())
      folders.push_back(folder);
  if (const auto own = shipped("studies"); !own.empty()) folders.push_back(own);
  return folders;
}

/// Where a code is not there, a study that was asked for by its name cannot be run; of a whole folder it is left out.
/// Whether it is.
bool is_left_out(plan::StudyPlan& plan, const std::string& file, plan::CodeFinder& codes, const StudyOptions& options) {
  const std::string absent = plan::complete_series(plan, file, codes);
  if (absent.empty()) return false;
  if (!options.names.empty() && !options.plan) throw support::UsageError(fmt::format("{}: {}", file, absent));
  note("{} is left out: {}\n", plan.name, absent);
  return true;
}

std::vector<plan::StudyPlan> read_plans(const StudyOptions& options, plan::CodeFinder& codes) {
  const std::vector<Overriding> overriding = overriding_settings(options);
  const std::vector<std::string> files = named_study_files(options.names, options.studies);
  std::vector<plan::StudyPlan> plans;
  for (const std::string& file : files) {
    plans.push_back(plan::read_study(file, overriding));
    for (const plan::Overridden& done : plans.back().overridden) note("{}: {}\n", plans.back().name, done.what);
    for (std::size_t k = 0; k + 1 < plans.size(); ++k)
      if (plans[k].name == plans.back().name)
        throw support::UsageError(fmt::format("two study files named '{}' (stems must differ)", plans.back().name));
    if (is_left_out(plans.back(), file, codes, options)) plans.pop_back();
  }
  require_taken(overriding, plans);
  plan::state_claims(plans, claim_folders(files));
  require_apart("--db", options.db, {files.begin(), files.end()});
  return plans;
}

/// As a shell says of a program that was interrupted from the keyboard.
[[noreturn]] void stop(const StudyOptions& options, const plan::RunnerCounts& counts) {
  constexpr int interrupted = 130;
  codes::abandon_external_runs();
  note("stopped: {} finished and kept in {}, the running ones are lost; the same command goes on from there\n",
       count_text(counts.ran, "case"), options.db);
  std::_Exit(interrupted);
}

std::vector<plan::StudyOutcome> run(const std::vector<plan::StudyPlan>& plans, store::Store& store,
                                    const StudyOptions& options, const codes::Codes& codes,
                                    plan::RunnerCounts& counts) {
  const Interruption interruption;
  ProgressLine line;
  const auto on_stop = [&](const plan::RunnerCounts& so_far) {
    line.clear();
    stop(options, so_far);
  };
  const auto listener = line.listener();
  return plan::run_studies(plans, store, {options.jobs, listener, listener, interruption.token(), on_stop, codes},
                           counts);
}

int study(const StudyOptions& options) {
  plan::CodeFinder codes(shipped("adapters"));
  const std::vector<plan::StudyPlan> plans = read_plans(options, codes);
  if (options.plan) {
    print_forecast(plans, options.db, options.jobs, options.json);
    return 0;
  }
  store::Store store(options.db, store::Store::Mode::create_or_write);
  plan::require_one_voice(plans, store.statements(store::current_provenance().digest), options.db);
  plan::RunnerCounts counts;
  const auto outcomes = run(plans, store, options, codes.codes(), counts);
  std::size_t failed = 0;
  for (const plan::StudyOutcome& outcome : outcomes) {
    failed += outcome.failed;
    if (outcome.trouble.empty())
      print_study(outcome.result, options.verbose);
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
  command
      ->add_option("files", options->names,
                   "study files (TOML), or names of studies in --studies (default: all of --studies)")
      ->type_name("FILE");
  command
      ->add_option("--studies", options->studies,
                   "folder of study files (default: for names, the one that comes with the program)")
      ->type_name("FOLDER");
  command->add_option("--db", options->db, "results store (SQLite)")->required()->type_name("FILE");
  command
      ->add_option("--set", options->settings,
                   "setting for every case of the studies (repeatable): a trial, to be kept in a store of its own")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_option("--set-where-taken", options->where_taken, "as --set, in the series alone that take it")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_option("--jobs", options->jobs, "cases at once, 1 to 1024 (default: all cores)")
      ->check(CLI::Range(1, 1024))
      ->type_name("NUMBER");
  command->add_flag("--verbose", options->verbose, "print on what grounds fits and criteria say what they do, too");
  CLI::Option* plan =
      command->add_flag("--plan", options->plan, "run nothing: print what would run, how long, and why");
  command->add_flag("--json", options->json, "print the plan as one JSON object")->needs(plan);
  add_examples(*command, {"mpmvv study splines.toml --db results.db", "mpmvv study s-fig4 s-jump --db results.db",
                          "mpmvv study s-fig10 --db results.db --plan",
                          "mpmvv study splines.toml --set shuffle=1 --db trial.db"});
  command->callback([options, &exit_code] { exit_code = study(*options); });
}

}  // namespace mpmvv::cli
