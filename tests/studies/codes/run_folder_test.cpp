#include "studies/codes/run_folder.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <tuple>

#include "studies/support/error.hpp"
#include "tests/own_folder.hpp"

namespace mpmvv::codes::run_folder_test {

namespace fs = std::filesystem;

class RunFolders : public testing::Test {
 protected:
  RunFolders() { setenv("TMPDIR", top_.c_str(), 1); }
  ~RunFolders() override {
    setenv("TMPDIR", top_.parent_path().c_str(), 1);
    fs::remove_all(top_);
  }

  /// Folders of another process of this number, as containers have them.
  void make_foreign(const std::string& what) const {
    for (int k = 0; k < 100; ++k) {
      fs::create_directories(foreign(what, k));
      std::ofstream(foreign(what, k) / "theirs") << k;
    }
  }
  bool is_foreign_whole(const std::string& what) const {
    for (int k = 0; k < 100; ++k)
      if (!fs::exists(foreign(what, k) / "theirs")) return false;
    return true;
  }

  const fs::path top_ = own_folder("run-folders");

 private:
  fs::path foreign(const std::string& what, int k) const {
    return top_ / ("mpmvv-" + what + "-" + std::to_string(getpid()) + "-" + std::to_string(k));
  }
};

TEST_F(RunFolders, TakeNoPlaceOfOthers) {
  make_foreign("run");
  make_foreign("failed");
  RunFolder failed{{}};
  EXPECT_TRUE(fs::is_empty(failed.path()));
  EXPECT_TRUE(fs::is_empty(failed.keep()));
  { const RunFolder good{{}}; }
  EXPECT_TRUE(is_foreign_whole("run"));
  EXPECT_TRUE(is_foreign_whole("failed"));
}

/// An output of an earlier run would be scored as that of this one.
TEST_F(RunFolders, ANamedOneIsNewOrEmpty) {
  const fs::path named = top_ / "trial";
  { const RunFolder made(named); }
  EXPECT_NO_THROW(RunFolder{named});
  std::ofstream(named / "particles.csv") << "of another run";
  EXPECT_THAT([&] { RunFolder{named}; }, testing::ThrowsMessage<support::UsageError>(testing::HasSubstr(
                                             "trial in --keep is not empty (a new folder, or an empty one")));
  EXPECT_TRUE(fs::exists(named / "particles.csv"));
}

TEST_F(RunFolders, AreRemovedTogetherAndNoOthers) {
  make_foreign("run");
  const RunFolder first{{}}, second{{}};
  RunFolder failed{{}};
  failed.keep();
  std::ignore = remove_run_folders();
  EXPECT_FALSE(fs::exists(first.path()));
  EXPECT_FALSE(fs::exists(second.path()));
  EXPECT_TRUE(fs::exists(failed.path()));
  EXPECT_TRUE(is_foreign_whole("run"));
}

TEST_F(RunFolders, AreRemovedWhereverTemporaryFilesBelongByNow) {
  const RunFolder folder{{}};
  setenv("TMPDIR", "/no/folder", 1);
  EXPECT_NO_THROW(std::ignore = remove_run_folders());
  EXPECT_FALSE(fs::exists(folder.path()));
}

TEST_F(RunFolders, WaitForTheEndOfAProcessThatRemovesThem) {
  std::atomic<bool> is_there = false;
  std::jthread late;
  {
    const auto no_more = remove_run_folders();
    late = std::jthread([&] {
      const RunFolder folder{{}};
      is_there = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_FALSE(is_there);
  }
  late.join();
  EXPECT_TRUE(is_there);
}

TEST_F(RunFolders, AreRemovedThoughSomebodyStillWrites) {
  const RunFolder folder{{}};
  std::atomic<bool> is_started = false;
  const std::jthread writer([&] {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
    for (int k = 0; std::chrono::steady_clock::now() < end; ++k) {
      std::ofstream(folder.path() / std::to_string(k)) << k;
      is_started = true;
    }
  });
  while (!is_started) std::this_thread::yield();
  std::ignore = remove_run_folders();
  EXPECT_FALSE(fs::exists(folder.path()));
}

}  // namespace mpmvv::codes::run_folder_test
