#include "studies/codes/score.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "studies/codes/case_particles.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

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

/// The faster half of the particles has three quarters of the mass.
TEST(Score, TakesTheMassesThatTheFileHas) {
  const cases::Case c = square();
  const CaseParticles<2> particles = case_particles<2>(c);
  Snapshot end = exact_end(c);
  std::vector<double> squares;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Vec<2> v = particles.setup.solution->v(particles.X[p], particles.end_time);
    end.v.push_back({v[0], v[1], 0});
    squares.push_back(v.squaredNorm());
  }
  std::vector<double> sorted = squares;
  std::ranges::sort(sorted);
  double kinetic = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    end.mass.push_back(particles.m[p] * (squares[p] < sorted[sorted.size() / 2] ? 0.5 : 1.5));
    kinetic += end.mass.back() * squares[p] / 2;
  }
  const records::Record r = score(c, {.end = end});
  ASSERT_EQ(r.status, records::Status::ok) << r.reason;
  EXPECT_NEAR(r.energy.kinetic, kinetic, 1e-12 * kinetic);
  end.mass.clear();
  EXPECT_LT(score(c, {.end = end}).energy.kinetic, 0.95 * kinetic);
}

TEST(Score, ADoubledIdIsAReason) {
  const cases::Case c = square();
  Snapshot end = exact_end(c);
  end.id[3] = end.id[20];
  const records::Record r = score(c, {.end = end});
  EXPECT_EQ(r.status, records::Status::failed);
  EXPECT_EQ(r.reason, "particle 21 stands twice in end.csv");
}

/// Whether it has blown up is not asked where the file is none of the case.
TEST(Score, ADoubledOrMissingParticleIsSeenBesideNumbersThatAreNone) {
  const cases::Case c = square();
  Snapshot end = exact_end(c);
  end.x[7] = {std::nan(""), 0, 0};
  EXPECT_EQ(score(c, {.end = end}).status, records::Status::unstable);
  const auto reason = [&](const Snapshot& s) {
    const records::Record r = score(c, {.end = s});
    EXPECT_EQ(r.status, records::Status::failed);
    return r.reason;
  };
  Snapshot other = end;
  other.id[3] = 21;
  EXPECT_EQ(reason(other), "particle 21 stands twice in end.csv");
  other.id[3] = 65;
  EXPECT_THAT(reason(other), testing::HasSubstr("particle 65 in end.csv (the case has particles 1 to 64"));
  other = end;
  other.id.clear();
  other.x.push_back(other.x[0]);
  EXPECT_EQ(reason(other), "65 particles in end.csv, the case has 64");
  other.x.resize(60);
  EXPECT_EQ(reason(other), "4 of 64 particles are missing in end.csv");
}

TEST(Score, WhatACommentSaysMayHaveItsUnit) {
  const cases::Case c = square();
  Snapshot end = exact_end(c);
  const std::string dt = fmt::format("{}", c.resolution.dt);
  end.says = {{"dt", dt + " s"}, {"youngs_modulus", "1e4 Pa"}, {"density", "1 kg/m3"}};
  EXPECT_EQ(score(c, {.end = end}).reason, "");
  end.says = {{"dt", dt + " ms"}};
  EXPECT_THAT(score(c, {.end = end}).reason, testing::HasSubstr("dt = " + dt + " ms in end.csv, the case has " + dt));
}

/// Column by column instead of row by row; the positions alone say which particle is which.
TEST(Score, IdsInAnotherOrderAreAReason) {
  const cases::Case c = square();
  Snapshot end = exact_end(c);
  for (std::size_t p = 0; p < end.size(); ++p) end.id[p] = static_cast<std::int64_t>(p % 8 * 8 + p / 8 + 1);
  const records::Record r = score(c, {.end = end});
  EXPECT_EQ(r.status, records::Status::failed);
  EXPECT_THAT(r.reason, testing::StartsWith("ids of end.csv are not those of `mpmvv particles`: particle 9 is where 2 "
                                            "should be (give --start, or start of the adapter, or write X)"));
  end.id.clear();
  EXPECT_EQ(score(c, {.end = end}).status, records::Status::ok);
}

/// No other ids fit a state that blew up. Nor are ids blamed for an error that neighbours share.
TEST(Score, IdsAreNotBlamedForAnError) {
  const cases::Case c = square();
  for (const bool is_blown_up : {true, false}) {
    Snapshot end = exact_end(c);
    for (std::size_t p = 0; p < end.size(); ++p) end.x[p][0] += is_blown_up && p % 3 == 0 ? -0.15 : 0.125;
    const records::Record r = score(c, {.end = end});
    EXPECT_EQ(r.status, records::Status::unstable) << r.reason;
    EXPECT_THAT(r.reason, testing::HasSubstr(is_blown_up ? "displacement error 0.15 beyond" : "another origin?"));
  }
}

TEST(Score, NeedsASolution) {
  const std::vector<settings::Setting> impact{
      {"problem", "impact", ""}, {"basis", "linear", ""}, {"cells", "4", ""}, {"ppc", "2", ""}, {"cfl", "0.2", ""}};
  EXPECT_THAT([&] { score(settings::make_case(impact), {}); },
              testing::ThrowsMessage<support::UsageError>(
                  testing::HasSubstr("no exact solution with these parameters to score by (other ones, or another")));
}

