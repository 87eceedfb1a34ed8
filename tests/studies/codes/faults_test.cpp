#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "studies/codes/output_fault.hpp"
#include "studies/codes/score.hpp"
#include "tests/studies/codes/exact_state.hpp"

namespace mpmvv::output_faults_test {

using codes::Output;
using codes::Snapshot;
using records::Record;
using records::Status;
using testing::HasSubstr;

/// A case and the exact positions and velocities at a time, with ids, masses and reference positions.
class OutputFaults : public testing::Test {
 protected:
  const cases::Case c = written_run::square();
  const codes::CaseParticles<2> particles = codes::case_particles<2>(c);

  Snapshot exact(double t) const { return written_run::exact_state(particles, t); }
  Snapshot end() const { return exact(particles.end_time); }

  void expect(const Output& output, Status status, const std::string& reason) const {
    const Record r = codes::score(c, output);
    EXPECT_EQ(r.status, status) << r.reason;
    EXPECT_THAT(r.reason, HasSubstr(reason));
    EXPECT_TRUE(std::isnan(r.error.l2));
    EXPECT_EQ(r.failure == records::Failure::of_case, status == Status::failed);
  }
  void expect_failed(const Snapshot& s, const std::string& reason) const { expect({.end = s}, Status::failed, reason); }
};

TEST_F(OutputFaults, NoneInTheExactEnd) {
  const Record r = codes::score(c, {.end = end()});
  EXPECT_EQ(r.status, Status::ok) << r.reason;
  EXPECT_LT(r.error.linf, 1e-15);
}

TEST_F(OutputFaults, MissingParticles) {
  Snapshot s = end();
  for (auto* points : {&s.X, &s.x, &s.v}) points->erase(points->begin() + 4);
  s.id.erase(s.id.begin() + 4);
  s.mass.erase(s.mass.begin() + 4);
  expect_failed(s, "1 of 256 particles are missing in end.csv (of the case 5)");
  s.X.clear();
  expect_failed(s, "1 of 256 particles are missing in end.csv (of the case 5)");
  s.id.clear();
  expect_failed(s, "1 of 256 particles are missing in end.csv");
  s.x[7][0] = std::numeric_limits<double>::quiet_NaN();
  expect_failed(s, "1 of 256 particles are missing in end.csv");
}

TEST_F(OutputFaults, MissingParticlesAreCountedWhereItIsNotKnownWhich) {
  Snapshot s = end();
  s.id.clear(), s.X.clear(), s.mass.clear();
  s.x.pop_back(), s.v.pop_back();
  EXPECT_EQ(codes::score(c, {.end = s}).reason, "1 of 256 particles are missing in end.csv");
}

TEST(OutputFault, SaysAllOfItsReason) {
  const std::string reason("time \0 s in end.csv", 19);
  EXPECT_STREQ(codes::OutputFault(Status::failed, reason).what(), "time \\x00 s in end.csv");
}

TEST_F(OutputFaults, DoubledParticles) {
  Snapshot s = end();
  s.X[7] = s.X[9];
  expect_failed(s, "two particles in end.csv start where the case's particle 10 does");
  s.X.clear();
  s.id[7] = 10;
  expect_failed(s, "particle 10 stands twice in end.csv");
  s.id[7] = 900;
  expect_failed(s, "particle 900 in end.csv (the case has particles 1 to 256");
}

TEST_F(OutputFaults, OtherParticlesThanTheCases) {
  Snapshot s = end();
  for (auto& X : s.X) X[0] += 0.01;
  expect_failed(s, "start up to 0.01 m from those of the case, which are 0.062 m apart");
}

TEST_F(OutputFaults, ParticlesThatBlewUp) {
  Snapshot s = end();
  s.x[5][1] = std::numeric_limits<double>::quiet_NaN();
  expect({.end = s}, Status::unstable,
         "1 of 256 particles with a position that is no number in end.csv (the first: particle 6)");
  s.id.clear();
  expect({.end = s}, Status::unstable, "in end.csv (the first: row 6)");
  s.parts = {{"a.csv", 4}, {"b.csv", 252}};
  expect({.end = s}, Status::unstable, "(the first: row 2 of b.csv)");
  s = end();
  s.x[5][1] = 3;
  expect({.end = s}, Status::unstable, "particle 6 has escaped: y = 3 m");
  s = end();
  s.x[5][0] += 0.3;
  expect({.end = s}, Status::unstable, "displacement error 0.3 beyond");
  s = end();
  for (auto& x : s.x) x[0] += 3;
  expect({.end = s}, Status::unstable, "; all particles are off by about (3, 0) m: another origin?");
  s = end();
  for (auto& v : s.v) v[0] = 1e6;
  expect({.end = s}, Status::unstable, "energy");
}

TEST_F(OutputFaults, WrongUnits) {
  Snapshot s = end();
  for (std::size_t p = 0; p < s.size(); ++p) {
    for (std::size_t d = 0; d < 2; ++d) s.u.resize(s.size()), s.u[p][d] = 1e3 * (s.x[p][d] - s.X[p][d]);
  }
  s.x.clear();
  expect_failed(s, "displacements in end.csv are 1000 times those of the case");
  s = end();
  for (auto* points : {&s.X, &s.x})
    for (auto& point : *points)
      for (double& value : point) value *= 1e-3;
  expect_failed(s,
                "positions in end.csv are 0.001 times those of the case (another unit? --length-unit 1000, or units of "
                "the adapter)");
  for (const double factor : {1000.0, 0.01}) {
    s = end();
    s.X.clear();
    for (auto& point : s.x)
      for (double& value : point) value *= factor;
    expect_failed(s, fmt::format("positions in end.csv are {:g} times those of the case", factor));
  }
  for (const double factor : {1000.0, 1600.0}) {  // a coarse grid may be far off
    s = end();
    for (auto& v : s.v)
      for (double& component : v) component *= factor;
    expect_failed(s, "velocities in end.csv are about 1000 times those of the case");
  }
  s = end();
  for (double& m : s.mass) m *= 1000;
  expect_failed(s,
                "1000 times that of the case (which is 1 m thick: --thickness, or thickness in units of the adapter; "
                "or another unit of mass");
}

/// Displacements of a coarse grid may be further off than 5 per cent, and are no more than an error then.
TEST_F(OutputFaults, AnotherUnitOfDisplacementsAlone) {
  Snapshot s = end();
  s.u.resize(s.size());
  for (std::size_t p = 0; p < s.size(); ++p)
    for (std::size_t d = 0; d < 2; ++d) s.u[p][d] = 1150 * (s.x[p][d] - s.X[p][d]);
  s.x.clear();
  expect_failed(s, "displacements in end.csv are 1000 times those of the case");
}

/// At half the period velocities are nearly zero: those of a code may then be a hundredth of them, or a hundred times.
TEST(Units, AreNotSeenInVelocitiesNearZero) {
  const cases::Case c = written_run::make_case(
      {{"problem", "square-rest"}, {"cells", "8"}, {"ppc", "2"}, {"cfl", "0.2"}, {"end_time", "0.0101"}});
  const auto particles = codes::case_particles<2>(c);
  Snapshot s{.file = "end.csv"};
  for (std::size_t p = 0; p < particles.size(); ++p) {
    s.id.push_back(static_cast<std::int64_t>(p) + 1);
    s.x.push_back(written_run::point<2>(particles.exact(p, particles.end_time)));
    s.v.push_back(written_run::point<2>(0.01 * particles.setup.solution->v(particles.X[p], particles.end_time)));
  }
  const Record r = codes::score(c, {.end = s});
  EXPECT_EQ(r.status, Status::ok) << r.reason;
}

TEST_F(OutputFaults, WrongTime) {
  Snapshot s = exact(particles.end_time / 2);
  expect_failed(s, "another time in end.csv?");
  s = end();
  s.time = 0.0039;
  expect_failed(s, "time 0.0039 s in end.csv, the case ends at 0.004 s");
}

/// A coarse grid may be so late, too: the file can say of which time it is.
TEST_F(OutputFaults, AFileThatStatesItsTimeIsOfThatTime) {
  Snapshot s = exact(0.85 * particles.end_time);
  expect_failed(s,
                "and states no time (if it is of the end, let it say so: # time = 0.004 in a text, a column 'time', "
                "TimeValue in a .vtu; an adapter can add it with [[output.convert]] and {{end_time}})");
  s.has_own_units = true;
  expect_failed(s, "let it say so: # time = ..., in its unit, in a text");
  s.time = particles.end_time;
  const Record r = codes::score(c, {.end = s});
  EXPECT_EQ(r.status, Status::ok) << r.reason;
}

/// A wave that lags behind is an error of the method.
TEST_F(OutputFaults, ALittleLateIsNoOtherTime) {
  const Record r = codes::score(c, {.end = exact(0.95 * particles.end_time)});
  EXPECT_EQ(r.status, Status::ok) << r.reason;
  EXPECT_GT(r.error.l2, 0);
}

/// Also where the file says that its time is the right one.
TEST_F(OutputFaults, ParticlesThatHaveNotMoved) {
  Snapshot s = exact(0);
  s.time = particles.end_time;
  expect_failed(s, "no particle in end.csv has moved since time zero");
  s.rounding = 1e-6;
  for (std::size_t p = 0; p < s.size(); ++p) s.x[p][0] += p % 2 == 0 ? 5e-7 : -5e-7;
  expect_failed(s, "no particle in end.csv has moved since time zero");
}

/// As one that does nothing would, and still one that moves.
TEST(Motion, IsNotAskedOfASolutionThatReturns) {
  const cases::Case c =
      written_run::make_case({{"problem", "square-rest"}, {"cells", "8"}, {"ppc", "2"}, {"cfl", "0.2"}});
  const auto particles = codes::case_particles<2>(c);
  Snapshot s{.file = "end.csv"};
  for (const auto& X : particles.X) s.X.push_back(written_run::point<2>(X));
  s.x = s.X;
  const Record at_rest = codes::score(c, {.end = s});
  EXPECT_EQ(at_rest.status, Status::failed);
  EXPECT_THAT(at_rest.reason, HasSubstr("a case with another --end-time, such as 0.01)"));
  for (auto& x : s.x) x[0] += 1e-6;
  EXPECT_EQ(codes::score(c, {.end = s}).status, Status::ok);
  EXPECT_THAT(codes::caution(c), HasSubstr("at the end of the case, 0.02 s, the exact solution is where it started"));
  EXPECT_EQ(codes::caution(written_run::square()), "");
}

/// Nothing says that a code should have moved.
TEST(Motion, IsNotAskedWhereTheSolutionRests) {
  const cases::Case c = written_run::make_case(
      {{"problem", "square-rest"}, {"param.amplitude", "0"}, {"cells", "8"}, {"ppc", "2"}, {"cfl", "0.2"}});
  const auto particles = codes::case_particles<2>(c);
  Snapshot s{.file = "end.csv"};
  for (const auto& X : particles.X) s.X.push_back(written_run::point<2>(X));
  s.x = s.X;
  EXPECT_EQ(codes::score(c, {.end = s}).status, Status::ok);
}

TEST_F(OutputFaults, AnOrderThatCannotBeVerified) {
  Snapshot s = end();
  s.id.clear();
  s.X.clear();
  std::swap(s.x[3], s.x[80]);
  for (auto& x : s.x) x[0] += 0.02;  // more than half a spacing from time zero, for some
  expect_failed(s, "the order of end.csv cannot be verified");
}

/// Small displacements: the nearest particle at time zero.
TEST(Matching, TakesTheNearestAtTheStartWhereThatIsPlain) {
  const cases::Case c = written_run::square("0.0005");
  const auto particles = codes::case_particles<2>(c);
  Snapshot s{.file = "end.csv"};
  for (std::size_t p = 0; p < particles.size(); ++p)
    s.x.push_back(written_run::point<2>(particles.exact(p, particles.end_time)));
  std::swap(s.x[3], s.x[80]);
  const Record r = codes::score(c, {.end = s});
  EXPECT_EQ(r.status, Status::ok) << r.reason;
  EXPECT_LT(r.error.linf, 1e-15);
}

TEST_F(OutputFaults, AnotherCase) {
  Snapshot s = end();
  s.says = {{"problem", "ring"}};
  expect_failed(s, "problem = ring in end.csv, the case has square");
  s.says = {{"amplitude", "0.07"}, {"cells", "8"}, {"anything", "else"}};
  expect_failed(s, "amplitude = 0.07 in end.csv, the case has");
}

/// A word of ours may have another meaning in another code.
TEST_F(OutputFaults, CommentsOnTheMethodAreTheCodesOwn) {
  Snapshot s = end();
  s.says = {{"mass", "1.0"}, {"basis", "linear"}, {"order", "2"}, {"integrator", "usl-half"},
            {"start", "0"},  {"repeat", "7"}};
  EXPECT_EQ(codes::score(c, {.end = s}).status, Status::ok);
  s.says = {{"boundary", "dirichlet"}};
  expect_failed(s, "boundary = dirichlet in end.csv, the case has");
  s.says = {{"force_form", "none"}};
  EXPECT_EQ(codes::score(c, {.end = s}).status, Status::ok) << "of cases of a code alone";
}

/// The number of the case, or the one that its time step was made of.
TEST_F(OutputFaults, AnotherCourantNumber) {
  Snapshot s = end();
  for (const char* same : {"0.2", "0.20", "2e-1"}) {
    s.says = {{"cfl", same}};
    EXPECT_EQ(codes::score(c, {.end = s}).status, Status::ok) << same;
  }
  s.says = {{"cfl", "0.4"}};
  expect_failed(s, "cfl = 0.4 in end.csv, the case has ");
  s.says = {{"cfl", "0.1"}};
  expect_failed(s, "cfl = 0.1 in end.csv, the case has ");
}

/// The file may mean its numbers in these.
TEST_F(OutputFaults, AnotherUnitOfCommentsIsNone) {
  Snapshot s = end();
  s.says = {{"dt", "0.125"}, {"end_time", "4"}, {"amplitude", "100"}};
  expect_failed(s, "amplitude = 100 in end.csv, the case has");
  s.has_own_units = true;
  EXPECT_EQ(codes::score(c, {.end = s}).status, Status::ok);
  s.says["cells"] = "9";
  expect_failed(s, "cells = 9 in end.csv, the case has 8");
}

}  // namespace mpmvv::output_faults_test
