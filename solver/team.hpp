#pragma once
#include <atomic>
#include <barrier>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace mpmvv::solver {

/// A fixed team of threads that takes numbered tasks, each the next one left. Which thread runs a task never decides a
/// result: the tasks of one `run` are independent of each other.
class Team {
 public:
  explicit Team(int size) : size_(size) {
    if (size_ == 1) return;
    sync_ = std::make_unique<std::barrier<>>(size_);
    for (int t = 1; t < size_; ++t) {
      threads_.emplace_back([this] {
        for (;;) {
          sync_->arrive_and_wait();
          if (!work_) return;
          work_();
          sync_->arrive_and_wait();
        }
      });
    }
  }

  ~Team() {
    if (size_ == 1) return;
    work_ = nullptr;
    sync_->arrive_and_wait();
  }

  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Calls task(k) for every k in [0, tasks); returns when all are done. `task` must not throw.
  template <class Task>
  void run(int tasks, const Task& task) {
    if (size_ == 1 || tasks < 2) {
      for (int k = 0; k < tasks; ++k) task(k);
      return;
    }
    std::atomic<int> next{0};
    const auto take = [tasks, &task, &next] {
      for (int k = next++; k < tasks; k = next++) task(k);
    };
    work_ = std::ref(take);
    sync_->arrive_and_wait();
    take();
    sync_->arrive_and_wait();
  }

 private:
  int size_;
  std::function<void()> work_;
  std::unique_ptr<std::barrier<>> sync_;
  std::vector<std::jthread> threads_;
};

}  // namespace mpmvv::solver
