#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <regex>

#include "cli/checks.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/engines.hpp"
#include "cli/help.hpp"
#include "cli/interruption.hpp"
#include "cli/numbers.hpp"
#include "cli/outputs.hpp"
#include "cli/shipped.hpp"
#include "cli/study_choice.hpp"
#include "cli/submit_text.hpp"
#include "studies/plan/shards.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/process.hpp"
#include "studies/support/program.hpp"

namespace mpmvv::cli {

namespace fs = std::filesystem;

namespace {

struct SubmitOptions {
  StudyChoice choice;
  std::string engine, db, folder, costs, goldens, partition, account;
  std::vector<std::string> options;
  std::size_t shards = 1;
  int jobs = 1;
  bool dry_run = false;
};

/// A job asks for its estimate times a factor, plus what every job takes at least.
constexpr double time_factor = 3, memory_factor = 1.5;
constexpr double least_minutes = 10, least_megabytes = 512;

bool has_controls(const std::string& text) {
  return std::ranges::any_of(text, [](unsigned char c) { return std::iscntrl(c) != 0; });
}

/// Throws unless the folder's name is plain: it stands in lines that a cluster's programs read, and in a command that
/// the last job prints.
void require_plain(const fs::path& folder) {
  const std::string name = folder.string();
  if (has_controls(name) || name.find_first_of("'\"\\%") != std::string::npos)
    throw support::UsageError(fmt::format(
        "folder '{}' of the jobs (--folder with a name without quotes, backslashes, per cent signs and line breaks)",
        name));
}

/// A name that stands in a line of a script which a cluster's programs read.
CLI::Validator plain_name() {
  const auto objection = [](const std::string& text) {
    const bool is_plain = !has_controls(text) && text.find_first_of(" '\"\\#") == std::string::npos;
    return is_plain ? "" : fmt::format("'{}' (a name without blanks, line breaks, quotes, backslashes and #)", text);
  };
  return {objection, ""};
}

/// The same of an option with its value.
CLI::Validator option_in_a_line() {
  const auto objection = [](const std::string& text) {
    const bool is_plain = !has_controls(text) && text.starts_with('-');
    return is_plain ? "" : fmt::format("'{}' (an option such as --qos=long, in one line)", text);
  };
  return {objection, ""};
}

/// Throws where the store of all results is the folder of a submission, or one of the stores that it writes there.
void require_store_apart(const Submission& submission) {
  static const std::regex written(R"((costs|shard-\d+)\.db)");
  const fs::path db = fs::weakly_canonical(submission.db);
  if (db == fs::weakly_canonical(submission.folder / "submit.sh").parent_path())
    throw support::UsageError(fmt::format("--db {} is the folder of the submission, too (another name, or --folder)",
                                          submission.db.string()));
  if (std::regex_match(db.filename().string(), written) &&
      db == fs::weakly_canonical(submission.folder / db.filename()))
    throw support::UsageError(
        fmt::format("--db {} is a store that the submission in --folder {} writes for itself (another name, or folder)",
                    submission.db.string(), submission.folder.string()));
}

/// Puts the largest time and memory of the shards into the submission.
void ask_for(Submission& submission, const std::vector<plan::StudyPlan>& plans, const plan::CostModel& costs) {
  double seconds = 0, bytes = 0;
  for (const plan::Work& work : plan::split(plans, costs, submission.shards)) {
    const plan::Demand demand = plan::demand(plans, work, costs, submission.jobs);
    seconds = std::max(seconds, demand.seconds);
    bytes = std::max(bytes, demand.memory);
    submission.alone = submission.alone || !work.timed.empty();
  }
  submission.minutes = static_cast<std::size_t>(std::ceil(time_factor * seconds / 60 + least_minutes));
  submission.megabytes = static_cast<std::size_t>(std::ceil(memory_factor * 1e-6 * bytes + least_megabytes));
  print("{}, the longest about {} on {} and {:.0f} MB: asking for {} min and {} MB\n",
        count_text(submission.shards, "shard"), duration_text(seconds),
        count_text(static_cast<std::size_t>(submission.jobs), "job"), 1e-6 * bytes, submission.minutes,
        submission.megabytes);
}

/// Finds the folder of goldens that the studies are held against, and the names of the studies that have some.
void find_goldens(Submission& submission, const std::vector<plan::StudyPlan>& plans, const std::string& named) {
  std::vector<records::StudyResult> studies(plans.size());
  for (std::size_t k = 0; k < plans.size(); ++k) studies[k].name = plans[k].name, studies[k].text = plans[k].text;
  const fs::path folder = goldens_for(studies, named);
  const std::vector<goldens::Golden> goldens = goldens_in(folder, named);
  if (goldens.empty()) return;
  submission.goldens = fs::absolute(folder);
  for (const goldens::Golden& golden : goldens)
    if (std::ranges::count(plans, golden.study, &plan::StudyPlan::name) > 0 &&
        std::ranges::count(submission.gated, golden.study) == 0)
      submission.gated.push_back(golden.study);
}

Submission submission_of(const SubmitOptions& options) {
  Submission submission{
      .program = fs::read_symlink("/proc/self/exe"),
      .place = fs::current_path(),
      .folder = options.folder.empty() ? fs::path(options.db).replace_extension("shards") : fs::path(options.folder),
      .db = fs::absolute(options.db),
      .costs = {},
      .goldens = {},
      .files = {},
      .gated = {},
      .shards = options.shards,
      .jobs = options.jobs,
      .partition = options.partition,
      .account = options.account,
      .options = options.options};
  submission.folder = fs::absolute(submission.folder).lexically_normal();
  require_plain(submission.folder);
  for (const std::string& file : named_study_files(options.choice.names, options.choice.studies))
    submission.files.push_back(fs::absolute(file));
  return submission;
}

/// Copies the times by which the work is split: all shards must see the same ones, whatever the store takes meanwhile.
void freeze_costs(Submission& submission, const std::string& costs) {
  if (costs.empty()) return;
  submission.costs = submission.folder / "costs.db";
  if (std::error_code absent; fs::equivalent(costs, submission.costs, absent)) return;
  fs::remove(submission.costs);
  store::Store::merge(submission.costs, costs);
}

/// Has the jobs queued.
void start(const Submission& submission, const Engine& engine) {
  constexpr std::chrono::minutes limit{5};
  const fs::path script = submission.folder / "submit.sh";
  const Interruption interruption;
  const auto end = support::run_process({script}, submission.place, {}, limit, {}, interruption.token());
  if (end.good()) {
    print_text(end.output);
    return;
  }
  const std::string fault = submit_fault(script, end, limit, engine.queued);
  if (!end.stopped) throw support::UsageError(fault);
  note("stopped: {}\n", fault);
  end_interrupted();
}

int submit(const SubmitOptions& options) {
  const auto engine = std::ranges::find(engines(), options.engine, &Engine::name);
  if (!options.dry_run && support::program_on_path(engine->command).empty())
    throw support::UsageError(
        fmt::format("no {} on PATH, which {} submits with (a machine of the cluster that has it, "
                    "or --dry-run, which only writes the scripts)",
                    engine->command, options.engine));
  plan::CodeFinder codes(shipped("adapters"));
  const std::vector<plan::StudyPlan> plans = read_plans(options.choice, options.db, codes, AbsentCode::refused).plans;
  store::require_place(options.db);
  Submission submission = submission_of(options);
  require_store_apart(submission);
  std::optional<store::Store> learned;
  if (!options.costs.empty()) learned.emplace(options.costs, store::Store::Mode::read);
  ask_for(submission, plans, plan::CostModel(learned ? &*learned : nullptr));
  find_goldens(submission, plans, options.goldens);
  support::make_folder(submission.folder);
  freeze_costs(submission, options.costs);
  for (const Script& script : engine->scripts(submission)) {
    const fs::path file = submission.folder / script.name;
    support::write_if_changed(file, script.text);
    fs::permissions(file, fs::perms::owner_exec, fs::perm_options::add);
  }
  if (options.dry_run)
    print("written, not submitted: {}\n", (submission.folder / "submit.sh").string());
  else
    start(submission, *engine);
  return 0;
}

void add_demands(CLI::App& command, SubmitOptions& options) {
  command.add_option("--jobs", options.jobs, "cases at once on a machine, processors to ask for (default: 1)")
      ->check(from_to(1, 1024))
      ->type_name("NUMBER");
  command
      .add_option("--costs", options.costs,
                  "store whose times say how long cases take (default: guessed); copied into the folder")
      ->type_name("FILE");
  command.add_option("--partition", options.partition, "of the cluster")->check(plain_name())->type_name("NAME");
  command.add_option("--account", options.account, "whom it is charged to")->check(plain_name())->type_name("NAME");
  command
      .add_option("--option", options.options,
                  "option of every job, as the engine takes it: --option=--qos=long (repeatable)")
      ->allow_extra_args(false)
      ->check(option_in_a_line())
      ->type_name("OPTION");
}

}  // namespace

void add_submit(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SubmitOptions>();
  CLI::App* command = app.add_subcommand("submit", "Have a cluster run studies: shards, merge, gate, report");
  add_study_choice(*command, options->choice);
  std::vector<std::string> names;
  for (const Engine& engine : engines()) names.emplace_back(engine.name);
  command
      ->add_option("--engine", options->engine, fmt::format("what hands jobs to machines: {}", fmt::join(names, ", ")))
      ->required()
      ->check(one_of(names))
      ->type_name("WORD");
  command->add_option("--shards", options->shards, "how many jobs share the cases, 1 to 10000")
      ->required()
      ->check(from_to(1, 10'000))
      ->type_name("NUMBER");
  command->add_option("--db", options->db, "store that takes all results in the end")->required()->type_name("FILE");
  command
      ->add_option("--folder", options->folder,
                   "folder of scripts, shards, logs and report (default: beside --db, its name with .shards)")
      ->type_name("FOLDER");
  command->add_option("--goldens", options->goldens, fmt::format("folder of goldens ({})", default_goldens))
      ->type_name("FOLDER");
  add_demands(*command, *options);
  command->add_flag("--dry-run", options->dry_run, "write the scripts, submit nothing");
  add_examples(*command, {"mpmvv submit splines.toml --engine slurm --shards 4 --db cluster.db --dry-run"});
  command->callback([options, &exit_code] { exit_code = submit(*options); });
}

}  // namespace mpmvv::cli
