#include "studies/store/store.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "studies/store/schema.hpp"
#include "tests/numbers.hpp"
#include "tests/studies/count_members.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::store::store_test {

using records::Failure;
using records::Record;
using records::Status;

using namespace store_samples;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string describe(const Record& r) {
  std::string text = fmt::format("{} {} {} {} {} {} '{}'", cases::canonical_text(r.the_case), r.particles, r.steps,
                                 r.threads, to_string(r.status), to_string(r.failure), r.reason);
  for (const auto* numbers : {&records::run_errors(), &records::run_by_products()})
    for (const records::RunNumber& number : *numbers) text += fmt::format(" {} = {}", number.name, number.get(r));
  return text + fmt::format(" {} {}", fmt::join(r.cost.rounds.costs, " "), r.cost.rounds.session);
}

/// A member that is no number of a run would not be kept.
TEST(RunNumbers, AreAllMembers) {
  using namespace records;
  EXPECT_EQ(std::ssize(run_errors()), count_members<Errors>() + count_members<Balance>());
  constexpr int rounds = 1;         // of the cost
  constexpr int of_the_record = 6;  // wall_seconds, ns_per_particle_step, cfl, images, output_floor, solution_floor
  EXPECT_EQ(std::ssize(run_by_products()), count_members<Energy>() + count_members<Cost>() - rounds + of_the_record);
  // case, particles, steps, threads, status, failure, reason, errors of particles; error, energy, balance, cost
  constexpr int without_a_number = 12;
  EXPECT_EQ(count_members<Record>(), without_a_number + of_the_record);
}

TEST_F(StoreTest, ARecordComesBackWhole) {
  Store store(file_, Store::Mode::create_or_write);
  Record r = record(8);
  r.error = {.l1 = 1,
             .l2 = 0.1,
             .linf = 1.0 / 3,
             .l1_all_steps = 4e-6,
             .l2_all_steps = 5e300,
             .linf_all_steps = 6e-320,
             .nodal_l1 = 0.7,
             .nodal_l2 = 8,
             .nodal_linf = 9e9,
             .velocity = 12.5,
             .stress = 3e7};
  r.balance = {.mass = -1e-3, .momentum = 2e-16, .angular_momentum = 0.4};
  r.cost = {.step_seconds = 0.7, .spread = 0.02, .rounds = {{1.0 / 3, 6e-300, 41}, "17-ab"}};
  r.threads = 8;
  r.status = Status::unstable;
  r.reason = "det F <= 0 at step 7, 'particle' \"3\"\nα";
  store.keep(r, provenance());
  const std::optional<Record> found = store.find(r.the_case, "d1");
  ASSERT_TRUE(found);
  EXPECT_EQ(describe(*found), describe(r));
}

/// With five digits.
TEST_F(StoreTest, ErrorsOfParticlesComeBack) {
  Store store(file_, Store::Mode::create_or_write);
  Record r = record(8);
  r.particle_errors = {{0.25, -1.5, 3e-6}, {1.0 / 3, 0, 0}};
  store.keep(r, provenance());
  const auto found = store.find(r.the_case, "d1").value().particle_errors;
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].y, -1.5);
  EXPECT_EQ(found[0].error, 3e-6);
  EXPECT_NEAR(found[1].x, 1.0 / 3, 1e-5);
  EXPECT_TRUE(store.check().empty());
}

TEST_F(StoreTest, NaNAndInfinityComeBackAsNaN) {
  Store store(file_, Store::Mode::create_or_write);
  Record r = record(8);
  r.error.linf = infinity;
  r.cfl = support::not_measured;
  store.keep(r, provenance());
  const Record found = store.find(r.the_case, "d1").value();
  r.error.linf = support::not_measured;
  EXPECT_EQ(describe(found), describe(r));
}

TEST_F(StoreTest, TheKeyIsTheWholeCaseAndTheDigest) {
  Store store(file_, Store::Mode::create_or_write);
  store.keep(record(8), provenance());
  EXPECT_TRUE(store.find(bar(8), "d1"));
  EXPECT_FALSE(store.find(bar(8), "d2"));
  EXPECT_FALSE(store.find(bar(9), "d1"));
  cases::Case more_measured = bar(8);
  more_measured.measure.every_step = true;
  EXPECT_FALSE(store.find(more_measured, "d1"));
}

TEST_F(StoreTest, TheFirstRecordOfAKeyStays) {
  Store store(file_, Store::Mode::create_or_write);
  Record second = record(8);
  second.wall_seconds = 99;
  store.keep(record(8), provenance());
  store.keep(second, provenance());
  EXPECT_EQ(store.find(bar(8), "d1")->wall_seconds, 1e-3);
}

