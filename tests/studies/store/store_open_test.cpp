#include <fmt/format.h>
#include <gmock/gmock.h>

#include "studies/store/schema.hpp"
#include "studies/store/seal.hpp"
#include "tests/studies/store/store_samples.hpp"
#include "tests/walk.hpp"

namespace mpmvv::store::store_open_test {

using namespace store_samples;
using Mode = Store::Mode;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class StoreOpen : public StoreTest {
 protected:
  std::string complaint_of_opening(Mode mode) const {
    return complaint([&] { Store(file_, mode); });
  }

  /// Every mode refuses the file with this text, in one line that names it, and leaves every byte as it is.
  void expect_refused(const std::string& text) const {
    const std::string before = bytes_of(file_);
    for (const Mode mode : {Mode::read, Mode::write, Mode::create_or_write})
      EXPECT_THAT(complaint_of_opening(mode), AllOf(HasSubstr(file_.string()), HasSubstr(text), Not(HasSubstr("\n"))));
    EXPECT_EQ(bytes_of(file_), before);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << "something was left behind";
  }

  void open_and_close(Mode mode) const { const Store store(file_, mode); }
  void create() const { open_and_close(Mode::create_or_write); }
  void execute(const std::string& statements) const { Database(file_, Database::Access::create).execute(statements); }
};

TEST_F(StoreOpen, AnAbsentStoreIsMadeOnlyWhereThatIsAsked) {
  EXPECT_THAT(complaint_of_opening(Mode::read), HasSubstr("no results store"));
  EXPECT_THAT(complaint_of_opening(Mode::write), HasSubstr("no results store"));
  EXPECT_FALSE(std::filesystem::exists(file_));
  EXPECT_EQ(complaint_of_opening(Mode::create_or_write), "");
  EXPECT_EQ(complaint_of_opening(Mode::read), "");
}

TEST_F(StoreOpen, AnAbsentFolderIsNotMade) {
  file_ = folder_ / "absent" / "results.db";
  EXPECT_THAT(complaint_of_opening(Mode::create_or_write), HasSubstr("no folder"));
  EXPECT_FALSE(std::filesystem::exists(file_.parent_path()));
}

TEST_F(StoreOpen, APlaceThatTheSystemRefusesIsNotTakenForAbsent) {
  file_ = folder_ / std::string(300, 'x');
  for (const Mode mode : {Mode::read, Mode::write, Mode::create_or_write})
    EXPECT_EQ(complaint_of_opening(mode), fmt::format("results store '{}' cannot be used: File name too long (a file "
                                                      "that can be reached)",
                                                      file_.string()));
}

TEST_F(StoreOpen, TheStoreSaysWhoseItIs) {
  create();
  EXPECT_EQ(bytes_of(file_).substr(68, 4), "MPMV");
}

TEST_F(StoreOpen, AnEmptyFileBecomesAStoreOnlyWhereThatIsAsked) {
  const std::ofstream empty(file_);
  EXPECT_THAT(complaint_of_opening(Mode::read), HasSubstr("is empty"));
  EXPECT_THAT(complaint_of_opening(Mode::write), HasSubstr("is empty"));
  EXPECT_EQ(bytes_of(file_), "");
  EXPECT_EQ(complaint_of_opening(Mode::create_or_write), "");
  EXPECT_EQ(complaint_of_opening(Mode::write), "");
}

TEST_F(StoreOpen, ATextIsRefused) {
  std::ofstream(file_) << "x\n";
  expect_refused("no SQLite file");
  std::ofstream(file_) << std::string(10'000, 'x');
  expect_refused("no SQLite file");
}

TEST_F(StoreOpen, AnotherApplicationsFileIsRefused) {
  execute("CREATE TABLE t (a)");
  expect_refused("another application's");
  execute("PRAGMA application_id = 7");
  expect_refused("another application's");
}

TEST_F(StoreOpen, AnotherApplicationsWriteAheadLogIsLeftAlone) {
  execute("PRAGMA journal_mode = WAL; CREATE TABLE t (a)");
  expect_refused("another application's");
}

TEST_F(StoreOpen, ANewerSchemaIsRefused) {
  create();
  execute("PRAGMA user_version = 99");
  expect_refused("schema 99");
}

TEST_F(StoreOpen, ASchemaThatItsTablesDoNotHaveIsRefused) {
  create();
  for (const int schema : {-1, -2'147'483'647, 0, 1, static_cast<int>(migrations().size()) - 1}) {
    execute(fmt::format("PRAGMA user_version = {}", schema));
    expect_refused("is damaged");
  }
}

TEST_F(StoreOpen, AStoreThatLacksTablesOrColumnsIsRefused) {
  for (const char* loss : {"DROP TABLE check_values", "ALTER TABLE runs DROP COLUMN wall_seconds",
                           "ALTER TABLE probes RENAME TO probe", "ALTER TABLE points RENAME COLUMN x TO y"}) {
    std::filesystem::remove(file_);
    create();
    execute(loss);
    expect_refused("is damaged: table");
  }
}

TEST_F(StoreOpen, WhatOthersPutBesideTheTablesIsTheirs) {
  create();
  execute("CREATE VIEW fine AS SELECT * FROM runs; CREATE TABLE notes (a); CREATE INDEX fast ON runs (l2)");
  EXPECT_EQ(complaint_of_opening(Mode::create_or_write), "");
  EXPECT_THAT(Store(file_, Mode::read).check(), testing::IsEmpty());
}

TEST_F(StoreOpen, SomethingThatIsNoFileIsRefused) {
  EXPECT_THAT(complaint([&] { Store(folder_, Mode::create_or_write); }), HasSubstr("is not a file"));
  EXPECT_THAT(complaint([] { Store("/dev/full", Mode::create_or_write); }), HasSubstr("is not a file"));
  EXPECT_THAT(complaint([] { Store("", Mode::create_or_write); }), HasSubstr("no name"));
}

TEST_F(StoreOpen, NamesThatSQLiteTreatsSpeciallyAreFiles) {
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
  EXPECT_EQ(complaint([] { Store(":memory:", Mode::create_or_write); }), "");
  EXPECT_TRUE(std::filesystem::exists(folder_ / ":memory:"));
  std::filesystem::current_path(here);
}

TEST_F(StoreOpen, OpeningForWritingChangesNothing) {
  Store(file_, Mode::create_or_write).keep(record(8), provenance());
  const std::string before = bytes_of(file_);
  for (const Mode mode : {Mode::create_or_write, Mode::write}) open_and_close(mode);
  EXPECT_EQ(bytes_of(file_), before);
}

TEST_F(StoreOpen, AStoreOpenForReadingKeepsNothing) {
  create();
  Store store(file_, Mode::read);
  EXPECT_THAT(complaint([&] { store.keep(record(8), provenance()); }), HasSubstr("read-only"));
  EXPECT_FALSE(store.find(bar(8), "d1"));
}

constexpr std::array two_steps{"CREATE TABLE a (x)", "CREATE TABLE b (x); INSERT INTO b VALUES (1)"};
constexpr std::array broken_second_step{"CREATE TABLE a (x)", "CREATE TABLE b (x); nonsense"};

TEST_F(StoreOpen, AnOlderSchemaIsBroughtUpToDateByWritingOnly) {
  open_store(file_, Mode::create_or_write, std::span(two_steps).first(1)).execute("INSERT INTO a VALUES (5)");
  EXPECT_THAT(complaint([&] { open_store(file_, Mode::read, two_steps); }),
              AllOf(HasSubstr("older schema 1"), HasSubstr("`mpmvv db update` brings it up to date")));
  const Database database = open_store(file_, Mode::write, two_steps);
  EXPECT_EQ(database.scalar("PRAGMA user_version").integer(), 2);
  EXPECT_EQ(database.scalar("SELECT a.x + b.x FROM a, b").integer(), 6);
}

TEST_F(StoreOpen, AStudyIsLookedUpInAnOlderStoreAsItIs) {
  open_store(file_, Mode::create_or_write, migrations().first(1))
      .execute(
          "INSERT INTO provenance VALUES (3, 'd1', 'c0ffee', 0, '', '', '', '');"
          "INSERT INTO studies VALUES (5, 's', 'd1', 3, '', '', '', '', '')");
  const std::string before = bytes_of(file_);
  Store::require_study(file_, "s");
  EXPECT_THAT(complaint([&] { Store::require_study(file_, "t"); }), HasSubstr("unknown study 't'"));
  EXPECT_EQ(bytes_of(file_), before);
}

TEST_F(StoreOpen, AMigrationThatFailsLeavesTheStoreAsItWas) {
  open_store(file_, Mode::create_or_write, std::span(two_steps).first(1));
  const std::string before = bytes_of(file_);
  EXPECT_NE(complaint([&] { open_store(file_, Mode::write, broken_second_step); }), "");
  EXPECT_EQ(bytes_of(file_), before);
}

TEST_F(StoreOpen, AnOlderStoreIsSealedAsItIsBroughtUpToDate) {
  open_store(file_, Mode::create_or_write, migrations().first(first_sealed_schema - 1))
      .execute(
          "INSERT INTO provenance VALUES (3, 'd1', 'c0ffee', 0, '', '', '', '');"
          "INSERT INTO studies VALUES (5, 's', 'd1', 3, '', '', '', '', '')");
  EXPECT_THAT(Store(file_, Mode::write).check(), testing::IsEmpty());
  execute("UPDATE provenance SET git_commit = 'c0ffef'");
  EXPECT_THAT(Store(file_, Mode::read).check(), testing::ElementsAre(HasSubstr("row 5 of studies (s)")));
}

/// Sealed before there were claims in words and numbers that criteria found.
TEST_F(StoreOpen, ASealOfSchema10StillHolds) {
  open_store(file_, Mode::create_or_write, migrations().first(10))
      .execute(
          "INSERT INTO provenance VALUES (3, 'd1', 'c0ffee', 0, '', '', '', '');"
          "INSERT INTO studies VALUES (5, 's', 'd1', 3, '', '', 'convergence', '', '', -9156888797369232665);"
          "INSERT INTO study_claims VALUES (5, 0, 'S-fig10');"
          "INSERT INTO claim_parts VALUES (5, 0, 'S-fig10', 'flat', 'holds', '= 1', '')");
  EXPECT_THAT(Store(file_, Mode::write).check(), testing::IsEmpty());
  const records::StudyResult study = Store(file_, Mode::read).studies("d1").at(0);
  EXPECT_THAT(study.claims, testing::ElementsAre("S-fig10"));
  EXPECT_THAT(study.statements, testing::IsEmpty());
  EXPECT_THAT(study.parts.at(0).found, testing::IsEmpty());
  EXPECT_EQ(study.parts[0].at_least, std::nullopt);
}

/// Schemas 5 to 8 had tables for mutation testing.
TEST_F(StoreOpen, AnOlderStoreOpensWithoutItsMutants) {
  constexpr std::size_t last_with_mutants = 8;
  open_store(file_, Mode::create_or_write, migrations().first(last_with_mutants))
      .execute(
          "INSERT INTO provenance VALUES (3, 'd1', 'c0ffee', 0, '', '', '', '');"
          "INSERT INTO mutants VALUES (5, 'sign', 'd1', 3, '', 'g', 'planted', '', 'a.hpp', 1, '+', '-', 1, 7);"
          "INSERT INTO mutant_trials VALUES (5, 'quick', 1, 'golden', 1.5)");
  Store(file_, Mode::write).keep(record(8), provenance());
  const Store store(file_, Mode::read);
  EXPECT_THAT(store.check(), testing::IsEmpty());
  EXPECT_TRUE(store.find(bar(8), "d1"));
}

/// Of which a study was kept once for each digest: its table is made anew, and what belongs to it stays.
TEST_F(StoreOpen, AStoreOfSchema14KeepsItsStudies) {
  open_store(file_, Mode::create_or_write, migrations().first(14))
      .execute(
          "INSERT INTO provenance VALUES (3, 'd1', 'c0ffee', 0, '', '', '', '');"
          "INSERT INTO studies VALUES (5, 's', 'd1', 3, 't', 'T', 'convergence', 'cells', '', NULL);"
          "INSERT INTO series VALUES (7, 5, 0, 'a', 'mine', '1.3', '', 'none');"
          "INSERT INTO points (id, series, ordinal, x, status, reason) VALUES (9, 7, 0, 8, 'ok', '')");
  {
    Database old(file_, Database::Access::write);
    seal(old, Sealed::study, 5);
    old.execute("CREATE VIEW mine AS SELECT name FROM studies; CREATE INDEX of_mine ON studies (title)");
  }
  Database database = open_store(file_, Mode::write);
  EXPECT_EQ(database.scalar("SELECT name FROM mine").text(), "s");
  EXPECT_FALSE(database.scalar("SELECT 1 FROM sqlite_schema WHERE name = 'of_mine'").null()) << "another's index went";
  EXPECT_THAT(Store(file_, Mode::read).check(), testing::IsEmpty());
  EXPECT_EQ(Store(file_, Mode::read).studies("d1").at(0).series.at(0).points.at(0).x, 8);
  database.execute("DELETE FROM studies");
  EXPECT_EQ(database.scalar("SELECT count(*) FROM points").integer(), 0) << "foreign keys are on again";
}

/// Which does not say how many threads shared a run, nor what it cost in each round.
TEST_F(StoreOpen, ARunOfSchema15HadOneThread) {
  open_store(file_, Mode::create_or_write, migrations().first(15))
      .execute(fmt::format(
          "INSERT INTO provenance VALUES (3, 'd1', 'c0ffee', 0, '', '', '', '');"
          "INSERT INTO runs (case_text, digest, provenance, kept_at, problem, basis, integrator, velocity_update, "
          "boundary, cells, ppc, dt, end_time, particles, steps, status, reason, wall_seconds) "
          "VALUES ('{}', 'd1', 3, '', 'bar', 'bspline2', 'cd', 'flip', '', 8, 4, 0.1, 0.3, 32, 3, 'ok', '', 96)",
          cases::canonical_text(bar(8))));
  {
    Database old(file_, Database::Access::write);
    seal(old, Sealed::run, 1);
  }
  const Store store(file_, Mode::write);
  EXPECT_EQ(store.find(bar(8), "d1").value().threads, 1);
  EXPECT_EQ(store.find(bar(8), "d1")->cost.rounds, fits::Rounds{});
  EXPECT_EQ(store.last_seconds(bar(8)), 96);
  EXPECT_EQ(store.step_costs().begin()->second, 1);
}

/// Which does not say where a number that was found may lie.
TEST_F(StoreOpen, AFoundNumberOfSchema17HasNoInterval) {
  open_store(file_, Mode::create_or_write, migrations().first(17))
      .execute(
          "INSERT INTO provenance VALUES (3, 'd1', 'c0ffee', 0, '', '', '', '');"
          "INSERT INTO studies VALUES (5, 's', 'd1', 3, '', '', 'convergence', '', '', NULL, NULL);"
          "INSERT INTO claim_parts VALUES (5, 0, 'S-fig10', 'flat', 'holds', '= 1', '', 'order', 0, 2);"
          "INSERT INTO claim_found VALUES (5, 0, 0, 'order', 1, NULL)");
  {
    Database old(file_, Database::Access::write);
    seal(old, Sealed::study, 5);
  }
  const Store store(file_, Mode::write);
  EXPECT_THAT(store.check(), testing::IsEmpty());
  const records::Found found = store.studies("d1").at(0).parts.at(0).found.at(0);
  EXPECT_EQ(found.lower, 1);
  EXPECT_EQ(found.upper, 1);
}

/// The page on a number of one's own says its schema: that it is an old one, the slow tests alone would find.
TEST(Schema, OfANumberOfOnesOwnIsTheNextOne) {
  EXPECT_THAT(walk("number-entry"), HasSubstr(fmt::format("({}, ", migrations().size() + 1)));
}

TEST_F(StoreOpen, AStoreThatIsMovedAwayWhileItIsOpenTakesNothingMore) {
  Store store(file_, Mode::create_or_write);
  std::filesystem::rename(file_, folder_ / "elsewhere.db");
  EXPECT_THAT(complaint([&] { store.keep(record(8), provenance()); }), HasSubstr("was moved or removed"));
}

TEST_F(StoreOpen, ACreationThatFailsLeavesNoFile) {
  EXPECT_NE(complaint([&] { open_store(file_, Mode::create_or_write, broken_second_step); }), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace mpmvv::store::store_open_test
