#include "studies/codes/code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <sstream>

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

fs::path program_of(const Adapter& adapter) {
  const std::string& variable = adapter.program.variable;
  if (const char* named = std::getenv(variable.c_str()); named && *named != '\0') {
    const std::string text = named;
    fs::path file = text.find('/') == std::string::npos ? support::program_on_path(text) : fs::absolute(text);
    if (!support::is_program(file))
      throw UsageError(fmt::format("{}='{}' in the environment (a program that can be run: code '{}')", variable, text,
                                   adapter.name));
    return file;
  }
  const std::string& command = adapter.program.command;
  if (command.empty()) return {};
  if (command.find('/') == std::string::npos) return support::program_on_path(command);
  const fs::path file = fs::absolute(adapter.folder / command).lexically_normal();
  return support::is_program(file) ? file : fs::path();
}

/// As a word of a case's text.
std::string as_word(const std::string& version) {
  std::string word;
  for (const char c : version.substr(0, 60))
    word += std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("._+-", c) ? c : '_';
  return word;
}

std::string version_of(const Adapter& adapter, const fs::path& program) {
  if (adapter.program.version.empty())
    return "file-" + cases::fingerprint(support::require_file(program, fmt::format("code '{}'", adapter.name)));
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
    throw UsageError(
        fmt::format("code '{}' gives no version ({} should print it; or leave `version` out of its "
                    "adapter, and its file's digest counts)",
                    adapter.name, fmt::join(command, " ")));
  return as_word(last);
}

}  // namespace

std::optional<Code> find_code(const Adapter& adapter) {
  const fs::path program = program_of(adapter);
  if (program.empty()) return std::nullopt;
  return Code{adapter, program, version_of(adapter, program)};
}

std::string how_to_get(const Adapter& adapter) {
  return fmt::format("code '{}' is not there ({}=PROGRAM in the environment names it{})", adapter.name,
                     adapter.program.variable,
                     adapter.program.page.empty() ? "" : "; how to get it: " + adapter.program.page);
}

}  // namespace mpmvv::codes
