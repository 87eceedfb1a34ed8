#include <gtest/gtest.h>
#include <unistd.h>

#include "studies/codes/readers.hpp"
#include "studies/codes/score.hpp"
#include "studies/runs/norms.hpp"
#include "studies/runs/run_case.hpp"
#include "tests/studies/codes/written_run.hpp"

namespace mpmvv::round_trip_test {

using namespace written_run;
using codes::score;
using records::Record;

/// The numbers of a run that its output can have.
std::vector<std::pair<std::string, double>> numbers(const Record& r) {
  return {{"l1", r.error.l1},
          {"l2", r.error.l2},
          {"linf", r.error.linf},
          {"stress", r.error.stress / 1e3},
          {"mass", r.balance.mass},
          {"momentum", r.balance.momentum},
          {"angular", r.balance.angular_momentum},
          {"kinetic", r.energy.kinetic},
          {"initial", r.energy.initial_total}};
}

void expect_same(const Record& scored, const Record& run, const std::string& what) {
  EXPECT_EQ(scored.status, records::Status::ok) << what << ": " << scored.reason;
  EXPECT_EQ(scored.particles, run.particles);
  EXPECT_EQ(scored.steps, run.steps);
  EXPECT_EQ(scored.cfl, run.cfl);
  const auto a = numbers(scored), b = numbers(run);
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_NEAR(a[k].second, b[k].second, 1e-13 * std::max(1.0, std::abs(b[k].second))) << what << " " << a[k].first;
}

class RoundTrip : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    the_case = square();
    the_run = runs::run_case(the_case, 1);
    end = run<2>(the_case, the_case.resolution.steps);
    start = run<2>(the_case, 0);
  }

  static inline cases::Case the_case;
  static inline Record the_run;
  static inline State start, end;

  static codes::Snapshot read(const std::string& name, const std::string& content, const codes::Columns& columns = {},
                              const std::string& format = "") {
    const auto file = write(name, content);
    const codes::Snapshot s = codes::read_snapshot(file, columns, format);
    std::filesystem::remove(file);
    return s;
  }
};

/// Whatever the format and the order of the particles, by id and by reference position.
TEST_F(RoundTrip, EveryFormatScoresAsTheRunItself) {
  for (const bool by_id : {true, false}) {
    const State s = end.shuffled(by_id ? 1 : 2);
    const auto f = fields(s, by_id, !by_id);
    const std::size_t n = s.size();
    const std::vector<std::pair<std::string, std::string>> files{
        {"text.csv", csv(f, n)},
        {"text.ply", ply(f, n, Bytes::text)},
        {"little.ply", ply(f, n, Bytes::little)},
        {"big.ply", ply(f, n, Bytes::big)},
        {"end.dump", dump(f, n, 10) + dump(f, n, the_case.resolution.steps)},
        {"text.vtu", vtu(f, n, Vtk::text)},
        {"base64.vtu", vtu(f, n, Vtk::base64)},
        {"raw.vtu", vtu(f, n, Vtk::raw)},
        {"zlib.vtu", vtu(f, n, Vtk::zlib)},
        {"appended.vtu", vtu(f, n, Vtk::base64_appended)},
        {"blocks.vtu", vtu(f, n, Vtk::zlib_appended)},
        {"text.vtk", legacy_vtk(f, n, Bytes::text)},
        {"big.vtk", legacy_vtk(f, n, Bytes::big)},
    };
    for (const auto& [name, content] : files) {
      const codes::Snapshot snapshot = read(name, content);
      EXPECT_GE(snapshot.digits, 16) << name;
      expect_same(score(the_case, {.end = snapshot}), the_run, name);
    }
  }
}

TEST_F(RoundTrip, AnArchiveOfNairnInItsUnits) {
  codes::Columns columns;
  columns.length = columns.mass = 1e-3;
  const std::string archive = nairn(end.shuffled(3));
  EXPECT_EQ(*read("nairn.20", archive, columns, "nairn").time, 4);
  const codes::Snapshot snapshot = read("nairn.20", archive, columns, "nairn-legacy");
  EXPECT_NEAR(*snapshot.time, 0.004, 1e-9);
  expect_same(score(the_case, {.end = snapshot}), the_run, "nairn");
}

/// Ids of the code's own, of which the start says where they are.
TEST_F(RoundTrip, IdsOfTheStart) {
  State s = start.shuffled(4), e = end.shuffled(5);
  for (auto* ids : {&s.id, &e.id})
    for (std::int64_t& id : *ids) id = 1000 - 3 * id;
  codes::Output output{.start = read("start.csv", csv(fields(s, true, false), s.size())),
                       .end = read("end.csv", csv(fields(e, true, false), e.size()))};
  expect_same(score(the_case, output), the_run, "start's ids");
  EXPECT_EQ(score(the_case, {.end = output.end}).status, records::Status::failed);
}

/// No ids and no reference positions: the order of the start, or of the case's particles, which positions bear out.
TEST_F(RoundTrip, TheOrderOfTheStart) {
  const State s = start.shuffled(6), e = end.shuffled(6);
  const codes::Snapshot first = read("start.csv", csv(fields(s, false, false), s.size()));
  const codes::Snapshot last = read("end.csv", csv(fields(e, false, false), e.size()));
  expect_same(score(the_case, {.start = first, .end = last}), the_run, "start's order");
  State in_order = end;
  for (std::size_t p = 0; p < end.size(); ++p) in_order.x[static_cast<std::size_t>(end.id[p] - 1)] = end.x[p];
  codes::Snapshot alone{.file = "end.csv"};
  alone.x = in_order.x;
  EXPECT_NEAR(score(the_case, {.end = alone}).error.l2, the_run.error.l2, 1e-13);
}

/// The particles of several processes, a file each.
TEST_F(RoundTrip, PartsOfOneState) {
  const auto f = fields(end, true, false);
  std::string text = csv(f, end.size());
  const std::size_t header = text.find('\n') + 1, middle = text.find('\n', text.size() / 2) + 1;
  const auto a = write("a.csv", text.substr(0, middle)),
             b = write("b.csv", text.substr(0, header) + text.substr(middle));
  const codes::Snapshot snapshot = codes::read_snapshot(std::vector{a, b}, {});
  expect_same(score(the_case, {.end = snapshot}), the_run, "parts");
  std::filesystem::remove(a);
  std::filesystem::remove(b);
}

/// The errors that few digits make are those that the floor says.
TEST_F(RoundTrip, TheFloorIsTheErrorOfRounding) {
  const auto f = fields(end, true, false);
  const auto exact = score(the_case, {.end = read("exact.csv", csv(f, end.size()))});
  EXPECT_LT(exact.output_floor, 1e-16);
  codes::Snapshot rounded = read("rounded.csv", csv(f, end.size(), 4));
  EXPECT_EQ(rounded.digits, 4);
  runs::ErrorNorms norms;
  for (std::size_t p = 0; p < end.size(); ++p)
    norms.add(std::hypot(rounded.x[p][0] - end.x[p][0], rounded.x[p][1] - end.x[p][1]));
  EXPECT_NEAR(score(the_case, {.end = rounded}).output_floor / norms.l2(), 1, 0.1);
}

TEST_F(RoundTrip, ADumpOfASeries) {
  const auto f = fields(end, true, false), g = fields(start, true, false);
  const std::int64_t last = the_case.resolution.steps;
  const std::string both = dump(f, end.size(), last) + dump(g, start.size(), 0);
  codes::Columns columns;
  columns.step = last;
  expect_same(score(the_case, {.end = read("both.dump", both, columns)}), the_run, "the last step");
}

}  // namespace mpmvv::round_trip_test
