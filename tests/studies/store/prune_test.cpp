#include <gmock/gmock.h>

#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::store::prune_test {

using namespace store_samples;
using testing::ElementsAre;
using testing::IsEmpty;

class Pruning : public StoreTest {
 protected:
  /// Keeps the run and the study of a version, on a day of January.
  static void keep(Store& store, const std::string& digest, int day, const cases::Case& c = bar(8),
                   const std::optional<records::OtherCode>& code = {}) {
    Provenance p = provenance(digest);
    p.time = fmt::format("2026-01-{:02}T00:00:00Z", day);
    records::Record run = record(8);
    run.the_case = c;
    store.keep(run, p);
    records::Series one = series("s", {point(8)});
    one.code = code;
    store.keep_study(study(code ? "theirs" : "ours", "", {one}), {{c}}, p);
  }

  static std::vector<std::string> digests(const Store& store) {
    std::vector<std::string> all;
    for (const Version& version : store.versions()) all.push_back(version.digest);
    return all;
  }
};

TEST_F(Pruning, KeepsTheNewestVersionsAndThatOfTheProgram) {
  {
    Store store(file_, Store::Mode::create_or_write);
    for (int day = 1; day <= 5; ++day) keep(store, fmt::format("d{}", day), day);
    store.keep(record(16), provenance("of a study that runs"));
  }
  const Store::Pruned pruned = Store::prune(file_, 2, "d2");
  ASSERT_EQ(pruned.versions.size(), 2U);
  EXPECT_EQ(pruned.versions[0].digest, "d1");
  EXPECT_EQ(pruned.versions[1].digest, "d3");
  EXPECT_EQ(pruned.studies, 2);
  EXPECT_EQ(pruned.records, 2);
  const Store store(file_, Store::Mode::read);
  EXPECT_THAT(digests(store), ElementsAre("d2", "d4", "d5"));
  EXPECT_THAT(store.check(), IsEmpty());
  EXPECT_FALSE(store.find(bar(8), "d1"));
  EXPECT_TRUE(store.find(bar(8), "d5"));
  EXPECT_EQ(store.studies("d4").at(0).series.at(0).points.size(), 1U);
  EXPECT_TRUE(store.find(bar(16), "of a study that runs")) << "its first study is not kept yet";
  EXPECT_EQ(store.contents().programs.size(), 4U);
  EXPECT_THAT(Store::prune(file_, 2, "d2").versions, IsEmpty());
}

TEST_F(Pruning, LeavesWhatOtherCodesRan) {
  cases::Case theirs = bar(8);
  theirs.scheme.code = "my-code", theirs.scheme.code_version = "1.0", theirs.scheme.adapter = "a";
  {
    Store store(file_, Store::Mode::create_or_write);
    keep(store, "d1", 1);
    keep(store, "d1", 1, theirs, records::OtherCode{"my-code", "1.0", "", "reference", "a"});
    keep(store, "d2", 2);
  }
  cases::Case alone = theirs;
  alone.resolution.cells = 16;
  Store(file_, Store::Mode::write)
      .keep(
          [&] {
            records::Record scored = record(16);
            scored.the_case = alone;
            return scored;
          }(),
          provenance("d1"));
  const Store::Pruned pruned = Store::prune(file_, 1, "d2");
  EXPECT_EQ(pruned.studies, 1);
  EXPECT_EQ(pruned.records, 1);
  EXPECT_EQ(pruned.versions.size(), 1U);
  EXPECT_THAT(Store::prune(file_, 1, "d2").versions, IsEmpty()) << "it has no studies of its own any more";
  const Store store(file_, Store::Mode::read);
  const std::vector<Version> versions = store.versions_of_code("my-code");
  ASSERT_EQ(versions.size(), 1U);
  EXPECT_EQ(store.studies_of_code("my-code", versions[0]).at(0).series.at(0).points.size(), 1U);
  EXPECT_FALSE(store.find(bar(8), "d1"));
  EXPECT_TRUE(store.find(alone, "d1")) << "a score, of which no study knows";
  EXPECT_THAT(store.check(), IsEmpty());
}

TEST_F(Pruning, KnowsStudiesOfCodesThatAnOlderProgramKept) {
  {
    Store store(file_, Store::Mode::create_or_write);
    keep(store, "d1", 1, bar(8), records::OtherCode{"my-code", "1.0", "", "reference", ""});
    keep(store, "d2", 2);
  }
  const Store::Pruned pruned = Store::prune(file_, 1, "d2");
  EXPECT_THAT(pruned.versions, IsEmpty());
  EXPECT_EQ(Store(file_, Store::Mode::read).studies("d1").size(), 1U);
}

TEST_F(Pruning, ShrinksTheFileAndRemovesNothingWhereAllIsKept) {
  {
    Store store(file_, Store::Mode::create_or_write);
    for (int day = 1; day <= 9; ++day) {
      keep(store, fmt::format("d{}", day), day);
      records::Record large = record(16);
      large.reason = std::string(100'000, '.');
      store.keep(large, provenance(fmt::format("d{}", day)));
    }
  }
  const Store::Pruned nothing = Store::prune(file_, 9, "d9");
  EXPECT_THAT(nothing.versions, IsEmpty());
  EXPECT_EQ(nothing.studies + nothing.records, 0);
  const auto before = std::filesystem::file_size(file_);
  const Store::Pruned most = Store::prune(file_, 1, "d9");
  EXPECT_EQ(most.versions.size(), 8U);
  EXPECT_GT(most.bytes, 800'000);
  EXPECT_EQ(before - std::filesystem::file_size(file_), static_cast<std::size_t>(most.bytes));
}

}  // namespace mpmvv::store::prune_test
