#include "studies/codes/external_run.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <system_error>

#include "studies/codes/fields.hpp"
#include "studies/codes/output_files.hpp"
#include "studies/codes/run_command.hpp"
#include "studies/codes/run_folder.hpp"
#include "studies/codes/score.hpp"
#include "studies/problems/problem.hpp"
#include "studies/runs/rounds.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/reason.hpp"

namespace mpmvv::codes {

namespace fs = std::filesystem;
using cases::Case;
using records::Failure;
using records::Record;
using records::Status;

namespace {

void write_input_files(const Case& c, const Code& code, const fs::path& folder) {
  if (code.adapter.inputs.empty()) return;
  const TemplateFields fields = input_fields_of(c, code);
  for (const InputFile& input : code.adapter.inputs)
    support::write_if_changed(folder / input.file, filled_input(input, fields));
}

/// Reads what the code wrote. If it cannot be read, the UsageError also quotes the end of what the code printed.
Output output_of(const Case& c, const Code& code, const TemplateFields& fields, const fs::path& folder,
                 const std::string& log) {
  try {
    return read_output(c, code, fields, folder);
  } catch (const support::UsageError& e) {
    throw support::UsageError(fmt::format("{}; the code ended without an error: {}", e.what(), tail_of(log)));
  }
}

/// Runs the code on the case in this folder and returns the record of the scored output.
Record carry_out(const Case& c, const Code& code, const fs::path& folder) {
  write_input_files(c, code, folder);
  const TemplateFields fields = fields_of(c, code);
  std::string log;
  const double seconds = run_command(code, code.adapter.command, fields, folder, log);
  for (const auto& command : code.adapter.output.convert) run_command(code, command, fields, folder, log);
  Record record = score(c, output_of(c, code, fields, folder, log));
  record.wall_seconds = seconds;
  record.ns_per_particle_step = 1e9 * seconds / static_cast<double>(record.particles * record.steps);
  return record;
}

/// Returns the record of a run that did not come to its end.
Record without_end(const Case& c, Status status, Failure failure, const std::string& reason) {
  Record record;
  record.the_case = c;
  record.status = status;
  record.failure = failure;
  record.reason = reason;
  record.cfl = problems::cfl_number(c);
  return record;
}

void leave_out(const std::string& part, std::string& text) {
  for (std::size_t at; (at = text.find(part)) != std::string::npos;) text.erase(at, part.size());
}

bool is_full(const fs::path& folder) {
  constexpr std::uintmax_t little = 64 << 10;  // bytes
  std::error_code failed;
  return fs::space(folder, failed).available < little && !failed;
}

/// Keeps the folder of a failed run and adds its place to the record's reason. If the disk is full, the machine is at
/// fault.
void explain(RunFolder& folder, Record& record) {
  if (is_full(folder.path())) {
    record.failure = Failure::of_machine;
    record.reason += "; its disk is full (TMPDIR names another place for runs)";
  }
  try {
    record.reason += fmt::format("; its folder: {}", folder.keep().string());
  } catch (const support::WriteError& e) {  // for example because somebody has removed the folder
    record.reason += fmt::format("; {}", e.what());
  }
}

}  // namespace

Record run_external(const Case& c, const Code& code, const fs::path& keep) {
  RunFolder folder(keep);
  Record record;
  try {
    record = carry_out(c, code, folder.path());
  } catch (const CommandFault& fault) {
    record = without_end(c, fault.status, fault.failure, fault.what());
  } catch (const std::exception& e) {
    record = without_end(c, Status::failed, records::failure_of(e), support::reason_of(e));
  }
  leave_out(folder.path().string() + "/", record.reason);
  if (record.status == Status::failed) explain(folder, record);
  return record;
}

std::vector<Record> run_external_timed(const std::vector<Case>& cases, const Codes& codes) {
  const auto run = [&](const Case& c) { return run_external(c, codes.at(c.scheme.code)); };
  return runs::run_in_rounds(cases, run, run);
}

std::unique_lock<std::mutex> abandon_external_runs() {
  end_commands();
  return remove_run_folders();
}

}  // namespace mpmvv::codes
