#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <optional>
#include <thread>
#include <vector>

#include "solver/parallel/spin_barrier.hpp"

namespace mpmvv::solver {

/// Any callable of a task's number, in one type, so that what runs it is compiled once. Valid as long as the callable.
class Task {
 public:
  template <class Visit>
  Task(const Visit& visit) : visit_(&visit), call_([](const void* v, int k) { (*static_cast<const Visit*>(v))(k); }) {}
  void operator()(int k) const { call_(visit_, k); }

 private:
  const void* visit_;
  void (*call_)(const void* visit, int k);
};

/// A fixed number of threads that takes numbered tasks, each the next one left. Which thread runs a task never decides
/// a result: the tasks of one `run` are independent of each other.
class ThreadPool {
 public:
  /// Of so many threads, or of fewer where the system grants no more.
  explicit ThreadPool(int size) {
    for (int t = 1; t < size; ++t) try {
        threads_.emplace_back([this] { serve(); });
      } catch (const std::exception&) {
        break;
      }
    size_ = static_cast<int>(threads_.size()) + 1;
    barrier_.emplace(size_);
    is_complete_ = true;
    is_complete_.notify_all();
  }

  ~ThreadPool() {
    if (size_ == 1) return;
    task_ = nullptr;
    barrier_->arrive_and_wait();
  }

  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Calls task(k) for every k in [0, count); returns when all are done. `task` must not throw.
  void run(int count, const Task& task) {
    if (size_ == 1 || count < 2) {
      for (int k = 0; k < count; ++k) task(k);
      return;
    }
    next_ = 0;
    count_ = count;
    task_ = &task;
    barrier_->arrive_and_wait();
    take();
    barrier_->arrive_and_wait();
  }

 private:
  /// What every thread but the first does.
  void serve() {
    is_complete_.wait(false);
    for (;;) {
      barrier_->arrive_and_wait();
      if (task_ == nullptr) return;
      take();
      barrier_->arrive_and_wait();
    }
  }
  void take() {
    for (int k = next_++; k < count_; k = next_++) (*task_)(k);
  }

  int size_ = 1;
  std::atomic<int> next_{0};
  int count_ = 0;
  const Task* task_ = nullptr;
  std::optional<SpinBarrier> barrier_;  ///< of those that there are
  std::atomic<bool> is_complete_{false};
  std::vector<std::jthread> threads_;
};

inline constexpr std::size_t chunk = 16384;  ///< of a range that threads share

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
