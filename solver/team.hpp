#pragma once
#include <atomic>
#include <barrier>
#include <memory>
#include <thread>
#include <vector>

namespace mpmvv::solver {

/// A numbered task of any type, so that what runs it is compiled once. Valid as long as what it is made from.
class Task {
 public:
  template <class Visit>
  Task(const Visit& visit) : visit_(&visit), call_([](const void* v, int k) { (*static_cast<const Visit*>(v))(k); }) {}
  void operator()(int k) const { call_(visit_, k); }

 private:
  const void* visit_;
  void (*call_)(const void* visit, int k);
};

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
          if (task_ == nullptr) return;
          take();
          sync_->arrive_and_wait();
        }
      });
    }
  }

  ~Team() {
    if (size_ == 1) return;
    task_ = nullptr;
    sync_->arrive_and_wait();
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
    sync_->arrive_and_wait();
    take();
    sync_->arrive_and_wait();
  }

 private:
  void take() {
    for (int k = next_++; k < count_; k = next_++) (*task_)(k);
  }

  int size_;
  std::atomic<int> next_{0};
  int count_ = 0;
  const Task* task_ = nullptr;
  std::unique_ptr<std::barrier<>> sync_;
  std::vector<std::jthread> threads_;
};

}  // namespace mpmvv::solver
