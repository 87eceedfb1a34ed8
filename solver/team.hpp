#pragma once
#include <barrier>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace mpmvv::solver {

/// A fixed team of threads that shares out numbered tasks, task k to thread k mod size. Which thread runs a task
/// never decides a result: the tasks of one `run` are independent of each other.
class Team {
 public:
  explicit Team(int size) : size_(size) {
    if (size_ == 1) return;
    sync_ = std::make_unique<std::barrier<>>(size_);
    for (int t = 1; t < size_; ++t) {
      threads_.emplace_back([this, t] {
        for (;;) {
          sync_->arrive_and_wait();
          if (!work_) return;
          work_(t);
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

  int size() const { return size_; }

  /// Calls task(k) for every k in [0, tasks); returns when all are done. `task` must not throw.
  template <class Task>
  void run(int tasks, const Task& task) {
    const auto share = [this, tasks, &task](int thread) {
      for (int k = thread; k < tasks; k += size_) task(k);
    };
    if (size_ == 1 || tasks < 2) {
      for (int k = 0; k < tasks; ++k) task(k);
      return;
    }
    work_ = std::ref(share);
    sync_->arrive_and_wait();
    share(0);
    sync_->arrive_and_wait();
  }

 private:
  int size_;
  std::function<void(int)> work_;
  std::unique_ptr<std::barrier<>> sync_;
  std::vector<std::jthread> threads_;
};

}  // namespace mpmvv::solver
