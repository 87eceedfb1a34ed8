#include <gmock/gmock.h>

#include "studies/store/trial.hpp"
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

cases::Case bar_by(const std::string& version, const std::string& digest, int cells = 8) {
  cases::Case c = bar(cells);
  c.scheme.code = "my-code", c.scheme.code_version = version, c.scheme.adapter = digest;
  return c;
}

/// A study of our own series and one that this version of a code ran, kept on a day of January.
void keep_by(Store& store, const std::string& version, const std::string& digest, int day, double order) {
  const std::string time = fmt::format("2026-01-{:02}T00:00:00Z", day);
  records::Series theirs = series("theirs", {point(8)});
  theirs.code = records::OtherCode{"my-code", version, "", "reference", digest};
  theirs.orders.resize(1);
  theirs.orders[0].order = order;
  records::Record run = record(8);
  store.keep(run, built("d1", "aaa", time));
  run.the_case = bar_by(version, digest);
  store.keep(run, built("d1", "aaa", time));
  store.keep_study(study("s", "", {series("ours", {point(8)}), theirs}), {{bar(8)}, {bar_by(version, digest)}},
                   built("d1", "aaa", time));
}

class CodeVersions : public StoreTest {
 protected:
  void SetUp() override { store_.emplace(file_, Store::Mode::create_or_write); }
  double order_of(const Version& version) const {
    return store_->studies_of_code("my-code", version).at(0).series.at(0).orders.at(0).order;
  }
  std::optional<Store> store_;
};

TEST_F(CodeVersions, EachKeepsItsOwnResults) {
  EXPECT_THAT(store_->codes(), IsEmpty());
  keep_by(*store_, "1.3", "aa", 1, 2.0);
  keep_by(*store_, "1.3", "bb", 2, 1.1);
  keep_by(*store_, "1.4", "cc", 3, 2.1);
  EXPECT_THAT(store_->codes(), ElementsAre("my-code"));
  const auto versions = store_->versions_of_code("my-code");
  ASSERT_EQ(versions.size(), 3U) << "a change without a new version is one by its digest";
  EXPECT_EQ(label(versions[1]), "1.3 (digest bb)");
  EXPECT_EQ(versions[2].time, "2026-01-03T00:00:00Z");
  for (const auto& [version, order] : {std::pair{0U, 2.0}, {1U, 1.1}, {2U, 2.1}})
    EXPECT_EQ(order_of(versions[version]), order);
  EXPECT_THAT(store_->studies_of_code("my-code", versions[0]).at(0).series, testing::SizeIs(1)) << "not of ours";
  EXPECT_THAT(store_->check(), IsEmpty());
}

/// A part of which nothing could be measured has no number that names a series, but keeps its claim from being
/// confirmed.
TEST_F(CodeVersions, HaveThePartsOfWhichNothingCouldBeMeasured) {
  using records::PartVerdict;
  records::Series theirs = series("theirs", {point(8)});
  theirs.code = records::OtherCode{"my-code", "1.3", "", "reference", "aa"};
  records::StudyResult mixed = study("mixed", "", {series("ours", {point(8)}), theirs}),
                       all = study("all", "", {theirs});
  mixed.claims = all.claims = {"C", "D"};
  mixed.parts = {
      {"C", "first", PartVerdict::holds, "order of 'theirs' = 2", "", "order", 1, 3, {{"order of 'theirs'", 2}}},
      {"C", "ours", PartVerdict::fails, "order of 'ours' = 1", "", "order", 2, 3, {{"order of 'ours'", 1}}},
      {"C", "second", PartVerdict::inconclusive, "'theirs' has no limit", "", "limit", 1, {}, {}},
      {"C", "that 'theirs' costs less", PartVerdict::inconclusive, "no study judges it", "", "awaited"},
      {"D", "third", PartVerdict::inconclusive, "'ours' has no limit", "", "limit", 1, {}, {}}};
  all.parts = {mixed.parts[0], {"D", "fourth", PartVerdict::inconclusive, "the paper has no time", "", "awaited"}};
  store_->keep_study(mixed, {}, built("d1", "aaa", "2026-01-01T00:00:00Z"));
  store_->keep_study(all, {}, built("d1", "aaa", "2026-01-01T00:00:00Z"));
  const auto studies = store_->studies_of_code("my-code", store_->versions_of_code("my-code").at(0));
  const auto statements = [&](std::size_t k) {
    std::vector<std::string> texts;
    for (const records::ClaimPart& part : studies.at(k).parts) texts.push_back(part.statement);
    return texts;
  };
  EXPECT_THAT(statements(0), ElementsAre("first", "fourth")) << "all series are of the code";
  EXPECT_THAT(statements(1), ElementsAre("first", "second", "that 'theirs' costs less"));
  EXPECT_THAT(studies[1].claims, ElementsAre("C"));
}

