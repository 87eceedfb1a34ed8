#include "cli/console.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "studies/support/error.hpp"

namespace mpmvv::cli {

namespace {

[[noreturn]] void fail_to_print() {
  if (errno == EPIPE) {  // nobody reads on, as behind `| head`: ends as programs do
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  throw support::UsageError(
      fmt::format("cannot write to standard output: {} (a place with room)", std::strerror(errno)));
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

void print_json(const nlohmann::json& object) {
  constexpr bool only_ascii = true;  // no character that a terminal obeys
  print_text(object.dump(2, ' ', only_ascii, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace mpmvv::cli
