#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>

#include "cli/case_options.hpp"
#include "cli/checks.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/interruption.hpp"
#include "cli/progress_line.hpp"
#include "cli/record_json.hpp"
#include "cli/run_text.hpp"
#include "cli/shipped.hpp"
#include "studies/codes/external_run.hpp"
#include "studies/codes/fields.hpp"
#include "studies/plan/external_series.hpp"
#include "studies/runs/run_case.hpp"
#include "studies/runs/run_part.hpp"
#include "studies/settings/part.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using support::UsageError;

namespace {

struct RunOptions {
  CaseOptions of_case;
  bool json = false;
  int threads = 1;
  std::string vtu, keep;
};

/// Refuses options that only runs of our own solver have, or that go with a single run alone.
void require_options_of_code(const RunOptions& options, const cases::Case& c) {
  const std::string& code = c.scheme.code;
  if (options.threads > 1) throw UsageError(fmt::format("--threads for code '{}' (it takes one)", code));
  if (c.measure.repeat > 0 && !options.keep.empty())
    throw UsageError("--keep beside --repeat (each repetition has a folder of its own; run twice)");
  if (!options.vtu.empty())
    throw UsageError(fmt::format("--vtu for code '{}' (what it writes itself is kept with --keep FOLDER)", code));
}

[[noreturn]] void stop(const std::string& what, const std::string& folder) {
  note("stopped: {} was ended before it had finished{}\n", what,
       folder.empty() ? "" : fmt::format("; what it had written is in {}", folder));
  end_interrupted();
}

/// The record of a case that another code runs. An interrupt ends that code, too.
records::Record run_by_other_code(const std::vector<settings::Setting>& given, const RunOptions& options) {
  std::vector<settings::Setting> settings = given;
  plan::CodeFinder finder(shipped("adapters"));
  const std::string absent = finder.complete(settings, ".");
  const cases::Case c = settings::make_case(settings);
  require_options_of_code(options, c);
  if (!absent.empty()) throw UsageError(absent);
  const codes::Code& code = finder.codes().at(c.scheme.code);
  codes::require_able(code.adapter, c);
  codes::require_sound_templates(c, code);
  const Interruption interruption;
  const std::stop_callback on_stop(interruption.token(), [&] {
    const auto no_more_runs = codes::abandon_external_runs();
    stop(c.scheme.code, options.keep);
  });
  if (c.measure.repeat > 0) {
    const codes::Codes& all = finder.codes();
    return codes::time_in_rounds({codes::run_untimed(c, all)}, all).front();
  }
  return codes::run_external(c, code, options.keep);
}

/// Tells the line a few times a second how far the steps have come; nothing where there is no line.
std::function<void(std::int64_t)> step_listener(ProgressLine& line, const cases::Case& c) {
  using Clock = std::chrono::steady_clock;
  const auto tell = line.listener();
  if (!tell) return {};
  return [tell, all = c.resolution.steps, what = "steps of " + c.problem.name, start = Clock::now(),
          told = Clock::now()](std::int64_t steps) mutable {
    const Clock::time_point now = Clock::now();
    if (now - told < std::chrono::milliseconds(250)) return;
    told = now;
    const double spent = std::chrono::duration<double>(now - start).count();
    const double left = spent * static_cast<double>(all - steps) / static_cast<double>(steps);
    tell({.done = static_cast<std::size_t>(steps),
          .total = static_cast<std::size_t>(all),
          .seconds_left = left,
          .label = what});
  };
}

records::Record run_by_own_solver(const std::vector<settings::Setting>& settings, const RunOptions& options) {
  const cases::Case c = settings::make_case(settings);
  if (!options.keep.empty())
    throw UsageError("--keep without --code (our own solver's runs have no folder; --vtu FOLDER writes states)");
  if (c.measure.repeat > 0 && options.threads > 1)
    throw UsageError("--threads beside --repeat (cost is measured on one thread)");
  if (c.measure.repeat > 0 && !options.vtu.empty())
    throw UsageError("--vtu beside --repeat (cost is measured without writing; run twice)");
  const Interruption interruption;
  ProgressLine line;
  const auto tell_steps = step_listener(line, c);
  const std::stop_callback on_stop(interruption.token(), [&] {
    line.clear();
    stop("the run of " + c.problem.name, options.vtu);
  });
  if (const auto part = settings::part_of(c); part && options.vtu.empty())
    if (const auto record = runs::run_part(c, *part, options.threads, tell_steps)) return *record;
  return runs::run_case(c, options.threads, {.vtu = options.vtu, .steps = tell_steps});
}

int run(const RunOptions& options) {
  const std::vector<settings::Setting> settings = options.of_case.settings();
  const bool is_other = std::ranges::find(settings, "code", &settings::Setting::key) != settings.end();
  const records::Record record = is_other ? run_by_other_code(settings, options) : run_by_own_solver(settings, options);
  if (options.json)
    print_json(record_json(record));
  else
    print_record(record);
  return record.status == records::Status::failed ? 1 : 0;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Run one case and print its record");
  options->of_case.add_to(*command);
  command->add_option("--threads", options->threads, "threads of the step, 1 to 256 (default: 1)")
      ->check(from_to(1, 256))
      ->type_name("NUMBER");
  command->add_option("--vtu", options->vtu, "write eleven particle states for ParaView to this folder")
      ->type_name("FOLDER");
  command
      ->add_option("--keep", options->keep, "run another code in this folder, new or empty, and leave all files there")
      ->type_name("FOLDER");
  command->add_flag("--json", options->json, "print the record as one JSON object");
  add_examples(*command,
               {"mpmvv run --problem bar --basis bspline2 --integrator cd --cells 64 --ppc 4 --cfl 0.2",
                "mpmvv run --problem square --basis cpgimp --boundary mirror --cells 32 --ppc 2 --cfl 0.4 --json",
                "mpmvv run --problem ring --basis cpdi --cells 16 --ppc 2 --cfl 0.4 --vtu frames"});
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mpmvv::cli
