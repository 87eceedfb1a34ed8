#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <thread>

#include "cli/checks.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/forecast.hpp"
#include "cli/help.hpp"
#include "cli/interruption.hpp"
#include "cli/numbers.hpp"
#include "cli/progress_line.hpp"
#include "cli/results.hpp"
#include "cli/shipped.hpp"
#include "cli/study_choice.hpp"
#include "cli/study_text.hpp"
#include "studies/codes/external_run.hpp"
#include "studies/plan/cautions.hpp"
#include "studies/plan/claim_reader.hpp"
#include "studies/plan/external_series.hpp"
#include "studies/plan/shards.hpp"
#include "studies/plan/study_runner.hpp"
#include "studies/store/trial.hpp"

namespace mpmvv::cli {

namespace {

struct StudyOptions {
  StudyChoice choice;
  std::string db, shard, costs;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  bool plan = false, json = false, verbose = false, no_retry = false;
};

[[noreturn]] void stop(const StudyOptions& options, const plan::RunnerCounts& counts) {
  const auto no_more_runs = codes::abandon_external_runs();
  const auto unkept = counts.unkept == 0
                          ? std::string()
                          : fmt::format("the {} that finished while another process locked it and ", counts.unkept);
  note("stopped: {} finished and kept in {}, {}the running ones are lost; the same command goes on from there\n",
       count_text(counts.ran, "case"), options.db, unkept);
  end_interrupted();
}

/// Calls run(runner options) with a line of progress, where it can be interrupted.
template <class Run>
auto interruptible(const StudyOptions& options, const codes::Codes& codes, const Run& run) {
  const Interruption interruption;
  ProgressLine line;
  const auto on_stop = [&](const plan::RunnerCounts& so_far) {
    line.clear();
    stop(options, so_far);
  };
  const auto on_wait = [&] { line.note("another process has locked {}: waiting for it to end\n", options.db); };
  const auto listener = line.listener();
  return run(plan::RunnerOptions{options.jobs, listener, listener, interruption.token(), on_stop, codes,
                                 !options.no_retry, on_wait});
}

/// The part of the work that `--shard` names; all of it without one. `costs` is null where times are guessed.
plan::Work work_of(const StudyOptions& options, const std::vector<plan::StudyPlan>& plans, const store::Store* costs) {
  if (options.shard.empty()) return plan::work_of(plans);
  const plan::Shard shard = plan::shard_from(options.shard);
  return plan::split(plans, plan::CostModel(costs), shard.of)[shard.number - 1];
}

int run_shard(const StudyOptions& options, const std::vector<plan::StudyPlan>& plans, const plan::Work& work,
              const codes::Codes& codes, store::Store& store) {
  plan::RunnerCounts counts;
  const plan::ShardOutcome outcome = interruptible(
      options, codes, [&](const auto& running) { return plan::run_shard(plans, work, store, running, counts); });
  for (const std::string& trouble : outcome.troubles) note("{}\n", trouble);
  print(
      "shard {}: {} run, {} taken from {}, {} failed; `mpmvv db merge` puts the shards together, `mpmvv study` "
      "makes their studies\n",
      options.shard, count_text(counts.ran, "case"), counts.reused, options.db, outcome.failed);
  return outcome.failed == 0 && outcome.troubles.empty() ? 0 : 1;
}

/// Whether the series was run, and a run of it went well.
bool has_sound_run(const records::Series& series) {
  const auto is_ok = [](const records::Point& point) { return point.status == records::Status::ok; };
  return std::ranges::any_of(series.points, is_ok) ||
         (series.limit && std::ranges::any_of(series.limit->probes, &fits::Probe::stable));
}

/// Notes what is to be known before the errors of the study's sound runs are believed.
void note_cautions(const plan::StudyPlan& study, const records::StudyResult& result) {
  for (plan::Caution& caution : plan::cautions(study)) {
    std::erase_if(caution.series, [&](const std::string& name) {
      const auto series = std::ranges::find(result.series, name, &records::Series::name);
      return series == result.series.end() || !has_sound_run(*series);
    });
    if (!caution.series.empty()) note("{}\n", plan::caution_text(study.name, caution));
  }
}

int run_studies(const StudyOptions& options, const std::vector<plan::StudyPlan>& plans, const codes::Codes& codes,
                store::Store& store) {
  plan::RunnerCounts counts;
  auto outcomes = interruptible(options, codes,
                                [&](const auto& running) { return plan::run_studies(plans, store, running, counts); });
  std::size_t failed = 0;
  for (plan::StudyOutcome& outcome : outcomes) {
    failed += outcome.failed;
    if (is_trial(outcome.result)) withhold_verdicts(outcome.result);
    if (!outcome.trouble.empty()) {
      note("study {} is not kept: {}\n", outcome.result.name, outcome.trouble);
      continue;
    }
    print_study(outcome.result, options.verbose);
    note_cautions(*std::ranges::find(plans, outcome.result.name, &plan::StudyPlan::name), outcome.result);
  }
  const auto lost = std::ranges::count_if(outcomes, [](const auto& outcome) { return !outcome.trouble.empty(); });
  print("{} run, {} taken from {}, {} failed{}\n", count_text(counts.ran, "case"), counts.reused, options.db, failed,
        lost > 0 ? fmt::format("; studies not kept: {}", lost) : "");
  return failed == 0 && lost == 0 ? 0 : 1;
}

/// Notes which studies in the store will be replaced by trials (--set).
void note_replaced(const std::vector<plan::StudyPlan>& trials, const store::Store& store, const std::string& db) {
  for (const records::StudyResult& held : store.studies(store::current_provenance().digest))
    for (const plan::StudyPlan& trial : trials)
      if (trial.name == held.name && !store::trial_of(trial.text).empty() && store::trial_of(held.text).empty())
        note(
            "{}: takes the place of the study in {} (without --set it comes back; keep trials in a store of their "
            "own)\n",
            trial.name, db);
}

int study(const StudyOptions& options) {
  plan::CodeFinder finder(shipped("adapters"));
  const bool is_asked_for = !options.choice.names.empty() && !options.plan;
  const AbsentCode absent = is_asked_for || !options.shard.empty() ? AbsentCode::refused : AbsentCode::left_out;
  const auto [plans, left_out] = read_plans(options.choice, options.db, finder, absent);
  std::optional<store::Store> held;
  if (!options.costs.empty()) held.emplace(options.costs, store::Store::Mode::read);
  const store::Store* costs = held ? &*held : nullptr;
  const plan::Work work = work_of(options, plans, costs);
  if (options.plan) {
    print_forecast(plans, work, options.db, costs, options.jobs, options.json);
    return 0;
  }
  store::Store store(options.db, store::Store::Mode::create_or_write);
  plan::require_one_voice(plans, store.statements(store::current_provenance().digest), options.db);
  if (!options.shard.empty()) return run_shard(options, plans, work, finder.codes(), store);
  if (!options.choice.settings.empty() || !options.choice.where_taken.empty()) note_replaced(plans, store, options.db);
  constexpr int incomplete = 3;
  const int code = run_studies(options, plans, finder.codes(), store);
  return code == 0 && left_out > 0 ? incomplete : code;
}

}  // namespace

void add_study(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<StudyOptions>();
  CLI::App* command = app.add_subcommand("study", "Run what study files describe and the store does not hold yet");
  add_study_choice(*command, options->choice);
  command->add_option("--db", options->db, "results store (SQLite)")->required()->type_name("FILE");
  command
      ->add_option("--set", options->choice.settings,
                   "setting for every case of the studies (repeatable): a trial, to be kept in a store of its own")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_option("--set-where-taken", options->choice.where_taken, "as --set, in the series alone that take it")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_option("--jobs", options->jobs, "cases at once, 1 to 1024 (default: all cores)")
      ->check(from_to(1, 1024))
      ->type_name("NUMBER");
  CLI::Option* shard =
      command
          ->add_option("--shard", options->shard,
                       "run one machine's part of the cases, 2/8 for instance, in a store of its own, to be merged")
          ->type_name("NUMBER/OF");
  command
      ->add_option("--costs", options->costs,
                   "store whose times make the shards equally long; the same one for all of them")
      ->needs(shard)
      ->type_name("FILE");
  CLI::Option* no_retry =
      command->add_flag("--no-retry", options->no_retry,
                        "take failed runs as the store has them (default: those of another code, and those that the "
                        "machine failed, are tried again)");
  CLI::Option* verbose =
      command->add_flag("--verbose", options->verbose, "print on what grounds fits and criteria say what they do, too")
          ->excludes(shard);
  CLI::Option* plan = command->add_flag("--plan", options->plan, "run nothing: print what would run, how long, and why")
                          ->excludes(no_retry)
                          ->excludes(verbose);
  command->add_flag("--json", options->json, "print the plan as one JSON object")->needs(plan);
  add_examples(*command,
               {"mpmvv study splines.toml --db results.db", "mpmvv study s-fig4 s-jump --db results.db",
                "mpmvv study s-fig10 --db results.db --plan", "mpmvv study splines.toml --shard 2/8 --db shard-2.db",
                "mpmvv study splines.toml --set shuffle=1 --db trial.db"});
  command->callback([options, &exit_code] { exit_code = study(*options); });
}

}  // namespace mpmvv::cli
