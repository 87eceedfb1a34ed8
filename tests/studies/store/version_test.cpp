#include <gmock/gmock.h>

#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::store::version_test {

using namespace store_samples;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Provenance built(const std::string& digest, const std::string& commit, const std::string& time, bool dirty = false) {
  Provenance p = provenance(digest);
  p.commit = commit;
  p.time = time;
  p.dirty = dirty;
  return p;
}

class Versions : public StoreTest {};

TEST_F(Versions, StandInTheOrderOfTheirFirstResults) {
  Store store(file_, Store::Mode::create_or_write);
  EXPECT_THAT(store.versions(), IsEmpty());
  store.keep_study(study("b"), {}, built("d2", "bbb", "2026-02-01T00:00:00Z"));
  store.keep_study(study("a"), {}, built("d1", "aaa", "2026-01-01T00:00:00Z"));
  store.keep_study(study("c"), {}, built("d1", "ccc", "2026-03-01T00:00:00Z", true));
  store.keep(record(8), built("d3", "ddd", "2026-04-01T00:00:00Z"));
  const auto versions = store.versions();
  ASSERT_EQ(versions.size(), 2U) << "records without a study are no version";
  EXPECT_EQ(versions[0].digest, "d1");
  EXPECT_THAT(versions[0].commits, ElementsAre("aaa", "ccc-dirty"));
  EXPECT_EQ(versions[0].time, "2026-01-01T00:00:00Z");
  EXPECT_EQ(versions[1].digest, "d2");
}

TEST_F(Versions, KeepTheirTimeWhenAStudyIsKeptAgain) {
  Store store(file_, Store::Mode::create_or_write);
  store.keep(record(8), built("d1", "aaa", "2026-01-01T00:00:00Z"));
  for (const char* time : {"2026-01-02T00:00:00Z", "2026-03-01T00:00:00Z"})
    store.keep_study(study("a", "", {series("s", {point(8)})}), {{bar(8)}}, built("d1", "aaa", time));
  EXPECT_EQ(store.versions().at(0).time, "2026-01-01T00:00:00Z");
}

const std::vector<Version> three{
    {"00ff11", {"c0ffee", "beef00"}, ""}, {"00aa22", {"c0ffee-dirty"}, ""}, {"77bb33", {"c0de00"}, ""}};

TEST(FindVersion, TakesAnyPrefixThatNamesOne) {
  EXPECT_EQ(find_version(three, "c0d").digest, "77bb33");
  EXPECT_EQ(find_version(three, "beef").digest, "00ff11") << "a later commit of the same digest";
  EXPECT_EQ(find_version(three, "00a").digest, "00aa22");
  EXPECT_EQ(find_version(three, "c0ffee").digest, "00ff11") << "in full, though another begins so";
}

TEST(FindVersion, SaysWhichThereAre) {
  EXPECT_THAT(complaint([] { find_version(three, "c0f"); }),
              AllOf(HasSubstr("c0ffee (digest 00ff11), c0ffee-dirty (digest 00aa22)"), Not(HasSubstr("c0de00"))));
  EXPECT_THAT(complaint([] { find_version(three, "dead"); }), HasSubstr("c0de00 (digest 77bb33)"));
  EXPECT_THAT(complaint([] { find_version({}, "dead"); }), HasSubstr("none"));
}

}  // namespace mpmvv::store::version_test
