#include "studies/support/memory.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/studies/temp_folder.hpp"

namespace mpmvv::support::memory_test {

class Memory : public testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) {
    std::filesystem::create_directories((folder_ / file).parent_path());
    std::ofstream(folder_ / file) << text;
  }

  TempFolder folder_;
};

TEST_F(Memory, IsWhatTheSystemHasAvailable) {
  write("proc/meminfo", "MemTotal:  4000 kB\nMemFree:  100 kB\nMemAvailable:  3000 kB\n");
  EXPECT_EQ(available_memory(folder_.path()), 3000 * 1024);
  write("sys/fs/cgroup/memory.max", "max\n");
  EXPECT_EQ(available_memory(folder_.path()), 3000 * 1024);
}

TEST_F(Memory, IsWhatAContainersLimitLeaves) {
  write("proc/meminfo", "MemAvailable:  3000 kB\n");
  write("sys/fs/cgroup/memory.max", "2048000\n");
  write("sys/fs/cgroup/memory.current", "1024000\n");
  EXPECT_EQ(available_memory(folder_.path()), 1024000);
  write("sys/fs/cgroup/memory.current", "4096000\n");
  EXPECT_EQ(available_memory(folder_.path()), 0);
}

TEST_F(Memory, OfThisMachineIsSome) {
  EXPECT_GT(available_memory(), 0);
}

}  // namespace mpmvv::support::memory_test
