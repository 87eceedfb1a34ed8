#include <gmock/gmock.h>

#include "tests/numbers.hpp"
#include "tests/studies/store/store_samples.hpp"
#include "tests/studies/store/study_text.hpp"

namespace mpmvv::store::store_study_test {

using fits::FloorFit;
using fits::ObservedOrder;
using records::PartVerdict;
using records::Series;
using records::StudyResult;
using support::not_measured;

using namespace store_samples;
using study_text::Text;
using testing::IsEmpty;
using testing::SizeIs;

/// The point that a run of this record makes.
records::Point point_of(const records::Record& r) {
  records::Point p{
      .x = static_cast<double>(r.the_case.resolution.cells), .status = r.status, .reason = r.reason, .y = {}};
  const auto add = [&](const char* name, double value) {
    if (!std::isnan(value)) p.y[name] = value;
  };
  add("l1", r.error.l1);
  add("l2", r.error.l2);
  add("linf", r.error.linf);
  add("l1_all_steps", r.error.l1_all_steps);
  add("l2_all_steps", r.error.l2_all_steps);
  add("linf_all_steps", r.error.linf_all_steps);
  add("nodal_l1", r.error.nodal_l1);
  add("nodal_l2", r.error.nodal_l2);
  add("nodal_linf", r.error.nodal_linf);
  add("velocity_error", r.error.velocity);
  add("stress_error", r.error.stress);
  add("mass_change", r.balance.mass);
  add("momentum_change", r.balance.momentum);
  add("angular_momentum_change", r.balance.angular_momentum);
  add("wall_seconds", r.wall_seconds);
  add("ns_per_particle_step", r.ns_per_particle_step);
  add("images", r.images);
  add("kinetic", r.energy.kinetic);
  add("strain", r.energy.strain);
  add("initial_total", r.energy.initial_total);
  add("particles", static_cast<double>(r.particles));
  add("steps", static_cast<double>(r.steps));
  add("dt", r.the_case.resolution.dt);
  add("cfl", r.cfl);
  return p;
}

records::Record unstable(int cells) {
  records::Record r = record(cells);
  r.status = records::Status::unstable;
  r.reason = "NaN at step 2";
  r.error = {.linf_all_steps = 7};
  r.energy = {};
  return r;
}

ObservedOrder order_with_floor() {
  return {.norm = "l2",
          .from = 8,
          .to = 1.0 / 3,
          .points = 5,
          .order = 1.97,
          .half_width = 0.01,
          .constant = 3e-17,
          .r_squared = 0.999,
          .asymptotic = true,
          .asymptotic_from = 16,
          .asymptotic_to = 64,
          .segments = {{8, 16, 1.9}, {16, 32, not_measured}},
          .floor = FloorFit{1, 2, 1e-4, 0.01, true, "small and clearly below"},
          .replicates = fits::ReplicateFit{25, 0.04, not_measured, 0.3}};
}

ObservedOrder order_without_values(std::optional<FloorFit> floor) {
  ObservedOrder order;
  order.norm = "linf";
  order.floor = std::move(floor);
  return order;
}

Series runs() {
  Series s = series("runs", {point_of(record(8)), point_of(unstable(16))});
  s.orders = {order_with_floor(), order_without_values(FloorFit{})};
  return s;
}

Series curve() {
  Series s = series("curve", {point(0.25, {{"y", 1}, {"z", not_measured}}), point(not_measured)});
  s.points.back().status = records::Status::failed;
  s.points.back().reason = "no value";
  s.orders = {order_without_values(std::nullopt)};
  s.limit = fits::StabilityLimit{.key = "cfl",
                                 .stable = 0.9,
                                 .unstable = not_measured,
                                 .monotone = false,
                                 .found = true,
                                 .probes = {{0.5, true, ""}, {1.1, false, "energy"}}};
  s.points.front().replicates = {{"y", {0.9, 1.1}}, {"z", {not_measured}}};
  s.extrapolations = {{"y", 4, 64, 5, "φ0 + α h", 1.1, -0.5, 1e-3, 0.02, 1.0 / 3, not_measured, "not monotone"},
                      {"z", 1, 2, 0, "none", not_measured, not_measured}};
  s.code = {{"karamelo", "2.0", "", "per-particle"}};
  return s;
}

Series limit_without_probes() {
  Series s = series("limit without probes");
  s.limit.emplace().key = "smoothing_length";
  return s;
}

records::Figure full_figure() {
  return {.name = "s-fig10",
          .caption = "Fig. 10",
          .xlabel = "cells",
          .ylabel = "error",
          .log_x = true,
          .log_y = false,
          .quantity = "linf",
          .series = {"runs", "curve"},
          .marks = {"curve"},
          .slopes = {1, 2.5},
          .x_min = 4,
          .x_max = std::nullopt,
          .y_min = std::nullopt,
          .y_max = 0,
          .kind = records::Figure::Kind::particles};
}

StudyResult everything() {
  return {.name = "everything",
          .title = "All of it — é",
          .kind = records::StudyKind::convergence,
          .sweep = "cells",
          .text = "title = \"All\"\n# 'quoted'; DROP TABLE runs\n",
          .claims = {"S-fig10", "S-fig11"},
          .series = {runs(), series("empty"), curve(), limit_without_probes()},
          .values = {{"sum", 1 + 1e-15, "ΣN"}, {"unknown", not_measured, ""}},
          .figures = {full_figure(), records::Figure{}},
          .parts = {{"S-fig10",
                     "order 2",
                     PartVerdict::holds,
                     "1.97",
                     "",
                     "order",
                     1.9,
                     2.1,
                     {{"of 'runs'", 1.97, 1.9, 2.04, "finest segment 1.8"}}},
                    {"S-fig11",
                     "flat",
                     PartVerdict::fails,
                     "0.3",
                     "round-off",
                     "error",
                     {},
                     0.1,
                     {{"'runs' at 8", 0.3},
                      {"at 16", infinity},
                      {"at 32", -infinity},
                      {"at 64", not_measured},
                      {"below", 0.5, -infinity, 0.5},
                      {"anywhere", 1, -infinity, infinity}}},
                    {"S-fig11", "look", PartVerdict::shown, "", "", "shown"},
                    {"S-fig11", "limit", PartVerdict::inconclusive, "", ""}},
          .statements = {{"S-fig10", "bar: O(h²)", "Steffen et al. 2008", "Fig. 10", "everything"}}};
}

const std::vector<std::vector<cases::Case>> cases_of_everything{{bar(8), bar(16)}};

class StoredStudyTest : public StoreTest {
 protected:
  void SetUp() override {
    store_.emplace(file_, Store::Mode::create_or_write);
    store_->keep(record(8), provenance());
    store_->keep(unstable(16), provenance());
  }

