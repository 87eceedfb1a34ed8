#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

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

/// Where so many threads wait for each other, again and again. They look for a while before they sleep: a phase of a
/// step often takes less time than to be woken.
class Meeting {
 public:
  explicit Meeting(int size) : size_(size) {}

  /// Returns when all of them have come.
  void arrive_and_wait() {
    constexpr int looks = 200;
    const unsigned meeting = met_.load(std::memory_order_relaxed);
    if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == size_) {
      arrived_.store(0, std::memory_order_relaxed);
      met_.store(meeting + 1, std::memory_order_release);
      met_.notify_all();
      return;
    }
    for (int k = 0; k < looks; ++k) {
      if (met_.load(std::memory_order_acquire) != meeting) return;
      std::this_thread::yield();
    }
    met_.wait(meeting, std::memory_order_acquire);
  }

 private:
  int size_;
  std::atomic<int> arrived_{0};
  std::atomic<unsigned> met_{0};  ///< meetings so far
};

/// A fixed team of threads that takes numbered tasks, each the next one left. Which thread runs a task never decides a
/// result: the tasks of one `run` are independent of each other.
class Team {
 public:
  explicit Team(int size) : size_(size), meeting_(size) {
    if (size_ == 1) return;
    for (int t = 1; t < size_; ++t) {
      threads_.emplace_back([this] {
        for (;;) {
          meeting_.arrive_and_wait();
          if (task_ == nullptr) return;
          take();
          meeting_.arrive_and_wait();
        }
      });
    }
  }

  ~Team() {
    if (size_ == 1) return;
    task_ = nullptr;
    meeting_.arrive_and_wait();
  }

  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Calls task(k) for every k in [0, count); returns when all are done. `task` must not throw.
  void run(int count, const Task& task) {
    if (size_ == 1 || count < 2) {
      for (int k = 0; k < count; ++k) task(k);
      return;
    }
    next_ = 0;
    count_ = count;
    task_ = &task;
    meeting_.arrive_and_wait();
    take();
    meeting_.arrive_and_wait();
  }

 private:
  void take() {
    for (int k = next_++; k < count_; k = next_++) (*task_)(k);
  }

  int size_;
  std::atomic<int> next_{0};
  int count_ = 0;
  const Task* task_ = nullptr;
  Meeting meeting_;
  std::vector<std::jthread> threads_;
};

/// Calls visit(begin, end) for the pieces of [0, count).
template <class Visit>
void for_pieces(Team& team, std::size_t count, const Visit& visit) {
  constexpr std::size_t piece = 16384;
  team.run(static_cast<int>((count + piece - 1) / piece), [&](int task) {
    const std::size_t begin = piece * static_cast<std::size_t>(task);
    visit(begin, std::min(begin + piece, count));
  });
}

}  // namespace mpmvv::solver
