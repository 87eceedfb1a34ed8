#pragma once
#include <algorithm>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

#include "solver/parallel/task_queue.hpp"

namespace mpmvv::solver {

/// A fixed number of threads that carry out numbered tasks: each thread takes the next task that is left. Which thread
/// runs a task has no influence on the result, because the tasks of one `run` are independent of each other.
class ThreadPool {
 public:
  /// Starts `size` - 1 threads, as the thread that calls `run` takes tasks, too. Starts fewer where the system grants
  /// no more.
  explicit ThreadPool(int size) {
    for (int t = 1; t < size; ++t) try {
        threads_.emplace_back([this] {
          for (unsigned seen = 0; tasks_.wait_for_more(seen);) tasks_.take();
        });
      } catch (const std::exception&) {
        break;
      }
  }
  ~ThreadPool() { tasks_.close(); }

  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Calls task(k) for every k in [0, count), and returns when all are done. Rethrows what a task throws; of several,
  /// that of the least k.
  void run(int count, const Task& task) {
    if (threads_.empty() || count < 2) {
      for (int k = 0; k < count; ++k) task(k);
      return;
    }
    tasks_.open(count, task);
    tasks_.take();
    tasks_.wait();
  }

 private:
  TaskQueue tasks_;
  std::vector<std::jthread> threads_;
};

inline constexpr std::size_t chunk = 16384;  ///< elements of a range that a thread takes at a time

constexpr std::size_t count_chunks(std::size_t count) {
  return (count + chunk - 1) / chunk;
}

/// Calls visit(begin, end) for the chunks of [0, count); the k-th begins at k times `chunk`.
template <class Visit>
void for_chunks(ThreadPool& pool, std::size_t count, const Visit& visit) {
  pool.run(static_cast<int>(count_chunks(count)), [&](int task) {
    const std::size_t begin = chunk * static_cast<std::size_t>(task);
    visit(begin, std::min(begin + chunk, count));
  });
}

}  // namespace mpmvv::solver