TEST_F(CodeVersions, WhatIsJudgedIsTheLastOneKept) {
  keep_by(*store_, "1.3", "aa", 1, 2.0);
  keep_by(*store_, "1.4", "cc", 3, 2.1);
  const auto kept = [&] { return store_->studies("d1").at(0).series.at(1).orders.at(0).order; };
  EXPECT_EQ(kept(), 2.1);
  EXPECT_THAT(store_->code_series("d1"), testing::SizeIs(1));
  keep_by(*store_, "1.3", "aa", 5, 2.0);
  EXPECT_EQ(kept(), 2.0);
  EXPECT_EQ(store_->study_provenance("s", "d1")->time, "2026-01-05T00:00:00Z");
  EXPECT_EQ(store_->versions_of_code("my-code").back().commits.front(), "1.3") << "taken up again";
  EXPECT_EQ(store_->forget("s"), 2U);
}

TEST_F(CodeVersions, AreMerged) {
  keep_by(*store_, "1.3", "aa", 1, 2.0);
  const std::filesystem::path other = folder_ / "other.db";
  {
    Store there(other, Store::Mode::create_or_write);
    keep_by(there, "1.3", "aa", 2, 1.0);
    keep_by(there, "1.4", "cc", 3, 2.1);
  }
  keep_by(*store_, "1.4", "cc", 4, 1.9);
  Store::merge(file_, other);
  const auto versions = store_->versions_of_code("my-code");
  ASSERT_EQ(versions.size(), 2U);
  EXPECT_EQ(order_of(versions[0]), 1.0) << "what was kept last stays";
  EXPECT_EQ(order_of(versions[1]), 1.9);
}

/// As on a night on which the code was not there.
TEST_F(CodeVersions, MergingLeavesAStudyThatNoCodeRan) {
  const std::filesystem::path other = folder_ / "other.db";
  {
    Store there(other, Store::Mode::create_or_write);
    keep_by(there, "1.3", "aa", 1, 2.0);
  }
  store_->keep_study(study("s", "without"), {}, built("d1", "aaa", "2026-01-05T00:00:00Z"));
  Store::merge(file_, other);
  EXPECT_EQ(store_->studies("d1").at(0).title, "without") << "the newest";
  EXPECT_THAT(store_->versions_of_code("my-code"), testing::SizeIs(1));
  Store::merge(folder_ / "all.db", file_);
  EXPECT_EQ(Store(folder_ / "all.db", Store::Mode::read).contents().studies, 2);
}

TEST_F(CodeVersions, ATrialHidesNothingAndIsNoVersion) {
  keep_by(*store_, "1.3", "aa", 1, 2.0);
  records::StudyResult trial = study("s", "", {series("theirs")});
  trial.text = with_trial("", "ppc = 4 in 1 of 1 series");
  for (const char* version : {"1.3", "1.4"}) {
    trial.series[0].code = records::OtherCode{"my-code", version, "", "reference", "aa"};
    store_->keep_study(trial, {}, built("d2", "bbb", "2026-01-05T00:00:00Z"));
  }
  const auto versions = store_->versions_of_code("my-code");
  ASSERT_THAT(versions, testing::SizeIs(1));
  EXPECT_EQ(order_of(versions[0]), 2.0);
}

TEST_F(CodeVersions, ACodeThatRanNothingIsRefused) {
  EXPECT_THAT(complaint([&] { store_->versions_of_code("other"); }), HasSubstr("of other codes: none"));
  keep_by(*store_, "1.3", "aa", 1, 2.0);
  EXPECT_THAT(complaint([&] { store_->versions_of_code("other"); }), HasSubstr("of other codes: my-code"));
}

TEST(Label, LeavesWhatACodeSaysOfItself) {
  EXPECT_EQ(label({"0123456789abcdef", {"2026.11-beta-long-name"}, ""}),
            "2026.11-beta-long-name (digest 0123456789ab)");
  EXPECT_EQ(label({"0123456789abcdef", {"fedcba98765432100-dirty"}, ""}), "fedcba987654-dirty (digest 0123456789ab)");
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
