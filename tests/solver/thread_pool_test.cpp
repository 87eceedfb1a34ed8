#include "solver/parallel/thread_pool.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <stdexcept>
#include <string>

#include "solver/parallel/slabs.hpp"
#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::thread_pool_test {

class ThreadPoolOf : public ::testing::TestWithParam<int> {
 protected:
  const int threads = GetParam();
  ThreadPool pool{threads};
};

INSTANTIATE_TEST_SUITE_P(Threads, ThreadPoolOf, ::testing::Values(1, 2, 3, 5));

TEST_P(ThreadPoolOf, RunsEachTaskOnceEachTime) {
  std::vector<std::atomic<int>> times(7);
  for (int k = 0; k < 500; ++k) pool.run(7, [&](int task) { ++times[static_cast<std::size_t>(task)]; });
  for (const auto& of_task : times) EXPECT_EQ(of_task, 500);
}

TEST_P(ThreadPoolOf, SeesWhatItWroteInTheRunBefore) {
  std::vector<int> own(64, 0), neighbours(64, 0);
  for (int k = 1; k <= 200; ++k) {
    pool.run(64, [&](int task) { own[static_cast<std::size_t>(task)] = k * task; });
    pool.run(64, [&](int task) {
      neighbours[static_cast<std::size_t>(task)] = own[static_cast<std::size_t>((task + 1) % 64)];
    });
    for (int task = 0; task < 64; ++task) ASSERT_EQ(neighbours[static_cast<std::size_t>(task)], k * ((task + 1) % 64));
  }
}

TEST_P(ThreadPoolOf, ThrowsWhatTheFirstTaskThrewAndGoesOn) {
  const auto odd_throws = [](int task) {
    if (task % 2 == 1) throw std::runtime_error(std::to_string(task));
  };
  for (int k = 0; k < 50; ++k) try {
      pool.run(64, odd_throws);
      FAIL() << "nothing came out";
    } catch (const std::runtime_error& e) {
      EXPECT_STREQ(e.what(), "1");
    }
  std::atomic<int> done{0};
  pool.run(64, [&](int) { ++done; });
  EXPECT_EQ(done, 64);
}

TEST(TaskQueues, AreEmptiedByWhoeverComes) {
  TaskQueue tasks;
  std::vector<int> times(3, 0);
  const auto count = [&](int task) { ++times[static_cast<std::size_t>(task)]; };
  const Task task(count);
  for (int k = 1; k <= 2; ++k) {
    tasks.open(3, task);
    tasks.take();
    tasks.wait();  // for nobody else
    tasks.take();  // as a thread that comes too late
    EXPECT_EQ(times, std::vector<int>(3, k));
  }
}

TEST(TaskQueues, SayWhenNoMoreWillCome) {
  TaskQueue tasks;
  unsigned seen = 0;
  const auto nothing = [](int) {};
  const Task task(nothing);
  tasks.open(2, task);
  EXPECT_TRUE(tasks.wait_for_more(seen));
  tasks.close();
  EXPECT_FALSE(tasks.wait_for_more(seen));
}

/// Both those that still look and those that sleep by then go on.
TEST_P(ThreadPoolOf, GoesOnAfterARest) {
  std::atomic<int> tasks = 0;
  for (const int rest : {0, 1, 20, 0, 5}) {
    std::this_thread::sleep_for(std::chrono::milliseconds(rest));
    pool.run(10, [&](int task) {
      if (task == 3) std::this_thread::sleep_for(std::chrono::milliseconds(rest));
      ++tasks;
    });
  }
  EXPECT_EQ(tasks, 50);
}

TEST_P(ThreadPoolOf, CutsARangeIntoChunks) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{16384}, std::size_t{50000}}) {
    std::vector<int> visits(count, 0);
    for_chunks(pool, count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) ++visits[k];
    });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
  }
}

TEST_P(ThreadPoolOf, SortsParticlesAsOneThreadDoes) {
  Scene<2> scene = full_scene<2>(BSpline2{}, 64, 3);  // several chunks
  std::shuffle(scene.particles.x.begin(), scene.particles.x.end(), std::mt19937(4));
  for (std::size_t p = 0; p < scene.particles.size(); ++p) scene.particles.F[p] *= static_cast<double>(p);
  Particles<2> particles = scene.particles, expected = scene.particles;
  const Grid<2> grid(scene.lower, scene.h, scene.cells, BSpline2::extra_inside, BSpline2::ghost);
  ThreadPool alone(1);
  Slabs<2>(grid, BSpline2{}).sort(expected, grid, alone);
  Slabs<2>(grid, BSpline2{}).sort(particles, grid, pool);
  ASSERT_FALSE(std::is_sorted(expected.id.begin(), expected.id.end()));
  EXPECT_EQ(particles.id, expected.id);
  EXPECT_EQ(particles.x, expected.x);
  EXPECT_EQ(particles.F, expected.F);
}

/// Whatever is in use goes along, whether a test elsewhere has it differ from particle to particle or not.
TEST(Particles, TakeAllTheirFieldsAlong) {
  const Array<std::uint32_t> order{3, 0, 4, 1, 2};
  Particles<2> particles;
  particles.resize(order.size());
  auto& [start, sum] = particles.stages;
  double first = 1;
  const auto number = [&](auto&... fields) {
    const auto one = [&](auto& field) {
      field.resize(order.size());
      for (std::size_t p = 0; p < field.size(); ++p, ++first)
        if constexpr (requires { field[p].setConstant(first); })
          field[p].setConstant(first);
        else
          field[p] = first;
    };
    (one(fields), ...);
  };
  auto& all = particles;
  number(all.m, all.V0, all.x, all.v, all.l, all.l0, all.X, start.x, start.v, sum.x, sum.v);
  number(all.F, all.R, all.R0, all.C, start.F, sum.F);
  for (std::size_t p = 0; p < order.size(); ++p) all.thermal.push_back({.temperature = static_cast<double>(p)});
  const Particles<2> before = particles;
  ThreadPool alone(1);
  particles.permute(order, alone);
  const auto expect = [&order](const auto& found, const auto& had, const char* what) {
    for (std::size_t k = 0; k < order.size(); ++k) EXPECT_TRUE(found[k] == had[order[k]]) << what;
  };
  expect(all.id, before.id, "id");
  expect(all.m, before.m, "m"), expect(all.V0, before.V0, "V0");
  expect(all.x, before.x, "x"), expect(all.v, before.v, "v"), expect(all.F, before.F, "F");
  expect(all.l, before.l, "l"), expect(all.l0, before.l0, "l0"), expect(all.X, before.X, "X");
  expect(all.R, before.R, "R"), expect(all.R0, before.R0, "R0"), expect(all.C, before.C, "C");
  for (std::size_t k = 0; k < order.size(); ++k)
    EXPECT_EQ(all.thermal[k].temperature, before.thermal[order[k]].temperature);
  expect(start.x, before.stages.start.x, "start x"), expect(sum.x, before.stages.sum.x, "sum x");
  expect(start.v, before.stages.start.v, "start v"), expect(sum.v, before.stages.sum.v, "sum v");
  expect(start.F, before.stages.start.F, "start F"), expect(sum.F, before.stages.sum.F, "sum F");
}

}  // namespace mpmvv::solver::thread_pool_test