/// No body force is no mistake where the problem has none.
TEST(Score, WithoutABodyForceThatTheProblemHasNotIsJudgedAsAnyOther) {
  const std::vector<settings::Setting> given{
      {"problem", "wave", ""}, {"cells", "8", ""}, {"ppc", "2", ""}, {"cfl", "0.2", ""}, {"end_time", "0.004", ""}};
  cases::Case c = settings::make_case(given);
  c.scheme.force_form = cases::ForceForm::none;
  const CaseParticles<2> particles = case_particles<2>(c);
  const auto at = [&particles](double t) {
    Snapshot s{.file = "end.csv"};
    for (std::size_t p = 0; p < particles.size(); ++p) {
      s.id.push_back(static_cast<std::int64_t>(p) + 1);
      const Vec<2> x = particles.exact(p, t);
      s.x.push_back({x[0], x[1], 0});
    }
    return s;
  };
  EXPECT_EQ(score(c, {.end = at(particles.end_time)}).reason, "");
  EXPECT_THAT(score(c, {.end = at(0)}).reason, testing::HasSubstr("another time in end.csv"));
  Snapshot resting = at(0);
  resting.time = particles.end_time;
  EXPECT_THAT(score(c, {.end = resting}).reason, testing::HasSubstr("no particle in end.csv has moved"));
}

/// With displacements, from which reference positions follow but for whole periods.
TEST(Score, OfAShiftedPeriodicGridMatches) {
  const std::vector<settings::Setting> given{{"problem", "bar", ""}, {"cells", "16", ""},       {"ppc", "2", ""},
                                             {"cfl", "0.2", ""},     {"basis", "bspline2", ""}, {"steps", "20", ""}};
  for (const char* offset : {"0.4", "0.25", "0.75"}) {
    std::vector<settings::Setting> shifted = given;
    shifted.push_back({"grid_offset", offset, ""});
    const cases::Case c = settings::make_case(shifted);
    const CaseParticles<1> particles = case_particles<1>(c);
    Snapshot end{.file = "end.csv"};
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const double u = particles.setup.solution->u(particles.X[p], particles.end_time)[0];
      const double x = particles.X[p][0] + u;
      end.x.push_back({x < particles.upper[0] ? x : x - 1, 0, 0});
      end.u.push_back({u, 0, 0});
    }
    EXPECT_EQ(score(c, {.end = end}).reason, "") << offset;
  }
}

/// A particle on a corner of the grid is found from all sides of it.
TEST(Score, OfAShiftedPeriodicSquareMatchesAtItsCorner) {
  const std::vector<settings::Setting> given{
      {"problem", "translation", ""}, {"cells", "4", ""},         {"ppc", "2", ""}, {"cfl", "0.2", ""},
      {"basis", "linear", ""},        {"grid_offset", "0.25", ""}};
  const cases::Case c = settings::make_case(given);
  const CaseParticles<2> particles = case_particles<2>(c);
  for (const double off : {-1e-9, 0., 1e-9}) {
    Snapshot end{.file = "end.csv"};
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const solver::Vec<2> X = particles.X[p], x = X + particles.setup.solution->u(X, particles.end_time);
      end.X.push_back({X[0] + off, X[1] + off, 0});
      end.x.push_back({x[0], x[1], 0});
    }
    EXPECT_EQ(score(c, {.end = end}).reason, "") << off;
  }
}

/// Where X says which particle a line is, ids may be those of each process.
TEST(Score, OfIdsThatMatchNothingABlowUpIsUnstable) {
  const cases::Case c = settings::make_case(std::vector<settings::Setting>{
      {"problem", "bar", ""}, {"cells", "16", ""}, {"ppc", "2", ""}, {"cfl", "0.2", ""}, {"basis", "bspline2", ""}});
  const CaseParticles<1> particles = case_particles<1>(c);
  Snapshot end{.file = "end.csv"};
  for (std::size_t p = 0; p < particles.size(); ++p) {
    end.id.push_back(static_cast<std::int64_t>(p % 10));
    end.X.push_back({particles.X[p][0], 0, 0});
    end.x.push_back({p == 3 ? NAN : particles.X[p][0], 0, 0});
  }
  EXPECT_EQ(score(c, {.end = end}).status, records::Status::unstable);
  end.step = 17;
  EXPECT_EQ(score(c, {.end = end}).status, records::Status::failed) << "of another step, whatever else it says";
}

/// A body that rests where that of the exact solution moves has ids that fit its start.
TEST(Score, IdsOfABodyAtRestAreThoseOfItsStart) {
  const std::vector<settings::Setting> given{
      {"problem", "vortex", ""}, {"basis", "linear", ""}, {"cells", "8", ""},        {"ppc", "2", ""},
      {"cfl", "0.2", ""},        {"end_time", "0.4", ""}, {"blowup_error", "10", ""}};
  cases::Case c = settings::make_case(given);
  c.scheme.force_form = cases::ForceForm::none;
  const CaseParticles<2> particles = case_particles<2>(c);
  Snapshot end{.file = "end.csv", .time = 0.4};
  for (std::size_t p = 0; p < particles.size(); ++p) {
    end.id.push_back(static_cast<std::int64_t>(p) + 1);
    end.x.push_back({particles.X[p][0], particles.X[p][1], 0});
  }
  const records::Record r = score(c, {.end = end});
  EXPECT_EQ(r.status, records::Status::ok) << r.reason;
}

}  // namespace mpmvv::score_test
