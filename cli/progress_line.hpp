#pragma once
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "cli/console.hpp"
#include "studies/plan/progress.hpp"

namespace mpmvv::cli {

/// A line on the terminal that says how far a study or a run has come and how long the rest takes, second by second.
/// Where standard error is no terminal there is none.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// The function to call with every progress; empty where there is no line.
  std::function<void(const plan::Progress&)> listener();

  /// Writes a note in the place of the line, which is drawn again below it.
  template <class... T>
  void note(fmt::format_string<Shown<T>...> format, const T&... values) {
    const std::lock_guard lock(mutex_);
    blank();
    cli::note(format, values...);
  }
  void clear();  ///< removes the line for good

 private:
  using Clock = std::chrono::steady_clock;

  void blank() const;
  void draw() const;
  void draw_each_second(const std::stop_token& stop);

  plan::Progress progress_;
  Clock::time_point told_;
  std::mutex mutex_;
  std::condition_variable_any ended_;
  std::jthread drawing_;
};

}  // namespace mpmvv::cli
