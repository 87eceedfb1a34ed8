#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "studies/codes/code.hpp"
#include "studies/codes/template_text.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::codes {

/// A command that went wrong: status, failure and reason for the record of its case.
struct CommandFault : std::runtime_error {
  CommandFault(records::Status what, records::Failure whose, const std::string& reason)
      : std::runtime_error(reason), status(what), failure(whose) {}

  records::Status status;
  records::Failure failure;
};

/// Returns the end of what a program printed, about 400 characters at most, on one line. Lines without a letter or
/// digit are left out. Where not all of it fits, it begins at a line with "error", if there is one near the end.
std::string tail_of(const std::string& log);

/// Runs a command of the adapter in the folder and returns the seconds that it took. Appends what it printed to `log`
/// and writes the log to `log.txt` in the folder. Kills all processes that the command has started, except those that
/// have cleared their environment and left its process group, and those of another user. Throws CommandFault if the
/// command could not be started, printed a text of the adapter's `unstable`, reached the time limit, was ended by a
/// signal or ended with a status other than 0.
double run_command(const Code& code, const std::vector<std::string>& templates, const TemplateFields& fields,
                   const std::filesystem::path& folder, std::string& log);

/// Kills all commands that run, on whatever thread, with all that they have started. No command can run after this.
void end_commands();

}  // namespace mpmvv::codes
