#pragma once
#include <atomic>
#include <thread>

namespace mpmvv::solver {

/// Where so many threads wait for each other, again and again. They look for a while before they sleep: a phase of a
/// step often takes less time than to be woken.
class SpinBarrier {
 public:
  explicit SpinBarrier(int size) : size_(size) {}

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

}  // namespace mpmvv::solver
