#pragma once
#include <csignal>
#include <stop_token>
#include <thread>

namespace mpmvv::cli {

/// While it lives, an interrupt from the keyboard (SIGINT), a request to end (SIGTERM) or the end of the terminal
/// (SIGHUP) asks to stop instead of ending the program at once; those that the program was started to ignore stay
/// ignored. SIGUSR1, which schedulers of clusters send as well, changes nothing. Threads must be started after it: they
/// inherit that the signals are blocked.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  std::stop_token token() const { return source_.get_token(); }

 private:
  sigset_t awaited_{}, before_{};
  std::stop_source source_;
  std::jthread waiting_;
};

}  // namespace mpmvv::cli
