#include "cli/console.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "studies/support/error.hpp"

namespace mpmvv::cli {

namespace {

[[noreturn]] void fail_to_print() {
  if (errno == EPIPE) {  // nobody reads on, as behind `| head`: end as other programs do
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  throw support::UsageError(
      fmt::format("cannot write to standard output: {} (a place with room)", std::strerror(errno)));
}

/// Columns of the terminal that this stream is, if it is one.
std::optional<std::size_t> columns_of_terminal(int stream) {
  winsize size{};
  if (isatty(stream) == 0) return std::nullopt;
  const bool known = ioctl(stream, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

void print_text(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail_to_print();
}

void flush_text() {
  if (std::fflush(stdout) != 0) fail_to_print();
}

void note_text(const std::string& text) {
  std::fputs(text.c_str(), stderr);
}

std::optional<std::size_t> output_columns() {
  return columns_of_terminal(STDOUT_FILENO);
}

std::optional<std::size_t> note_columns() {
  return columns_of_terminal(STDERR_FILENO);
}

std::size_t text_width() {
  constexpr std::size_t least = 40;  // what stands indented needs some room
  return std::max(least, output_columns().value_or(100));
}

bool has_colours() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDOUT_FILENO) != 0 && !is_set("NO_COLOR") && terminal != nullptr && std::string(terminal) != "dumb";
}

std::string coloured_verdict(const std::string& word) {
  constexpr const char *green = "32", *red = "31", *yellow = "33";
  static const std::map<std::string, const char*> colours{
      {"pass", green},    {"holds", green},         {"confirmed", green}, {"ok", green},
      {"fail", red},      {"fails", red},           {"refuted", red},     {"failed", red},
      {"partly", yellow}, {"inconclusive", yellow}, {"unstable", yellow}};
  const std::size_t begin = word.find_first_not_of(' ');
  if (begin == std::string::npos) return word;
  const std::size_t end = std::min(word.find(' ', begin), word.size());
  const auto colour = colours.find(word.substr(begin, end - begin));
  if (colour == colours.end()) return word;
  return fmt::format("{}\033[{}m{}\033[0m{}", word.substr(0, begin), colour->second, colour->first, word.substr(end));
}

void print_json(const nlohmann::json& object) {
  constexpr bool only_ascii = true;  // no character that a terminal obeys
  print_text(object.dump(2, ' ', only_ascii, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace mpmvv::cli
