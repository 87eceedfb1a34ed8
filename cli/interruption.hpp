#pragma once
#include <csignal>
#include <stop_token>
#include <string>
#include <thread>

namespace mpmvv::cli {

/// While it lives, an interrupt from the keyboard (SIGINT), a request to end (SIGTERM) or the end of the terminal
/// (SIGHUP) ends the program with a line that says so, and kills what it has started; those that the program was
/// started to ignore stay ignored. SIGUSR1, which schedulers of clusters send as well, changes nothing. A program has
/// one, made before its threads: they inherit that the signals are blocked.
class Interrupts {
 public:
  explicit Interrupts(std::string program);
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

 private:
  void wait_until(const std::stop_token& over) const;

  std::string program_;
  sigset_t awaited_{}, before_{};
  std::jthread waiting_;
};

/// While it lives, an interrupt asks to stop instead of ending the program at once.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
};

/// Ends the program after an interrupt with 130, the exit code that shells give to one that was interrupted from the
/// keyboard. If it was, it ends by the signal itself: a shell then ends the loop, too, in which it was called.
[[noreturn]] void end_interrupted();

}  // namespace mpmvv::cli
