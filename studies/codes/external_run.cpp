#include "studies/codes/external_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "studies/codes/fields.hpp"
#include "studies/codes/output_files.hpp"
#include "studies/codes/run_folder.hpp"
#include "studies/codes/score.hpp"
#include "studies/runs/rounds.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/process.hpp"
#include "studies/support/reason.hpp"

namespace mpmvv::codes {

namespace fs = std::filesystem;
using cases::Case;
using records::Record;
using records::Status;

namespace {

/// The last lines of what a program wrote, in one.
std::string tail_of(const std::string& log) {
  constexpr std::size_t most = 300;
  std::string text = log.size() > most ? "..." + log.substr(log.size() - most) : log;
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  std::ranges::replace_if(
      text, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, ' ');
  return text.empty() ? "it wrote nothing" : text;
}

/// What went wrong with a command.
struct CommandFault : std::runtime_error {
  CommandFault(Status what, const std::string& reason) : std::runtime_error(reason), status(what) {}

  Status status;
};

void require_good(const Adapter& adapter, const std::string& program, const support::ProcessEnd& end) {
  if (end.start_error != 0)
    throw CommandFault(Status::failed,
                       fmt::format("{} could not be started: {}", program, std::strerror(end.start_error)));
  for (const std::string& text : adapter.unstable)
    if (end.output.find(text) != std::string::npos)
      throw CommandFault(Status::unstable, fmt::format("the code says: {}", text));
  if (end.timed_out)
    throw CommandFault(Status::failed,
                       fmt::format("{} was killed at the time limit of {} s: {}", program,
                                   static_cast<double>(adapter.time_limit.count()) / 1000, tail_of(end.output)));
  if (end.exit_code != 0)
    throw CommandFault(Status::failed,
                       fmt::format("{} ended with status {}: {}", program, end.exit_code, tail_of(end.output)));
}

/// Runs a command of the adapter in the folder; the seconds that it took. What it wrote is in `log.txt` there.
double run_command(const Code& code, const std::vector<std::string>& templates, const TemplateFields& fields,
                   const fs::path& folder, std::string& log) {
  const Adapter& adapter = code.adapter;
  std::vector<std::string> command;
  for (const std::string& word : templates) command.push_back(filled_word(word, fields, code));
  std::map<std::string, std::string> environment{{"OMP_NUM_THREADS", "1"}};
  for (const auto& [name, value] : adapter.environment) environment[name] = value;
  const auto start = std::chrono::steady_clock::now();
  const support::ProcessEnd end = support::run_process(command, folder, environment, adapter.time_limit);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  log += end.output;
  support::write_if_changed(folder / "log.txt", log);
  require_good(adapter, command.front(), end);
  return seconds;
}

void write_input_files(const Case& c, const Code& code, const fs::path& folder) {
  if (code.adapter.inputs.empty()) return;
  const TemplateFields fields = input_fields_of(c, code);
  for (const InputFile& input : code.adapter.inputs)
    support::write_if_changed(folder / input.file, filled_input(input, fields));
}

/// The record of what the code makes of the case in this folder.
Record carry_out(const Case& c, const Code& code, const fs::path& folder) {
  write_input_files(c, code, folder);
  const TemplateFields fields = fields_of(c, code);
  std::string log;
  const double seconds = run_command(code, code.adapter.command, fields, folder, log);
  for (const auto& command : code.adapter.output.convert) run_command(code, command, fields, folder, log);
  Record record = score(c, read_output(c, code, fields, folder));
  record.wall_seconds = seconds;
  record.ns_per_particle_step = 1e9 * seconds / static_cast<double>(record.particles * record.steps);
  return record;
}

/// The record of a case that did not come to its end.
Record without_end(const Case& c, Status status, const std::string& reason) {
  Record record;
  record.the_case = c;
  record.status = status;
  record.failure = status == Status::failed ? records::Failure::of_case : records::Failure::none;
  record.reason = reason;
  record.cfl = problems::cfl_number(c);
  return record;
}

}  // namespace

Record run_external(const Case& c, const Code& code, const fs::path& keep) {
  RunFolder folder(keep);
  Record record;
  try {
    record = carry_out(c, code, folder.path());
  } catch (const CommandFault& fault) {
    record = without_end(c, fault.status, fault.what());
  } catch (const std::exception& e) {
    record = without_end(c, Status::failed, support::reason_of(e));
    record.failure = records::failure_of(e);
  }
  if (record.status == Status::failed) record.reason += fmt::format("; its folder: {}", folder.keep().string());
  return record;
}

std::vector<Record> run_external_timed(const std::vector<Case>& cases, const Codes& codes) {
  return runs::run_in_rounds(cases, [&](const Case& c) { return run_external(c, codes.at(c.scheme.code)); });
}

void abandon_external_runs() {
  support::kill_processes();
  remove_run_folders();
}

}  // namespace mpmvv::codes
