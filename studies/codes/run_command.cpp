#include "studies/codes/run_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <ranges>
#include <sstream>
#include <utility>

#include "studies/codes/fields.hpp"
#include "studies/support/file.hpp"
#include "studies/support/marked_processes.hpp"
#include "studies/support/process.hpp"

namespace mpmvv::codes {

namespace fs = std::filesystem;
using records::Failure;
using records::Status;

namespace {

template <class... T>
[[noreturn]] void fail_command(Failure whose, fmt::format_string<T...> format, T&&... values) {
  throw CommandFault(Status::failed, whose, fmt::format(format, std::forward<T>(values)...));
}

/// Whether the signal is one that a program does not raise by itself.
bool is_from_outside(int signal) {
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
}

void require_good(const Adapter& adapter, const std::string& program, const support::ProcessEnd& end) {
  if (end.start_error != 0)
    fail_command(Failure::of_case, "{} could not be started: {}", program, std::strerror(end.start_error));
  for (const std::string& text : adapter.unstable)
    if (end.output.find(text) != std::string::npos)
      throw CommandFault(Status::unstable, Failure::none, fmt::format("the code says: {}", text));
  const std::string said = tail_of(end.output);
  if (end.timed_out)
    fail_command(Failure::of_machine, "{} was killed at the time limit of {} s (time_limit of its adapter): {}",
                 program, static_cast<double>(adapter.time_limit.count()) / 1000, said);
  if (end.signal != 0)
    fail_command(is_from_outside(end.signal) ? Failure::of_machine : Failure::of_case,
                 "{} was ended by signal {} ({}): {}", program, end.signal, strsignal(end.signal), said);
  if (end.exit_code != 0) fail_command(Failure::of_case, "{} ended with status {}: {}", program, end.exit_code, said);
}

/// Returns the name of the environment variable that marks the processes of a run. Its value is the run's folder.
std::string run_mark() {
  return fmt::format("MPMVV_RUN_OF_{}", getpid());
}

/// Returns the lines of a text that have a letter or a digit, with one blank in the place of blanks and control
/// characters.
std::vector<std::string> telling_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) {
    const auto is_blank = [](unsigned char c) { return std::isspace(c) != 0 || std::iscntrl(c) != 0; };
    std::ranges::replace_if(line, is_blank, ' ');
    std::istringstream words(line);
    std::string squeezed;
    for (std::string word; words >> word;) squeezed += (squeezed.empty() ? "" : " ") + word;
    if (std::ranges::any_of(squeezed, [](unsigned char c) { return std::isalnum(c) != 0 || c >= 0x80; }))
      lines.push_back(squeezed);
  }
  return lines;
}

bool says_error(const std::string& line) {
  std::string lower = line;
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower.find("error") != std::string::npos;
}

/// Whether a byte goes on with a character of UTF-8 that has begun before it.
bool is_within_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;
}

/// Returns the first characters of a text, with three dots if there are more.
std::string beginning_of(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && is_within_character(text[most])) --most;
  return text.substr(0, most) + "...";
}

/// Returns the last characters of a text, after three dots if there are more.
std::string ending_of(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t begin = text.size() - most;
  while (begin < text.size() && is_within_character(text[begin])) ++begin;
  return "..." + text.substr(begin);
}

}  // namespace

std::string tail_of(const std::string& log) {
  constexpr std::size_t near = 2000, most = 400;
  const std::vector<std::string> lines = telling_lines(ending_of(log, near));
  std::string rest, from_error;  // from the first line with "error" from which all fits, else from the last such line
  for (const std::string& line : lines | std::views::reverse) {
    rest = line + (rest.empty() ? "" : " ") + rest;
    if (says_error(line) && (from_error.empty() || rest.size() <= most)) from_error = rest;
  }
  if (rest.empty()) return "it printed nothing";
  if (rest.size() <= most || from_error.empty()) return ending_of(rest, most);
  return "..." + beginning_of(from_error, most);
}

double run_command(const Code& code, const std::vector<std::string>& templates, const TemplateFields& fields,
                   const fs::path& folder, std::string& log) {
  const Adapter& adapter = code.adapter;
  std::vector<std::string> command;
  for (const std::string& word : templates) command.push_back(filled_word(word, fields, code));
  std::map<std::string, std::string> environment{{"OMP_NUM_THREADS", "1"}};
  for (const auto& [name, value] : adapter.environment) environment[name] = value;
  environment[run_mark()] = folder.string();
  const auto start = std::chrono::steady_clock::now();
  const support::ProcessEnd end = support::run_process(command, folder, environment, adapter.time_limit);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  support::kill_marked(run_mark(), folder.string());
  log += end.output;
  support::write_if_changed(folder / "log.txt", log);
  require_good(adapter, command.front(), end);
  return seconds;
}

void end_commands() {
  support::kill_processes();
  support::kill_marked(run_mark());
}

}  // namespace mpmvv::codes
