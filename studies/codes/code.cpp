#include "studies/codes/code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "studies/codes/run_command.hpp"
#include "studies/codes/run_folder.hpp"
#include "studies/codes/template_text.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/process.hpp"
#include "studies/support/program.hpp"

namespace mpmvv::codes {

namespace fs = std::filesystem;
using support::UsageError;

namespace {

/// Says why the program that the environment variable names cannot be run.
std::string why_not_run(const std::string& text) {
  if (fs::is_regular_file(text))
    return text.find('/') == std::string::npos ? "a file here is ./" + text : "it is not executable, chmod +x";
  if (text.find(' ') != std::string::npos) return "its name alone; arguments stand in argv of its adapter";
  return text.find('/') == std::string::npos ? "it is not on PATH" : "there is no such file";
}

fs::path program_of(const Adapter& adapter) {
  const std::string& variable = adapter.program.variable;
  if (const char* named = std::getenv(variable.c_str()); named && *named != '\0') {
    const std::string text = named;
    fs::path file = text.find('/') == std::string::npos ? support::program_on_path(text) : fs::absolute(text);
    if (!support::is_program(file))
      throw UsageError(fmt::format("{}='{}' in the environment for code '{}' (a program that can be run: {})", variable,
                                   text, adapter.name, why_not_run(text)));
    return file;
  }
  const std::string& command = adapter.program.command;
  if (command.empty()) return {};
  if (command.find('/') == std::string::npos) return support::program_on_path(command);
  const fs::path file = fs::absolute(adapter.folder / command).lexically_normal();
  return support::is_program(file) ? file : fs::path();
}

/// Returns the version as one word of a case's text: cut to 60 characters, with _ for all but letters, digits and ._+-
std::string as_word(const std::string& version) {
  std::string word;
  for (const char c : version.substr(0, 60))
    word += std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("._+-", c) ? c : '_';
  return word;
}

std::string why_no_version(const support::ProcessEnd& end) {
  if (end.start_error != 0) return fmt::format("could not be started: {}", std::strerror(end.start_error));
  if (end.timed_out) return "did not end in time";
  if (end.exit_code != 0) return fmt::format("ended with status {}: {}", end.exit_code, tail_of(end.output));
  return "printed nothing";
}

std::string version_of(const Adapter& adapter, const fs::path& program, const std::string& content) {
  if (adapter.program.version.empty()) return "file-" + cases::fingerprint(content);
  TemplateFields fields;
  fields.set("program", program.string());
  std::vector<std::string> command;
  for (const std::string& word : adapter.program.version)
    command.push_back(filled(word, fields, fmt::format("version of code '{}'", adapter.name)));
  constexpr std::chrono::seconds limit{20};
  const support::ProcessEnd end = support::run_process(command, place_of_runs(), {}, limit);
  std::istringstream words(end.output);
  std::string last;
  for (std::string word; words >> word;) last = word;
  if (!end.good() || last.empty())
    throw UsageError(fmt::format("code '{}' gives no version: {} {} (the version as its last word, within {} s)",
                                 adapter.name, fmt::join(command, " "), why_no_version(end), limit.count()));
  return as_word(last);
}

}  // namespace

std::optional<Code> find_code(const Adapter& adapter) {
  const fs::path program = program_of(adapter);
  if (program.empty()) return std::nullopt;
  const std::string content =  // a program that can be run need not be readable
      adapter.program.version.empty() ? support::require_file(program, fmt::format("code '{}'", adapter.name))
                                      : support::read_file(program).value_or("");
  return Code{adapter, program, version_of(adapter, program, content), cases::fingerprint(adapter.digest + content)};
}

std::string how_to_get(const Adapter& adapter) {
  return fmt::format("code '{}' is not there ({}=PROGRAM in the environment names it{})", adapter.name,
                     adapter.program.variable,
                     adapter.program.page.empty() ? "" : "; how to get it: " + adapter.program.page);
}

}  // namespace mpmvv::codes
