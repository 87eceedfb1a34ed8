#include "studies/codes/run_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
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

}  // namespace

std::string tail_of(const std::string& log) {
  constexpr std::size_t most = 300;
  std::string text = log.size() > most ? "..." + log.substr(log.size() - most) : log;
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  std::ranges::replace_if(
      text, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, ' ');
  return text.empty() ? "it printed nothing" : text;
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
