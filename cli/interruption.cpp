#include "cli/interruption.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include "cli/console.hpp"
#include "studies/support/process.hpp"

namespace mpmvv::cli {

namespace {

std::atomic<int> last_signal = 0;

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

/// Says so on standard error, unless that would have to wait for who reads it, or for a thread that is writing.
void say_at_once(const std::string& text) {
  pollfd messages{STDERR_FILENO, POLLOUT, 0};
  if (poll(&messages, 1, 0) != 1 || (messages.revents & POLLOUT) == 0) return;
  if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // there is nobody to tell
}

[[noreturn]] void end_program(const std::string& program) {
  const auto nobody_sees_them_end = support::kill_processes();
  const char* line_start = note_columns() ? "\r\033[K" : "";  // where a line of progress may stand
  say_at_once(fmt::format("{}stopped: {} was ended before it had finished\n", line_start, program));
  end_interrupted();
}

}  // namespace

Interrupts::Interrupts(std::string program) : program_(std::move(program)) {
  sigemptyset(&awaited_);
  sigaddset(&awaited_, SIGUSR1);  // the destructor sends it, so that the thread looks whether it has to end
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (!is_ignored(signal)) sigaddset(&awaited_, signal);
  pthread_sigmask(SIG_BLOCK, &awaited_, &before_);
  try {
    waiting_ = std::jthread([this](const std::stop_token& over) { wait_until(over); });
  } catch (const std::system_error&) {  // no thread is left for it: signals end the program, and nothing else
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
}

void Interrupts::wait_until(const std::stop_token& over) const {
  for (int signal = 0; !over.stop_requested();) {
    if (sigwait(&awaited_, &signal) != 0 || signal == SIGUSR1 || over.stop_requested()) continue;
    last_signal = signal;
    if (auto source = who_is_asked())
      source->request_stop();
    else
      end_program(program_);
  }
}

Interrupts::~Interrupts() {
  if (!waiting_.joinable()) return;
  waiting_.request_stop();
  pthread_kill(waiting_.native_handle(), SIGUSR1);
  waiting_.join();
  sigset_t left_over;
  sigemptyset(&left_over);
  sigaddset(&left_over, SIGUSR1);
  constexpr timespec at_once{};
  while (sigtimedwait(&left_over, nullptr, &at_once) > 0) {
  }
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

Interruption::Interruption() {
  set_asked(source_);
}

Interruption::~Interruption() {
  set_asked({});
}

void end_interrupted() {
  if (last_signal == SIGINT) {
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, SIGINT);
    std::signal(SIGINT, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
    raise(SIGINT);
  }
  constexpr int interrupted = 130;
  std::_Exit(interrupted);
}

}  // namespace mpmvv::cli
