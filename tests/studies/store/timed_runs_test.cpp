#include <gmock/gmock.h>

#include "studies/store/store.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::store::timed_runs_test {

using records::Record;
using records::Status;

using namespace store_samples;
using TimedRuns = StoreTest;

TEST_F(TimedRuns, MadeAnewReplaceThoseBefore) {
  Store store(file_, Store::Mode::create_or_write);
  const auto timed = [](const std::string& session, Status status = Status::ok) {
    Record r = record(8);
    r.status = status;
    if (status == Status::ok) r.cost.rounds = {{1, 2, 3}, session};
    return r;
  };
  const auto kept = [&] { return store.find(record(8).the_case, "d1").value().cost.rounds.session; };
  for (const char* session : {"first", "second"}) {
    store.keep(timed(session), provenance());
    EXPECT_EQ(kept(), session);
  }
  Record killed = timed("", Status::failed);
  killed.failure = records::Failure::of_machine;
  store.keep(killed, provenance());
  EXPECT_EQ(kept(), "second") << "the machine says nothing of the case";
  store.keep(timed("", Status::failed), provenance());
  EXPECT_EQ(store.find(record(8).the_case, "d1").value().status, Status::failed) << "it can be timed no more";
  EXPECT_EQ(kept(), "");
  store.keep(timed("second"), provenance());
  EXPECT_EQ(kept(), "second");
  EXPECT_THAT(store.check(), testing::IsEmpty());
  Store(folder_ / "other.db", Store::Mode::create_or_write).keep(timed("third"), provenance());
  Store::merge(file_, folder_ / "other.db");
  EXPECT_EQ(kept(), "second") << "of two stores the first counts";
  Store::merge(folder_ / "merged.db", file_);
  EXPECT_EQ(Store(folder_ / "merged.db", Store::Mode::read).find(record(8).the_case, "d1")->cost.rounds,
            timed("second").cost.rounds);
}

/// The run of the first store stays, and the study of the second one: its cost is not what the run was timed at.
TEST_F(TimedRuns, OfAMergeLendTheirRoundsToNoOtherCost) {
  for (const double cost : {1, 2}) {
    Record r = record(8);
    r.ns_per_particle_step = cost;
    r.cost.rounds = {{cost, cost}, fmt::format("session {}", cost)};
    Provenance p = provenance();
    p.time = fmt::format("2024-05-0{}T07:08:09Z", cost);
    Store store(folder_ / fmt::format("{}.db", cost), Store::Mode::create_or_write);
    store.keep(r, p);
    store.keep_study(study("timed", "", {series("a", {point(8, {{"ns_per_particle_step", cost}})})}), {{bar(8)}}, p);
    EXPECT_EQ(store.studies("d1")[0].series[0].points[0].rounds, r.cost.rounds);
  }
  Store::merge(folder_ / "1.db", folder_ / "2.db");
  const Store merged(folder_ / "1.db", Store::Mode::read);
  EXPECT_EQ(merged.find(bar(8), "d1")->cost.rounds.session, "session 1");
  const records::Point timed = merged.studies("d1")[0].series[0].points[0];
  EXPECT_EQ(timed.y.at("ns_per_particle_step"), 2);
  EXPECT_THAT(timed.rounds.costs, testing::IsEmpty());
}

}  // namespace mpmvv::store::timed_runs_test
