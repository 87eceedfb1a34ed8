#include "studies/support/memory.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/own_folder.hpp"

namespace mpmvv::support::memory_test {

namespace fs = std::filesystem;

class Memory : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((folder_ / file).parent_path());
    std::ofstream(folder_ / file) << text;
  }

  const fs::path folder_ = own_folder("memory-test");
};

TEST_F(Memory, IsWhatTheSystemHasAvailable) {
  write("proc/meminfo", "MemTotal:  4000 kB\nMemFree:  100 kB\nMemAvailable:  3000 kB\n");
  EXPECT_EQ(available_memory(folder_), 3000 * 1024);
  write("sys/fs/cgroup/memory.max", "max\n");
  EXPECT_EQ(available_memory(folder_), 3000 * 1024);
}

TEST_F(Memory, IsWhatAContainersLimitLeaves) {
  write("proc/meminfo", "MemAvailable:  3000 kB\n");
  write("sys/fs/cgroup/memory.max", "2048000\n");
  write("sys/fs/cgroup/memory.current", "1024000\n");
  EXPECT_EQ(available_memory(folder_), 1024000);
  write("sys/fs/cgroup/memory.stat", "anon 1\ninactive_file 24000\n");
  EXPECT_EQ(available_memory(folder_), 1048000) << "files that were read are given up for programs";
  write("sys/fs/cgroup/memory.current", "4096000\n");
  EXPECT_EQ(available_memory(folder_), 0);
}

TEST_F(Memory, IsWhatTheProgramsOwnGroupLeaves) {
  write("proc/meminfo", "MemAvailable:  3000 kB\n");
  write("proc/self/cgroup", "0::/slurm/job_3\n");
  write("sys/fs/cgroup/slurm/job_3/memory.max", "1000000\n");
  EXPECT_EQ(available_memory(folder_), 1000000);
}

TEST_F(Memory, IsWhatTheGroupsAroundTheProgramsOwnLeave) {
  write("proc/meminfo", "MemAvailable:  3000 kB\n");
  write("proc/self/cgroup", "0::/slurm/job_3/step_0/task_0\n");
  write("sys/fs/cgroup/slurm/job_3/step_0/task_0/memory.max", "max\n");
  write("sys/fs/cgroup/slurm/job_3/memory.max", "1000000\n");
  write("sys/fs/cgroup/slurm/job_3/memory.current", "400000\n");
  EXPECT_EQ(available_memory(folder_), 600000) << "the job's limit counts for its tasks";
  write("sys/fs/cgroup/memory.max", "500000\n");
  EXPECT_EQ(available_memory(folder_), 500000);
}

TEST_F(Memory, OfThisMachineIsSome) {
  EXPECT_GT(available_memory(), 0);
  EXPECT_GT(available_memory(folder_), 0) << "where there is no /proc";
}

}  // namespace mpmvv::support::memory_test
