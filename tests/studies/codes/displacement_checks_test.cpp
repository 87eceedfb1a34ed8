#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/codes/score.hpp"
#include "tests/studies/codes/exact_state.hpp"

/// Displacements that are written beside positions or instead of them.
namespace mpmvv::displacement_checks_test {

using codes::Point;
using codes::Snapshot;
using records::Record;
using records::Status;
using testing::HasSubstr;

/// The exact end of a body that starts deformed, with displacements. `start` times those at time zero are taken off.
Snapshot end_with_displacements(const codes::CaseParticles<2>& particles, double start) {
  Snapshot s = written_run::exact_state(particles, particles.end_time);
  for (const auto& X : particles.X)
    s.u.push_back(written_run::point<2>(particles.setup.solution->u(X, particles.end_time) -
                                        start * particles.setup.solution->u(X, 0)));
  return s;
}

class Displacements : public testing::Test {
 protected:
  const cases::Case c = written_run::square();
  const codes::CaseParticles<2> particles = codes::case_particles<2>(c);

  std::string reason(const Snapshot& s) const {
    const Record r = codes::score(c, {.end = s});
    EXPECT_EQ(r.status, r.reason.empty() ? Status::ok : Status::failed);
    return r.reason;
  }
};

TEST_F(Displacements, AreThoseOfThePositions) {
  Snapshot s = end_with_displacements(particles, 0);
  EXPECT_EQ(reason(s), "");
  s.u[6][1] += 1e-4;
  EXPECT_THAT(reason(s), testing::AllOf(HasSubstr("particle 7 in end.csv has the displacement u = ("),
                                        HasSubstr("m, but x - X = ("), HasSubstr("or leave u, or X and x, out)")));
  s.id.clear();
  EXPECT_THAT(reason(s), HasSubstr("row 7 in end.csv has the displacement"));
}

TEST_F(Displacements, MayDifferFromThePositionsByTheDigits) {
  Snapshot s = end_with_displacements(particles, 0);
  for (Point& u : s.u) u[0] += 1e-5;
  EXPECT_THAT(reason(s), HasSubstr("particle 1 in end.csv"));
  s.rounding_of_all = 1e-5;
  EXPECT_EQ(reason(s), "");
}

TEST_F(Displacements, CountFromThePositionAtRest) {
  Snapshot s = end_with_displacements(particles, 1);
  EXPECT_THAT(reason(s), HasSubstr("u counts from the undeformed position X, not from that at time zero"));
  s.x.clear();
  EXPECT_THAT(reason(s), HasSubstr("displacements in end.csv count from the positions at time zero? They are "));
  s.X.clear();
  EXPECT_THAT(reason(s), HasSubstr("displacements in end.csv count from the positions at time zero? They are "));
  s = end_with_displacements(particles, 0);
  s.x.clear();
  EXPECT_EQ(reason(s), "");
}

/// A particle that has left a periodic grid on one side comes back on the other.
TEST(PeriodicDisplacements, AreTheShortestThatPositionsAllow) {
  const cases::Case c =
      written_run::make_case({{"problem", "translation"}, {"cells", "4"}, {"ppc", "2"}, {"cfl", "0.2"}});
  const auto particles = codes::case_particles<2>(c);
  Snapshot s = end_with_displacements(particles, 0);
  const double period = particles.period[0];
  ASSERT_GT(period, 0);
  for (Point& x : s.x) x[0] -= period;
  const Record moved = codes::score(c, {.end = s});
  EXPECT_EQ(moved.status, Status::ok) << moved.reason;
  for (Point& x : s.x) x[0] += period / 4;
  EXPECT_THAT(codes::score(c, {.end = s}).reason, HasSubstr("has the displacement u = ("));
}

}  // namespace mpmvv::displacement_checks_test
