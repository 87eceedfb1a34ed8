#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "studies/codes/code.hpp"
#include "studies/codes/template_text.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::codes {

/// What went wrong with a command: status and reason of its case's record.
struct CommandFault : std::runtime_error {
  CommandFault(records::Status what, records::Failure whose, const std::string& reason)
      : std::runtime_error(reason), status(what), failure(whose) {}

  records::Status status;
  records::Failure failure;
};

/// The last lines of what a program wrote, in one.
std::string tail_of(const std::string& log);

/// Runs a command of the adapter in the folder; the seconds that it took. What it wrote is in `log.txt` there, and
/// added to the log. Nothing that it started goes on, but what has cleared its environment and left the group of the
/// command, and what runs as another user.
double run_command(const Code& code, const std::vector<std::string>& templates, const TemplateFields& fields,
                   const std::filesystem::path& folder, std::string& log);

/// Ends all commands that run, on whatever thread, with all that they have started; none can start any more.
void end_commands();

}  // namespace mpmvv::codes
