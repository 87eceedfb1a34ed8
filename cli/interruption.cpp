#include "cli/interruption.hpp"

#include <pthread.h>

namespace mpmvv::cli {

namespace {

bool is_ignored(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

}  // namespace

Interruption::Interruption() {
  sigemptyset(&awaited_);
  sigaddset(&awaited_, SIGUSR1);  // the destructor sends it, so that the thread looks whether it has to end
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (!is_ignored(signal)) sigaddset(&awaited_, signal);
  pthread_sigmask(SIG_BLOCK, &awaited_, &before_);
  waiting_ = std::jthread([this](const std::stop_token& end) {
    for (int signal = 0; !end.stop_requested();)
      if (sigwait(&awaited_, &signal) == 0 && signal != SIGUSR1) source_.request_stop();
  });
}

Interruption::~Interruption() {
  waiting_.request_stop();
  pthread_kill(waiting_.native_handle(), SIGUSR1);
  waiting_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace mpmvv::cli