TEST_F(StoreTest, AFailedRecordGivesWayToOneThatWasCarriedOut) {
  Store store(file_, Store::Mode::create_or_write);
  Record failed = record(8);
  failed.status = Status::failed;
  failed.reason = "out of memory";
  store.keep(failed, provenance());
  EXPECT_EQ(store.find(bar(8), "d1")->status, Status::failed);
  store.keep(record(8), provenance());
  EXPECT_EQ(describe(store.find(bar(8), "d1").value()), describe(record(8)));
  store.keep(failed, provenance());
  EXPECT_EQ(store.find(bar(8), "d1")->status, Status::ok);
}

Record failed(Failure failure) {
  Record r = record(8);
  r.status = Status::failed;
  r.failure = failure;
  return r;
}

TEST_F(StoreTest, AFailureSaysWhoseItIs) {
  EXPECT_EQ(records::failure_of(std::bad_alloc()), Failure::of_machine);
  EXPECT_EQ(records::failure_of(std::system_error(EAGAIN, std::generic_category())), Failure::of_machine);
  EXPECT_EQ(records::failure_of(std::length_error("")), Failure::of_case);
  Store store(file_, Store::Mode::create_or_write);
  for (const Failure failure : {Failure::of_machine, Failure::of_case, Failure::of_machine}) {
    store.keep(failed(failure), provenance());
    const bool was_of_case = failure == Failure::of_case || store.find(bar(8), "d1")->failure == Failure::of_case;
    EXPECT_EQ(describe(store.find(bar(8), "d1").value()),
              describe(failed(was_of_case ? Failure::of_case : Failure::of_machine)));
  }
  EXPECT_EQ(store.find(bar(8), "d1")->failure, Failure::of_case)
      << "one of the machine took the place of one of the case";
  EXPECT_THAT(store.check(), IsEmpty());
}

TEST_F(StoreTest, RecordsOutliveTheStoreObject) {
  Store(file_, Store::Mode::create_or_write).keep(record(8), provenance());
  EXPECT_TRUE(Store(file_, Store::Mode::read).find(bar(8), "d1"));
  EXPECT_TRUE(Store(file_, Store::Mode::write).find(bar(8), "d1"));
  EXPECT_TRUE(Store(file_, Store::Mode::create_or_write).find(bar(8), "d1"));
}

TEST_F(StoreTest, ContentsAreCounted) {
  Store store(file_, Store::Mode::create_or_write);
  Record unstable = record(9);
  unstable.status = Status::unstable;
  store.keep(record(8), provenance("d1"));
  store.keep(unstable, provenance("d2"));
  store.keep_study(study("s"), {}, provenance("d1"));
  const Contents contents = store.contents();
  EXPECT_EQ(contents.schema, static_cast<std::int64_t>(migrations().size()));
  EXPECT_EQ(contents.bytes, static_cast<std::int64_t>(std::filesystem::file_size(file_)));
  EXPECT_EQ(contents.studies, 1);
  EXPECT_EQ(contents.records, 2);
  EXPECT_EQ(contents.ok, 1);
  EXPECT_EQ(contents.unstable, 1);
  EXPECT_EQ(contents.failed, 0);
  ASSERT_EQ(contents.programs.size(), 2U);
  const auto& [digest, commit, dirty, records, last] =
      *std::ranges::find(contents.programs, "d2", [](const auto& p) { return p.digest; });
  EXPECT_EQ(commit, "c0ffee");
  EXPECT_TRUE(dirty);
  EXPECT_EQ(records, 1);
  EXPECT_EQ(last, "2024-05-06T07:08:09Z");
}

TEST_F(StoreTest, CsvHasEveryRecordWith17DigitsAndNaNEmpty) {
  Store store(file_, Store::Mode::create_or_write);
  store.keep(record(8), provenance());
  store.keep(record(16), provenance());
  std::istringstream csv(store.export_csv());
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);) lines.push_back(line);
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_THAT(lines[0], HasSubstr("id,case_text,digest,"));
  EXPECT_THAT(lines[0], HasSubstr("l1,l2,linf,l1_all_steps,l2_all_steps,linf_all_steps,kinetic"));
  EXPECT_THAT(lines[0], HasSubstr("git_commit,dirty,compiler,flags,build_type,cpu"));
  EXPECT_THAT(lines[1], HasSubstr("\"" + cases::canonical_text(bar(8)) + "\",d1,"));
  EXPECT_THAT(lines[1], HasSubstr(",0.012500000000000001,0.025000000000000001,0.037499999999999999,,,,"));
  EXPECT_THAT(lines[2], HasSubstr("c0ffee,1,GNU 12.2.0,'-O3,Release,\"A \"\"fast\"\", one\""));
}

