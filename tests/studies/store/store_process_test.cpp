#include <gmock/gmock.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <functional>
#include <thread>

#include "studies/store/run_rows.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::store::store_process_test {

using namespace store_samples;
using Mode = Store::Mode;
using testing::IsEmpty;

/// Runs a function in a process of its own, whose exit status is what it returns; an exception is 99.
pid_t start(const std::function<int()>& body) {
  const pid_t child = fork();
  if (child != 0) return child;
  int code = 99;
  try {
    code = body();
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
  }
  std::fflush(stderr);
  _exit(code);
}

int exit_status(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

constexpr int skipped = 77;

/// Makes this process one that must obey permissions.
void become_nobody() {
  constexpr uid_t nobody = 65534;
  if (geteuid() == 0 && seteuid(nobody) != 0) _exit(skipped);
}

/// 0 when the action complains with this text.
int expect_complaint(const std::function<void()>& action, const std::string& text) {
  const std::string said = complaint(action);
  if (said.find(text) != std::string::npos) return 0;
  fmt::print(stderr, "expected '{}', got '{}'\n", text, said);
  return 1;
}

class StoreProcesses : public StoreTest {
 protected:
  void SetUp() override { std::filesystem::permissions(folder_, std::filesystem::perms::all); }
  void TearDown() override {
    std::filesystem::permissions(folder_, std::filesystem::perms::all);
    StoreTest::TearDown();
  }
};

TEST_F(StoreProcesses, CreateAndFillOneStoreAtOnce) {
  constexpr int processes = 4, records = 6;
  std::vector<pid_t> children;
  for (int k = 0; k < processes; ++k)
    children.push_back(start([&, k] {
      Store store(file_, Mode::create_or_write);
      for (int cells = 1; cells <= records; ++cells) {
        store.keep(record(cells), provenance());                   // every process the same
        store.keep(record(1000 * (k + 1) + cells), provenance());  // and its own
        store.keep_study(study(fmt::format("s{}", k)), {}, provenance());
      }
      return 0;
    }));
  for (const pid_t child : children) EXPECT_EQ(exit_status(child), 0);
  const Store store(file_, Mode::read);
  EXPECT_EQ(store.contents().records, 30);
  EXPECT_EQ(store.studies("d1").size(), processes);
  EXPECT_THAT(store.check(), IsEmpty());
}

TEST_F(StoreProcesses, AKilledProcessLosesNoRecordThatItKept) {
  for (int round = 0; round < 3; ++round) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = start([&] {
      Store store(file_, Mode::create_or_write);
      for (int cells = 1000 * round + 1;; ++cells) {
        store.keep(record(cells), provenance());
        store.keep_study(study("s", "", {series("a", {point(1)})}), {{bar(cells)}}, provenance());
        if (write(ends[1], &cells, sizeof cells) != sizeof cells) return 1;
      }
    });
    close(ends[1]);
    int kept = 0;
    for (int wanted = 3; wanted > 0 && read(ends[0], &kept, sizeof kept) == sizeof kept;) --wanted;
    std::this_thread::sleep_for(std::chrono::milliseconds(round));
    kill(child, SIGKILL);
    exit_status(child);
    while (read(ends[0], &kept, sizeof kept) == sizeof kept) continue;
    close(ends[0]);

    const Store store(file_, Mode::read);
    EXPECT_THAT(store.check(), IsEmpty());
    ASSERT_GE(kept, 1000 * round + 3);
    for (int cells = 1000 * round + 1; cells <= kept; ++cells) ASSERT_TRUE(store.find(bar(cells), "d1")) << cells;
    EXPECT_EQ(store.studies("d1").at(0).series.at(0).points.size(), 1u);
  }
}

