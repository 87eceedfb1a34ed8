#include "studies/codes/score.hpp"

#include <gtest/gtest.h>

#include "studies/codes/case_particles.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::score_test {

using namespace codes;

cases::Case square() {
  const std::vector<settings::Setting> given{
      {"problem", "square", ""}, {"basis", "linear", ""}, {"cells", "4", ""}, {"ppc", "2", ""}, {"cfl", "0.2", ""}};
  return settings::make_case(given);
}

/// The exact end, moved by (3, 4) µm, with ids.
Snapshot exact_end(const cases::Case& c) {
  const CaseParticles<2> particles = case_particles<2>(c);
  Snapshot end{.file = "end.csv"};
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Vec<2> x = particles.X[p] + particles.setup.solution->u(particles.X[p], particles.end_time);
    end.id.push_back(static_cast<std::int64_t>(p) + 1);
    end.x.push_back({x[0] + 3e-6, x[1] + 4e-6, 0});
  }
  return end;
}

TEST(Score, MatchesById) {
  const cases::Case c = square();
  Snapshot end = exact_end(c);
  std::swap(end.id[3], end.id[20]);
  std::swap(end.x[3], end.x[20]);
  const records::Record r = score(c, {.end = end});
  EXPECT_EQ(r.status, records::Status::ok) << r.reason;
  EXPECT_EQ(r.particles, 64);
  for (const double error : {r.error.l1, r.error.l2, r.error.linf}) EXPECT_NEAR(error, 5e-6, 1e-15);
}

TEST(Score, HasTheErrorsOfTheParticlesWhereTheyAre) {
  cases::Case c = square();
  const Snapshot end = exact_end(c);
  EXPECT_TRUE(score(c, {.end = end}).particle_errors.empty());
  c.measure.particle_errors = true;
  const records::Record r = score(c, {.end = end});
  ASSERT_EQ(r.particle_errors.size(), 64U);
  EXPECT_EQ(r.particle_errors[20].x, end.x[20][0]);
  EXPECT_EQ(r.particle_errors[20].y, end.x[20][1]);
  EXPECT_NEAR(r.particle_errors[20].error, 5e-6, 1e-15);
}

TEST(Score, ADoubledIdIsAReason) {
  const cases::Case c = square();
  Snapshot end = exact_end(c);
  end.id[3] = end.id[20];
  const records::Record r = score(c, {.end = end});
  EXPECT_EQ(r.status, records::Status::failed);
  EXPECT_EQ(r.reason, "particle 21 stands twice in end.csv");
}

}  // namespace mpmvv::score_test
