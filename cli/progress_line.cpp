#include "cli/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/console.hpp"
#include "cli/lines.hpp"
#include "cli/numbers.hpp"

namespace mpmvv::cli {

namespace {

constexpr const char* to_its_start = "\r\033[K";  // and blank from there

}  // namespace

ProgressLine::ProgressLine() {
  if (note_columns()) drawing_ = std::jthread([this](const std::stop_token& stop) { draw_each_second(stop); });
}

ProgressLine::~ProgressLine() {
  clear();
}

std::function<void(const plan::Progress&)> ProgressLine::listener() {
  if (!drawing_.joinable()) return {};
  return [this](const plan::Progress& progress) {
    const std::lock_guard lock(mutex_);
    if (drawing_.get_stop_token().stop_requested()) return;
    progress_ = progress;
    told_ = Clock::now();
    draw();
  };
}

void ProgressLine::clear() {
  if (!drawing_.joinable()) return;
  drawing_.request_stop();
  drawing_.join();
  const std::lock_guard lock(mutex_);  // a listener may be drawing
  note_text(to_its_start);
}

void ProgressLine::blank() const {
  if (drawing_.joinable()) note_text(to_its_start);
}

void ProgressLine::draw() const {
  if (progress_.total == 0) return;
  const double since = std::chrono::duration<double>(Clock::now() - told_).count();
  const double left = std::max(0.0, progress_.seconds_left - since);
  const std::string time = progress_.done == progress_.total
                               ? "all done"
                               : fmt::format("about {} left", left < 1 ? "1 s" : duration_text(left));
  const std::string line = fmt::format("[{}/{}] {}  {}", progress_.done, progress_.total, time, progress_.label);
  note_text(to_its_start + cut(line, note_columns().value_or(80) - 1));
}

void ProgressLine::draw_each_second(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    ended_.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
    if (!stop.stop_requested()) draw();
  }
}

}  // namespace mpmvv::cli
