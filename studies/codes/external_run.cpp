#include "studies/codes/external_run.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <set>
#include <system_error>

#include "studies/codes/fields.hpp"
#include "studies/codes/output_files.hpp"
#include "studies/codes/run_command.hpp"
#include "studies/codes/run_folder.hpp"
#include "studies/codes/score.hpp"
#include "studies/problems/problem.hpp"
#include "studies/runs/rounds.hpp"
#include "studies/runs/run_case.hpp"
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
  const std::vector<std::string> texts = input_texts(c, code);
  for (std::size_t k = 0; k < texts.size(); ++k)
    support::write_if_changed(folder / code.adapter.inputs[k].file, texts[k]);
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

/// Sets what one step cost. It is not measured where the number of steps is unknown.
void set_cost_of_step(Record& record) {
  const std::int64_t all = record.particles * record.steps;
  record.ns_per_particle_step = all > 0 ? 1e9 * record.wall_seconds / static_cast<double>(all) : records::not_measured;
}

/// Runs the code on the case in this folder and returns the record of the scored output.
Record carry_out(const Case& c, const Code& code, const fs::path& folder) {
  write_input_files(c, code, folder);
  const TemplateFields fields = fields_of(c, code);
  std::string log;
  const double seconds = run_command(code, code.adapter.command, fields, folder, log);
  for (const auto& command : code.adapter.output.convert) run_command(code, command, fields, folder, log);
  Record record = score(c, code.adapter.stepping, output_of(c, code, fields, folder, log));
  if (record.status == Status::failed)
    record.reason += fmt::format("; the code ended without an error: {}", tail_of(log));
  record.wall_seconds = seconds;
  set_cost_of_step(record);
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
  if (!code.adapter.stepping.is_given) record.cfl = records::not_measured;
  leave_out(folder.path().string() + "/", record.reason);
  if (record.status == Status::failed) explain(folder, record);
  return record;
}

Record run_untimed(const Case& c, const Codes& codes) {
  return c.scheme.code.empty() ? runs::run_untimed(c) : run_external(c, codes.at(c.scheme.code));
}

std::vector<Record> time_in_rounds(std::vector<Record> records, const Codes& codes) {
  std::set<Case> of_unknown_steps;  // their cost is measured as if each were one step
  const auto count_one = [&](Record& r) {
    if (r.status != Status::ok || r.steps > 0) return;
    of_unknown_steps.insert(r.the_case);
    r.steps = 1;
    set_cost_of_step(r);
  };
  const auto run_again = [&](const Case& c) {
    if (c.scheme.code.empty()) return runs::time_steps(c);
    Record record = run_external(c, codes.at(c.scheme.code));
    count_one(record);
    return record;
  };
  for (Record& record : records) count_one(record);
  records = runs::time_in_rounds(std::move(records), run_again);
  for (Record& record : records) {
    if (!of_unknown_steps.contains(record.the_case)) continue;
    record.steps = 0;
    set_cost_of_step(record);
  }
  return records;
}

std::unique_lock<std::mutex> abandon_external_runs() {
  end_commands();
  return remove_run_folders();
}

}  // namespace mpmvv::codes