TEST_F(StoreTest, CsvOfNoRecordIsItsHead) {
  Store store(file_, Store::Mode::create_or_write);
  const std::string head = store.export_csv();
  EXPECT_THAT(head, HasSubstr("id,case_text,digest,"));
  store.keep(record(8), provenance());
  EXPECT_THAT(store.export_csv(), testing::StartsWith(head));
}

TEST_F(StoreTest, CheckIsEmptyForASoundStore) {
  Store store(file_, Store::Mode::create_or_write);
  store.keep(record(8), provenance());
  EXPECT_THAT(store.check(), IsEmpty());
}

TEST_F(StoreTest, CheckFindsDamage) {
  {
    Store store(file_, Store::Mode::create_or_write);
    for (int cells = 1; cells <= 30; ++cells) store.keep(record(cells), provenance());
  }
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(file_));
  std::fstream stream(file_, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekp(size - 4 * 4096);
  stream << std::string(4096, 'x');
  stream.close();
  EXPECT_FALSE(Store(file_, Store::Mode::read).check().empty());
}

TEST_F(StoreTest, MergeCopiesWhatIsMissing) {
  const auto other = folder_ / "other.db";
  Store here(file_, Store::Mode::create_or_write);
  Record ours = record(8), theirs = record(8);
  ours.wall_seconds = 1;
  theirs.wall_seconds = 2;
  here.keep(ours, provenance());
  here.keep_study(study("both", "ours"), {}, provenance());
  here.keep_study(study("later", "ours"), {}, provenance());
  Provenance later = provenance();
  later.time = "2999-01-01T00:00:00Z";
  {
    Store there(other, Store::Mode::create_or_write);
    there.keep(theirs, provenance());
    there.keep(record(16), provenance());
    there.keep(record(8), provenance("d2"));
    there.keep_study(study("both", "theirs"), {}, provenance());
    there.keep_study(study("later", "theirs"), {}, later);
    there.keep_study(study("new", "", {series("a", {point(8), point(16)})}), {{bar(8), bar(16)}}, provenance());
  }
  EXPECT_EQ(Store::merge(file_, other), 2);
  EXPECT_EQ(here.find(bar(8), "d1")->wall_seconds, 1);
  EXPECT_EQ(describe(here.find(bar(16), "d1").value()), describe(record(16)));
  EXPECT_EQ(describe(here.find(bar(8), "d2").value()), describe(record(8)));
  const std::vector<records::StudyResult> studies = here.studies("d1");
  ASSERT_THAT(studies, SizeIs(3));
  EXPECT_EQ(studies[0].title, "ours");
  EXPECT_EQ(studies[1].title, "theirs") << "made later";
  EXPECT_EQ(studies[2].series[0].points[1].y.at("l2"), 0.2 / 16);
  EXPECT_EQ(Store::merge(file_, other), 0);
  EXPECT_THAT(complaint([&] { Store::merge(file_, file_); }), HasSubstr("merged into itself"));
  EXPECT_THAT(here.check(), IsEmpty());
}

TEST_F(StoreTest, AForgottenStudyIsGoneInAllVersionsAndItsRunsStay) {
  Store store(file_, Store::Mode::create_or_write);
  for (const char* digest : {"d1", "d2"}) {
    store.keep(record(8), provenance(digest));
    for (const char* name : {"bad name", "other"})
      store.keep_study(study(name, "", {series("a", {point(8)})}), {{bar(8)}}, provenance(digest));
  }
  EXPECT_THAT(complaint([&] { store.forget("absent"); }), HasSubstr("unknown study 'absent'"));
  EXPECT_EQ(store.forget("bad name"), 2U);
  for (const char* digest : {"d1", "d2"}) {
    ASSERT_THAT(store.studies(digest), SizeIs(1));
    EXPECT_EQ(store.studies(digest)[0].name, "other");
    EXPECT_TRUE(store.find(bar(8), digest));
  }
  EXPECT_THAT(store.check(), IsEmpty());
}

TEST_F(StoreTest, MergeOfSomethingElseChangesNothing) {
  Store here(file_, Store::Mode::create_or_write);
  here.keep(record(8), provenance());
  const std::string before = bytes_of(file_);
  std::ofstream(folder_ / "notes.txt") << "not a store";
  EXPECT_THAT(complaint([&] { Store::merge(file_, folder_ / "notes.txt"); }),
              HasSubstr("notes.txt' is not a results store"));
  EXPECT_THAT(complaint([&] { Store::merge(file_, folder_ / "absent.db"); }), HasSubstr("no results store"));
  EXPECT_EQ(bytes_of(file_), before);
}

}  // namespace mpmvv::store::store_test
