#include "studies/plan/admission.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace mpmvv::plan::admission_test {

constexpr int threads = 4;
constexpr double memory = 10;

/// Runs a crowd of cases through one admission; every seventh is alone. Counts what broke its word.
TEST(Admission, NeverTooManyAndAloneIsAlone) {
  Admission admission(threads, memory);
  std::atomic<int> running{0}, broken{0};
  std::atomic<double> used{0};
  {
    std::vector<std::jthread> crowd;
    for (int k = 0; k < 70; ++k)
      crowd.emplace_back([&, k] {
        const bool alone = k % 7 == 0;
        const double wanted = k % 3 + 1;
        const Admission::Place place(admission, alone ? threads : 1, wanted);
        used += wanted;
        if (++running > (alone ? 1 : threads)) ++broken;
        if (used > memory) ++broken;
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        if (alone && running != 1) ++broken;
        --running;
        used -= wanted;
      });
  }
  EXPECT_EQ(broken, 0);
}

TEST(Admission, MoreMemoryThanThereIsStartsWhenAllIsFree) {
  Admission admission(threads, memory);
  std::atomic<bool> started{false};
  std::jthread big;
  {
    const Admission::Place small(admission, 1, 1);
    big = std::jthread([&] {
      const Admission::Place place(admission, 1, 100);
      started = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_FALSE(started);
  }
  big.join();
  EXPECT_TRUE(started);
}

}  // namespace mpmvv::plan::admission_test