TEST_F(StoreProcesses, AWriteThatWasKilledHalfWayIsUndoneByTheNextReader) {
  Store(file_, Mode::create_or_write).keep(record(8), provenance());
  // Pages of tables that a new store's schema has dropped are free, and no journal restores what lay there.
  Database(file_, Database::Access::write).execute("VACUUM");
  const std::string before = bytes_of(file_);
  exit_status(start([&] {
    Database database(file_, Database::Access::write);
    database.execute("PRAGMA cache_size = 1; BEGIN IMMEDIATE");
    database.execute("DELETE FROM runs");
    const std::string long_text(100'000, 'x');
    for (int i = 0; i < 100; ++i) provenance_id(database, provenance(fmt::format("{}{}", long_text, i)));
    return raise(SIGKILL);
  }));
  ASSERT_TRUE(std::filesystem::exists(file_.string() + "-journal"));
  ASSERT_NE(bytes_of(file_), before);
  const Store store(file_, Mode::read);
  EXPECT_TRUE(store.find(bar(8), "d1"));
  EXPECT_THAT(store.check(), IsEmpty());
  EXPECT_EQ(bytes_of(file_), before);
}

TEST_F(StoreProcesses, AReadOnlyStoreIsReadAndNotWritten) {
  Store(file_, Mode::create_or_write).keep(record(8), provenance());
  std::filesystem::permissions(file_, std::filesystem::perms(0444));
  std::filesystem::permissions(folder_, std::filesystem::perms(0555));
  const std::string before = bytes_of(file_);
  const int status = exit_status(start([&] {
    become_nobody();
    if (!Store(file_, Mode::read).find(bar(8), "d1")) return 1;
    return expect_complaint([&] { Store(file_, Mode::write); }, "is read-only") +
           expect_complaint([&] { Store(file_, Mode::create_or_write); }, "is read-only");
  }));
  if (status == skipped) GTEST_SKIP() << "cannot become another user";
  EXPECT_EQ(status, 0);
  EXPECT_EQ(bytes_of(file_), before);
}

TEST_F(StoreProcesses, AFolderThatTakesNoJournalIsFoundOutAtOnce) {
  Store(file_, Mode::create_or_write).keep(record(8), provenance());
  std::filesystem::permissions(file_, std::filesystem::perms(0666));
  std::filesystem::permissions(folder_, std::filesystem::perms(0555));
  const int status = exit_status(start([&] {
    become_nobody();
    if (!Store(file_, Mode::read).find(bar(8), "d1")) return 1;
    return expect_complaint([&] { Store(file_, Mode::write); }, "is read-only") +
           expect_complaint([&] { Store(folder_ / "new.db", Mode::create_or_write); }, "cannot be opened");
  }));
  if (status == skipped) GTEST_SKIP() << "cannot become another user";
  EXPECT_EQ(status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "new.db"));
}

TEST_F(StoreProcesses, AStoreInAFolderThatMayNotBeSearchedIsNotTakenForAbsent) {
  Store(file_, Mode::create_or_write).keep(record(8), provenance());
  std::filesystem::permissions(folder_, std::filesystem::perms(0));
  const int status = exit_status(start([&] {
    become_nobody();
    int wrong = 0;
    for (const Mode mode : {Mode::read, Mode::write, Mode::create_or_write})
      wrong += expect_complaint([&] { Store(file_, mode); }, "cannot be used: Permission denied");
    return wrong;
  }));
  if (status == skipped) GTEST_SKIP() << "cannot become another user";
  EXPECT_EQ(status, 0);
}

/// Keeps records until one is refused; the number of those kept, 0 when the complaint is not this one.
int fill(const std::filesystem::path& file, const std::string& text) {
  Store store(file, Mode::create_or_write);
  for (int cells = 1; cells < 100'000; ++cells) {
    records::Record r = record(cells);
    r.reason = std::string(10'000, 'x');
    const std::string said = complaint([&] { store.keep(r, provenance()); });
    if (said.empty()) continue;
    if (said.find(text) != std::string::npos) return cells - 1;
    fmt::print(stderr, "expected '{}', got '{}'\n", text, said);
    return 0;
  }
  return 0;
}

/// 0 when the store is sound and holds records 1 to kept.
int expect_sound(const std::filesystem::path& file, int kept) {
  const Store store(file, Mode::read);
  if (kept < 5 || !store.check().empty()) return 1;
  for (int cells = 1; cells <= kept; ++cells)
    if (!store.find(bar(cells), "d1")) return 1;
  return 0;
}

TEST_F(StoreProcesses, AFullDiskLosesNothing) {
  const auto disk = folder_ / "disk";
  std::filesystem::create_directory(disk);
  const int status = exit_status(start([&] {
    if (unshare(CLONE_NEWNS) != 0 || mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=512k") != 0)
      return skipped;
    const int kept = fill(disk / "results.db", "no space left");
    return expect_sound(disk / "results.db", kept) +
           expect_complaint([&] { Store(disk / "new.db", Mode::create_or_write); }, "no space left") +
           std::filesystem::exists(disk / "new.db");
  }));
  if (status == skipped) GTEST_SKIP() << "cannot mount a small disk";
  EXPECT_EQ(status, 0);
}

TEST_F(StoreProcesses, AQuotaLosesNothing) {
  const int status = exit_status(start([&] {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{.rlim_cur = 500'000, .rlim_max = 500'000};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) return skipped;
    return expect_sound(file_, fill(file_, "check the disk and its quota"));
  }));
  EXPECT_EQ(status, 0);
}

}  // namespace mpmvv::store::store_process_test
