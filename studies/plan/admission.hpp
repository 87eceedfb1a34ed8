#pragma once
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace mpmvv::plan {

/// Lets cases start, in the order in which they ask, as soon as the threads and the memory they need are free. One that
/// needs all threads runs alone; one that needs more memory than there is starts when all of it is free.
class Admission {
 public:
  Admission(int threads, double memory) : threads_(threads), memory_(memory) {}

  /// A place among the running cases; the destructor gives it back.
  class Place {
   public:
    Place(Admission& admission, int threads, double memory)
        : admission_(admission), threads_(threads), memory_(memory) {
      admission_.enter(threads_, memory_);
    }
    ~Place() { admission_.leave(threads_, memory_); }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

   private:
    Admission& admission_;
    int threads_;
    double memory_;
  };

 private:
  void enter(int threads, double memory) {
    std::unique_lock lock(mutex_);
    const std::uint64_t ticket = last_ticket_++;
    changed_.wait(lock, [&] {
      return ticket == next_ticket_ && threads_used_ + threads <= threads_ &&
             (threads_used_ == 0 || memory_used_ + memory <= memory_);
    });
    ++next_ticket_;
    threads_used_ += threads;
    memory_used_ += memory;
    changed_.notify_all();
  }

  void leave(int threads, double memory) {
    const std::lock_guard lock(mutex_);
    threads_used_ -= threads;
    memory_used_ -= memory;
    changed_.notify_all();
  }

  std::mutex mutex_;  ///< guards everything below
  std::condition_variable changed_;
  int threads_, threads_used_ = 0;
  double memory_, memory_used_ = 0;
  std::uint64_t last_ticket_ = 0, next_ticket_ = 0;
};

}  // namespace mpmvv::plan
