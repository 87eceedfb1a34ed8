#pragma once
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace mpmvv::solver {

/// Refers to any callable that takes the number of a task. This is one type for all callables, so the code that runs
/// tasks is compiled once. Valid as long as the callable exists.
class Task {
 public:
  template <class Visit>
  Task(const Visit& visit) : visit_(&visit), call_([](const void* v, int k) { (*static_cast<const Visit*>(v))(k); }) {}
  void operator()(int k) const { call_(visit_, k); }

 private:
  const void* visit_;
  void (*call_)(const void* visit, int k);
};

/// Holds one batch of numbered tasks after another, and gives each task to the first thread that asks. `wait` waits for
/// tasks and not for threads: a thread that the system does not let run, and that has taken no task, holds up nobody.
/// With a barrier for all threads instead, a case on two threads beside three busy programs took 15 times as long.
class TaskQueue {
 public:
  /// Opens a batch of task(0) to task(count - 1). `task` has to stay until `wait` has returned. All tasks of earlier
  /// batches must be done.
  void open(int count, const Task& task) {
    task_.store(&task, std::memory_order_relaxed);
    done_.store(0, std::memory_order_relaxed);
    const std::uint64_t next_batch = (state_.load(std::memory_order_relaxed) >> 2 * bits) + 1;
    state_.store(next_batch << 2 * bits | static_cast<std::uint64_t>(count) << bits, std::memory_order_release);
    tell();
  }
  void open(int count, Task&& gone_too_early) = delete;
  /// Ends the queue: no more batches will come.
  void close() {
    is_closed_ = true;
    tell();
  }

  /// Carries out tasks of the batch as long as there are some that nobody has taken.
  void take() {
    std::uint64_t state = state_.load(std::memory_order_acquire);
    while (next_of(state) < count_of(state)) {
      // This is the task of the batch in `state` if the exchange below finds the state unchanged: the next batch is
      // opened only after the last task of this one is done.
      const Task* const task = task_.load(std::memory_order_relaxed);
      if (!state_.compare_exchange_weak(state, state + 1, std::memory_order_acq_rel)) continue;
      carry_out(*task, next_of(state));
      if (done_.fetch_add(1, std::memory_order_acq_rel) + 1 == count_of(state)) done_.notify_one();
      state = state_.load(std::memory_order_acquire);
    }
  }
  /// Returns when all tasks of the batch are done. Then rethrows what a task has thrown; of several, that of the task
  /// with the lowest number.
  void wait() {
    const int count = count_of(state_.load(std::memory_order_relaxed));
    for (int done; (done = done_.load(std::memory_order_acquire)) < count;) wait_while(done_, done);
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }
  /// Waits until a batch has been opened after the `seen` ones, or the queue has ended, and updates `seen`. Returns
  /// false if the queue has ended.
  bool wait_for_more(unsigned& seen) {
    wait_while(batches_, seen);
    seen = batches_.load(std::memory_order_acquire);
    return !is_closed_;
  }

 private:
  /// The bits that a number of tasks takes. There are 2^17 tasks at most, as each has 2^14 of at most 2^31 nodes or
  /// particles.
  static constexpr int bits = 18;
  static int part(std::uint64_t state) { return static_cast<int>(state & ((std::uint64_t{1} << bits) - 1)); }
  static int next_of(std::uint64_t state) { return part(state); }
  static int count_of(std::uint64_t state) { return part(state >> bits); }

  void carry_out(const Task& task, int k) {
    try {
      task(k);
    } catch (...) {
      const std::lock_guard lock(throwing_);
      if (!thrown_ || k < thrower_) thrown_ = std::current_exception(), thrower_ = k;
    }
  }

  void tell() {
    batches_.fetch_add(1, std::memory_order_release);
    batches_.notify_all();
  }
  /// Waits until `number` is no longer `old`. Polls for a while before it sleeps: a phase of a step often takes less
  /// time than to be woken.
  template <class T>
  static void wait_while(const std::atomic<T>& number, T old) {
    constexpr int looks = 200;
    for (int k = 0; k < looks; ++k) {
      if (number.load(std::memory_order_acquire) != old) return;
      std::this_thread::yield();
    }
    number.wait(old, std::memory_order_acquire);
  }

  std::atomic<std::uint64_t> state_{0};  ///< from the top: number of the batch, count of its tasks, next task
  std::atomic<const Task*> task_{nullptr};
  std::atomic<int> done_{0};
  std::atomic<unsigned> batches_{0};  ///< how many were opened so far, and one more once the queue has ended
  std::atomic<bool> is_closed_{false};

  std::mutex throwing_;
  std::exception_ptr thrown_;
  int thrower_ = 0;  ///< number of the task that threw `thrown_`
};

}  // namespace mpmvv::solver
