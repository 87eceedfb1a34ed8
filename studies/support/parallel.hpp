#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace mpmvv::support {

/// Calls task(k) for k = 0 ... count - 1, started in that order on up to `jobs` threads; rethrows the first
/// exception, after which no further task is started. Where the system grants fewer threads, those do all of it.
template <class Task>
void for_each_parallel(std::size_t count, int jobs, const Task& task) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr first;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t k = next++; k < count; k = next++) try {
        task(k);
      } catch (...) {
        next = count;
        const std::lock_guard lock(mutex);
        if (!first) first = std::current_exception();
      }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t j = 1; j < std::min(static_cast<std::size_t>(jobs), count); ++j) try {
        others.emplace_back(work);
      } catch (const std::exception&) {
        break;
      }
    work();
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace mpmvv::support
