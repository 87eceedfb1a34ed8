#include <gmock/gmock.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <ctime>
#include <thread>

#include "studies/store/schema.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::store::store_merge_test {

using namespace store_samples;
using Mode = Store::Mode;
using records::Failure;
using records::Record;
using records::Status;
using testing::HasSubstr;
using testing::IsEmpty;
using Paths = std::vector<std::filesystem::path>;

class StoreMerge : public StoreTest {
 protected:
  /// Stores of so many runs each; a tenth of them are in the next store as well.
  Paths shards(int stores, int runs) {
    Paths files;
    for (int k = 0; k < stores; ++k) {
      std::vector<Record> records;
      for (int cells = 1; cells <= runs + runs / 10; ++cells) records.push_back(record(k * runs + cells));
      files.push_back(folder_ / fmt::format("shard-{}.db", k));
      Store store(files.back(), Mode::create_or_write);
      store.keep(records, provenance());
      store.keep_study(study(fmt::format("check-{}", k), "", {series("a", {point(1)})}), {{bar(k * runs + 1)}},
                       provenance());
    }
    return files;
  }

  /// As many as were generated, each with what its own store says of it.
  void expect_all_of(int stores, int runs) const {
    const Store merged(file_, Mode::read);
    EXPECT_EQ(merged.contents().records, stores * runs + runs / 10);
    EXPECT_THAT(merged.check(), IsEmpty());
    EXPECT_EQ(merged.studies("d1").size(), static_cast<std::size_t>(stores));
    for (int cells = 1; cells <= stores * runs + runs / 10; cells += 7) {
      const auto found = merged.find(bar(cells), "d1");
      ASSERT_TRUE(found) << cells;
      EXPECT_EQ(found->error.l2, record(cells).error.l2);
    }
  }
};

TEST_F(StoreMerge, TakesAllOfManyStoresEachOnce) {
  constexpr int stores = 10, runs = 30;
  const Paths files = shards(stores, runs);
  EXPECT_EQ(Store::merge(file_, files), stores * runs + runs / 10);
  expect_all_of(stores, runs);
  EXPECT_EQ(Store::merge(file_, files), 0);
}

using StoreMergeNightly = StoreMerge;

TEST_F(StoreMergeNightly, AHundredStoresOfAThousandRunsTakeLessThanTenSeconds) {
  constexpr int stores = 100, runs = 1000;
  const Paths files = shards(stores, runs);
  const std::clock_t start = std::clock();
  EXPECT_EQ(Store::merge(file_, files), stores * runs + runs / 10);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, 10) << "of this process alone, whatever else the machine does";
  RecordProperty("seconds", fmt::format("{:.1f}", seconds));
  RecordProperty("megabytes", fmt::format("{:.1f}", 1e-6 * static_cast<double>(std::filesystem::file_size(file_))));
  expect_all_of(stores, runs);
}

TEST_F(StoreMerge, ARunThatWasCarriedOutTakesThePlaceOfAFailedOne) {
  Record failed = record(8);
  failed.status = Status::failed;
  failed.failure = Failure::of_machine;
  const Paths files{folder_ / "failed.db", folder_ / "ok.db", folder_ / "failed-too.db"};
  Store(files[0], Mode::create_or_write).keep(failed, provenance());
  Store(files[1], Mode::create_or_write).keep(record(8), provenance());
  Store(files[2], Mode::create_or_write).keep(failed, provenance());
  Store::merge(file_, files);
  EXPECT_EQ(Store(file_, Mode::read).find(bar(8), "d1")->status, Status::ok);
}

TEST_F(StoreMerge, OneBadStoreAmongManyIsNamedAndNothingChanges) {
  Paths files = shards(3, 5);
  open_store(files[1], Mode::write).execute("UPDATE runs SET l2 = 7 WHERE cells = 8");
  EXPECT_THAT(complaint([&] { Store::merge(file_, files); }),
              testing::AllOf(HasSubstr("shard-1.db"), HasSubstr("is not as it was written")));
  EXPECT_FALSE(std::filesystem::exists(file_));
  Store(file_, Mode::create_or_write).keep(record(8), provenance());
  const std::string before = bytes_of(file_);
  files[1] = folder_ / "notes.txt";
  std::ofstream(files[1]) << "not a store";
  EXPECT_THAT(complaint([&] { Store::merge(file_, files); }), HasSubstr("notes.txt' is not a results store"));
  EXPECT_EQ(bytes_of(file_), before);
}

TEST_F(StoreMerge, KilledAtAnyTimeItHasMergedAllOrNothing) {
  const Paths files = shards(10, 100);
  Store(file_, Mode::create_or_write).keep(record(5000), provenance());
  for (const int milliseconds : {1, 5, 20, 50}) {
    const pid_t child = fork();
    if (child == 0) {
      Store::merge(file_, files);
      _exit(0);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    const Store store(file_, Mode::read);
    EXPECT_THAT(store.check(), IsEmpty());
    if (WIFSIGNALED(status))
      EXPECT_THAT(store.contents().records, testing::AnyOf(1, 1011)) << "it may have been done just before";
    else
      EXPECT_EQ(store.contents().records, 1011);
  }
  Store::merge(file_, files);
  EXPECT_EQ(Store(file_, Mode::read).contents().records, 1011);
}

}  // namespace mpmvv::store::store_merge_test