  std::optional<Store> store_;
};

TEST_F(StoredStudyTest, ComesBackExactlyAsItWasKept) {
  store_->keep_study(everything(), cases_of_everything, provenance());
  EXPECT_EQ(Text::of(store_->studies("d1")), Text::of(std::vector{everything()}));
}

TEST_F(StoredStudyTest, ComesBackFromAnotherConnection) {
  store_->keep_study(everything(), cases_of_everything, provenance());
  EXPECT_EQ(Text::of(Store(file_, Store::Mode::read).studies("d1")), Text::of(std::vector{everything()}));
}

TEST_F(StoredStudyTest, SurvivesAMerge) {
  store_->keep_study(everything(), cases_of_everything, provenance());
  EXPECT_EQ(Store::merge(folder_ / "other.db", file_), 2);
  const Store other(folder_ / "other.db", Store::Mode::read);
  EXPECT_EQ(Text::of(other.studies("d1")), Text::of(std::vector{everything()}));
  EXPECT_EQ(other.study_provenance("everything", "d1")->time, provenance().time);
}

TEST_F(StoredStudyTest, InfinityComesBackAsNaN) {
  StudyResult s = study("s", "", {series("a", {point(infinity, {{"y", -infinity}})})});
  store_->keep_study(s, {}, provenance());
  s.series[0].points[0] = point(not_measured, {{"y", not_measured}});
  EXPECT_EQ(Text::of(store_->studies("d1")), Text::of(std::vector{s}));
}

TEST_F(StoredStudyTest, AValueOfACheckMayBeInfinite) {
  StudyResult s = study("s");
  s.values = {{"gap", infinity, ""}, {"slope", -infinity, ""}, {"sum", not_measured, ""}};
  store_->keep_study(s, {}, provenance());
  EXPECT_EQ(Text::of(store_->studies("d1")), Text::of(std::vector{s}));
}

TEST_F(StoredStudyTest, APointKeepsWhatItHasBeyondItsRun) {
  StudyResult s = study("cost", "", {series("a", {point_of(record(8))})});
  s.series[0].points[0].y["wall_seconds"] = 42;
  s.series[0].points[0].y["median_of"] = 5;
  store_->keep_study(s, {{bar(8)}}, provenance());
  EXPECT_EQ(Text::of(store_->studies("d1")), Text::of(std::vector{s}));
}

TEST_F(StoredStudyTest, IsReplacedForItsOwnDigestOnly) {
  StudyResult s = everything();
  store_->keep_study(s, cases_of_everything, provenance("d1"));
  store_->keep_study(study(s.name, "of d2"), {}, provenance("d2"));
  s.title = "again";
  s.series.pop_back();
  Provenance later = provenance("d1");
  later.time = "2025-01-01T00:00:00Z";
  later.dirty = false;
  store_->keep_study(s, cases_of_everything, later);
  EXPECT_EQ(Text::of(store_->studies("d1")), Text::of(std::vector{s}));
  EXPECT_EQ(store_->studies("d2").at(0).title, "of d2");
  EXPECT_EQ(store_->study_provenance(s.name, "d1")->time, later.time);
  EXPECT_FALSE(store_->study_provenance(s.name, "d1")->dirty);
  EXPECT_THAT(store_->check(), IsEmpty());
}

TEST_F(StoredStudyTest, StudiesComeInNameOrder) {
  for (const char* name : {"b", "c", "a"}) store_->keep_study(study(name), {}, provenance());
  const std::vector<StudyResult> studies = store_->studies("d1");
  ASSERT_THAT(studies, SizeIs(3));
  EXPECT_EQ(studies[0].name + studies[1].name + studies[2].name, "abc");
  EXPECT_THAT(store_->studies("d9"), IsEmpty());
}

TEST_F(StoredStudyTest, ProvenanceComesBackWhole) {
  store_->keep_study(study("s"), {}, provenance());
  const Provenance found = store_->study_provenance("s", "d1").value();
  const auto& [digest, commit, dirty, compiler, flags, build_type, cpu, time] = found;
  EXPECT_EQ(digest, "d1");
  EXPECT_EQ(commit, "c0ffee");
  EXPECT_TRUE(dirty);
  EXPECT_EQ(compiler, "GNU 12.2.0");
  EXPECT_EQ(flags, "-O3");
  EXPECT_EQ(build_type, "Release");
  EXPECT_EQ(cpu, "A \"fast\", one");
  EXPECT_EQ(time, "2024-05-06T07:08:09Z");
  EXPECT_FALSE(store_->study_provenance("s", "d2"));
  EXPECT_FALSE(store_->study_provenance("t", "d1"));
}

TEST_F(StoredStudyTest, AStudyWhoseRunIsMissingIsRefusedWhole) {
  store_->keep_study(study("s", "old"), {}, provenance());
  const StudyResult s = study("s", "new", {series("a", {point(99)})});
  try {
    store_->keep_study(s, {{bar(99)}}, provenance());
    ADD_FAILURE() << "it is kept";
  } catch (const support::UsageError& e) {
    EXPECT_THAT(e.what(), testing::StartsWith("a run of this study is not in the store, where `mpmvv db prune` may"));
  }
  EXPECT_EQ(store_->studies("d1").at(0).title, "old");
}

}  // namespace mpmvv::store::store_study_test
