#include "cli/interruption.hpp"

#include <pthread.h>

#include <cstdlib>
#include <mutex>
#include <optional>
#include <utility>

#include "cli/console.hpp"
#include "studies/support/process.hpp"

namespace mpmvv::cli {

namespace {

/// Whom an interrupt asks to stop, if anybody wants to be asked.
struct Asked {
  std::mutex mutex;
  std::optional<std::stop_source> source;
};

Asked& asked() {
  static Asked one;
  return one;
}

void set_asked(std::optional<std::stop_source> source) {
  const std::lock_guard lock(asked().mutex);
  asked().source = std::move(source);
}

std::optional<std::stop_source> who_is_asked() {
  const std::lock_guard lock(asked().mutex);
  return asked().source;
}

bool is_ignored(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

[[noreturn]] void end_program(const std::string& program) {
  const auto nobody_sees_them_end = support::kill_processes();
  if (note_columns()) note_text("\r\033[K");  // where a line of progress may stand
  note("stopped: {} was ended before it had finished\n", program);
  std::_Exit(interrupted);
}

}  // namespace

Interrupts::Interrupts(std::string program) : program_(std::move(program)) {
  sigemptyset(&awaited_);
  sigaddset(&awaited_, SIGUSR1);  // the destructor sends it, so that the thread looks whether it has to end
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (!is_ignored(signal)) sigaddset(&awaited_, signal);
  pthread_sigmask(SIG_BLOCK, &awaited_, &before_);
  waiting_ = std::jthread([this](const std::stop_token& over) {
    for (int signal = 0; !over.stop_requested();) {
      if (sigwait(&awaited_, &signal) != 0 || signal == SIGUSR1) continue;
      if (auto source = who_is_asked())
        source->request_stop();
      else
        end_program(program_);
    }
  });
}

Interrupts::~Interrupts() {
  waiting_.request_stop();
  pthread_kill(waiting_.native_handle(), SIGUSR1);
  waiting_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

Interruption::Interruption() {
  set_asked(source_);
}

Interruption::~Interruption() {
  set_asked({});
}

}  // namespace mpmvv::cli
