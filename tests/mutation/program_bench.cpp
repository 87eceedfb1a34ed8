#include "tests/mutation/program_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <future>
#include <utility>

#include "studies/support/error.hpp"
#include "tests/mutation/gate_output.hpp"
#include "tests/mutation/program_gate.hpp"

namespace mpmvv::mutation {

using support::ProcessEnd;
using support::UsageError;

namespace fs = std::filesystem;
using std::chrono::seconds;

namespace {

constexpr seconds build_limit = std::chrono::hours(6);
constexpr seconds gate_limit = std::chrono::hours(1);
constexpr int out_of_time = 128 + SIGXCPU;

/// The command under limits on its processor time, which does not depend on what else the machine does, and on its
/// memory (8 GiB).
std::vector<std::string> confined_command(seconds limit, const std::vector<std::string>& command) {
  std::vector<std::string> confined{"prlimit", "--as=8589934592",
                                    fmt::format("--cpu={}:{}", limit.count(), limit.count() + 10)};
  confined.insert(confined.end(), command.begin(), command.end());
  return confined;
}

/// Studies that are far too large to run for every mutant.
const std::vector<std::string> cubes{"s-fig12"};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string how_it_ended(const support::ProcessEnd& end, seconds limit) {
  if (end.timed_out || end.exit_code == out_of_time) return fmt::format("not at its end after {} s", limit.count());
  return end.exit_code > 128 ? fmt::format("ended by signal {}", end.exit_code - 128)
                             : fmt::format("exit code {}", end.exit_code);
}

std::string last_lines(const std::string& output) {
  constexpr std::size_t most = 2000;
  return output.substr(output.size() > most ? output.size() - most : 0);
}

}  // namespace

ProgramBench::ProgramBench(ScratchTree& scratch, int jobs)
    : scratch_(scratch), jobs_(jobs), quick_(listed_studies(scratch.text("studies/quick.txt"))) {
  const auto is_in = [](const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
  };
  for (const std::string& name : studies_with_goldens(scratch.files()))
    if (!is_in(quick_, name) && !is_in(cubes, name)) nightly_.push_back(name);
}

void ProgramBench::configure() const {
  if (fs::exists(scratch_.build() / "build.ninja")) return;
  const support::ProcessEnd end = scratch_.run(
      {"cmake", "--preset", "mutants", "-B", scratch_.build().string(), "--log-level=WARNING"}, build_limit);
  if (!end.good())
    throw support::UsageError(fmt::format("cmake cannot configure {}: {}", scratch_.tree().string(), end.output));
}

support::ProcessEnd ProgramBench::make(const std::vector<std::string>& targets) const {
  std::vector<std::string> command{"cmake",   "--build", scratch_.build().string(), "--parallel", std::to_string(jobs_),
                                   "--target"};
  command.insert(command.end(), targets.begin(), targets.end());
  return scratch_.run(command, build_limit);
}

/// Whether a target compiles. Throws when the compiler ended without finding an error: that says nothing about the
/// mutant.
bool ProgramBench::compiles(const std::string& target) {
  const support::ProcessEnd end = make({target});
  if (end.good()) return true;
  complaint_ = last_lines(end.output);
  const bool is_error = end.output.find(" error: ") != std::string::npos;
  const bool is_killed = end.output.find("Killed signal") != std::string::npos;
  if (!is_error || is_killed)
    throw support::UsageError(fmt::format("cannot build {}: {} (memory and disk for a compiler)", target, complaint_));
  return false;
}

void ProgramBench::reach_for(const Edit* edit) {
  tests_ = test_programs(edit ? edit->file : "");
  is_edited_ = edit != nullptr;
  decides_the_gate_ = edit == nullptr || decides_the_gate(edit->file);
}

bool ProgramBench::build(const Edit* edit) {
  reach_for(edit);
  chosen_ = 0;
  if (edit)
    scratch_.apply(*edit);
  else
    scratch_.undo();
  configure();
  return compiles("mpmvv");
}

std::vector<int> ProgramBench::build(const std::vector<Choice>& choices) {
  std::map<std::string, std::vector<Choice>> by_file;
  for (const Choice& choice : choices) by_file[choice.edit.file].push_back(choice);
  std::map<std::string, std::string> texts{{choice_header, choice_header_text()}};
  std::map<std::string, std::vector<ChoicePlace>> places;
  std::vector<int> numbers;
  for (const auto& [file, of_file] : by_file) {
    Schemata both = schemata_of(scratch_.text(file), of_file);
    if (both.places.empty()) continue;
    for (const ChoicePlace& place : both.places) numbers.push_back(place.number);
    texts[file] = std::move(both.text);
    places[file] = std::move(both.places);
  }
  if (numbers.empty()) return {};
  scratch_.apply(texts);
  configure();
  std::vector<std::string> targets = test_programs("");
  targets.insert(targets.begin(), "mpmvv");
  const support::ProcessEnd end = make(targets);
  if (end.good()) return numbers;
  complaint_ = last_lines(end.output);
  const std::set<int> bad = choices_named(end.output, places);
  if (bad.empty()) return {};
  std::vector<Choice> left = choices;
  std::erase_if(left, [&](const Choice& choice) { return bad.contains(choice.number); });
  return build(left);
}

void ProgramBench::choose(const Choice* choice) {
  reach_for(choice ? &choice->edit : nullptr);
  chosen_ = choice ? choice->number : 0;
}

Trial ProgramBench::meet(GateStage stage, seconds limit) {
  if (stage != GateStage::unit_tests && !decides_the_gate_) return {.stage = stage};
  const auto start = std::chrono::steady_clock::now();
  Trial trial = stage == GateStage::unit_tests ? run_unit_tests(limit)
                : stage == GateStage::quick    ? run_gate(stage, quick_, limit)
                                               : run_gate(stage, nightly_, limit);
  trial.seconds = seconds_since(start);
  return trial;
}

support::ProcessEnd ProgramBench::run(const std::vector<std::string>& command, seconds limit,
                                      std::map<std::string, std::string> environment,
                                      const std::stop_token& stop) const {
  environment[choice_variable] = std::to_string(chosen_);
  return scratch_.run(command, limit, environment, stop);
}

seconds ProgramBench::limit_of(const std::string& name, seconds stage_limit) const {
  const auto usual = usual_.find(name);
  if (!is_edited_ || usual == usual_.end()) return stage_limit;
  return std::min(stage_limit, seconds(std::lround(30 + 5 * usual->second)));
}

void ProgramBench::learn(const std::string& name, const ProcessEnd& end, double took) {
  if (!is_edited_ && end.good()) usual_[name] = took;
}

/// Runs a command under limits on processor time and on wall time: a program that waits for ever takes no processor
/// time.
support::ProcessEnd ProgramBench::run_confined(const std::vector<std::string>& command, seconds limit,
                                               std::map<std::string, std::string> environment,
                                               const std::stop_token& stop) const {
  return run(confined_command(jobs_ * limit, command), 20 * limit, std::move(environment), stop);
}

/// The first part that does not pass stops the others.
support::ProcessEnd ProgramBench::run_test(const std::string& test, seconds limit) {
  const auto start = std::chrono::steady_clock::now();
  std::stop_source stop;
  const auto part = [&](int k) {
    ProcessEnd end = run_confined(
        {program(test), "--gtest_fail_fast", "--gtest_color=no", "--gtest_filter=-*Nightly*"}, limit,
        {{"GTEST_TOTAL_SHARDS", std::to_string(jobs_)}, {"GTEST_SHARD_INDEX", std::to_string(k)}}, stop.get_token());
    if (!end.good()) stop.request_stop();
    return end;
  };
  std::vector<std::future<ProcessEnd>> parts;
  for (int k = 0; k < jobs_; ++k) parts.push_back(std::async(std::launch::async, part, k));
  ProcessEnd end;
  for (auto& one : parts)
    if (const ProcessEnd its = one.get(); end.good() && !its.stopped) end = its;
  learn(test, end, seconds_since(start));
  return end;
}

/// Test programs are built one by one: most mistakes need no more than the first.
Trial ProgramBench::run_unit_tests(seconds stage_limit) {
  Trial trial{.stage = GateStage::unit_tests};
  for (const std::string& test : tests_) {
    if (!compiles(test)) {
      trial.caught = true;
      trial.by = {test + ": does not compile"};
      return trial;
    }
    const seconds limit = limit_of(test, stage_limit);
    const support::ProcessEnd end = run_test(test, limit);
    if (end.good()) continue;
    trial.caught = true;
    const std::string ending =
        end.exit_code == 1 && !end.timed_out ? "" : fmt::format(" ({})", how_it_ended(end, limit));
    trial.by = {fmt::format("{}: {}{}", test, failed_test(end.output), ending)};
    return trial;
  }
  return trial;
}

Trial ProgramBench::run_gate(GateStage stage, const std::vector<std::string>& studies, seconds stage_limit) {
  const std::string db = (scratch_.build() / (to_string(stage) + ".db")).string();
  fs::remove(db);
  fs::remove(db + "-journal");
  return first_catch(stage, studies, [&](const std::string& study) { return complaints_of(study, db, stage_limit); });
}

std::vector<std::string> ProgramBench::complaints_of(const std::string& study, const std::string& db,
                                                     seconds stage_limit) {
  const seconds limit = limit_of(study, stage_limit);
  const auto start = std::chrono::steady_clock::now();
  const support::ProcessEnd ran = run_confined(
      {program("mpmvv"), "study", "--db", db, "--jobs", std::to_string(jobs_), fmt::format("studies/{}.toml", study)},
      limit);
  learn(study, ran, seconds_since(start));
  const std::string ending = fmt::format("{}: {}", study, how_it_ended(ran, limit));
  if (ran.timed_out || ran.exit_code > 1) return {ending};
  const support::ProcessEnd judged = run({program("mpmvv"), "gate", "--db", db, "--json", "--only", study}, gate_limit);
  if (ran.good() && judged.good()) return {};
  const auto goldens = goldens_not_passed(judged.output);
  return goldens.empty() ? std::vector{ending} : goldens;
}

}  // namespace mpmvv::mutation
