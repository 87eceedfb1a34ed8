#include "studies/codes/stresses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/codes/columns.hpp"
#include "studies/codes/readers.hpp"
#include "tests/studies/codes/exact_state.hpp"

namespace mpmvv::stresses_test {

using codes::Snapshot;
using records::Record;
using records::Status;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using written_run::make_case;

/// The exact end, with `factor` times its stresses.
template <int D>
Snapshot end_with_stresses(const codes::CaseParticles<D>& particles, double factor) {
  Snapshot s = written_run::exact_state(particles, particles.end_time);
  for (const auto& X : particles.X) {
    const solver::Mat<D> F = particles.setup.solution->F(X, particles.end_time);
    const solver::Mat<D> P = particles.setup.solution->P(X, particles.end_time);
    s.stress.push_back(written_run::tensor<D>(factor / F.determinant() * P * F.transpose()));
  }
  return s;
}

template <int D>
Record scored(const cases::Case& c, double factor) {
  return codes::score(c, {.end = end_with_stresses(codes::case_particles<D>(c), factor)});
}

TEST(Stresses, OfTheExactEndHaveNoError) {
  const Record r = scored<2>(written_run::square(), 1);
  EXPECT_EQ(r.status, Status::ok) << r.reason;
  EXPECT_LT(r.error.stress, 1e-8);
}

TEST(Stresses, OfAnotherUnitAreAskedAbout) {
  for (const double factor : {1e3, 1e6, 1e9, 1e-3, 1e-6, 1e-9, 1700.0, 5e-7}) {
    const Record r = scored<2>(written_run::square(), factor);
    EXPECT_EQ(r.status, Status::failed) << factor;
    const double about = std::pow(1000, std::round(std::log(factor) / std::log(1000)));
    EXPECT_THAT(r.reason,
                AllOf(HasSubstr(fmt::format("stresses in end.csv are about {:g} times those of", about)),
                      HasSubstr("(another unit? "), HasSubstr("a thickness is no unit of mass: --thickness")));
  }
}

TEST(Stresses, OfAnotherSignAreAskedAbout) {
  EXPECT_THAT(scored<2>(written_run::square(), -1).reason,
              AllOf(HasSubstr("stresses in end.csv are about -1 times those of the case (another sign? Tension is "
                              "positive)"),
                    Not(HasSubstr("unit"))));
  EXPECT_THAT(scored<2>(written_run::square(), -1e-6).reason,
              AllOf(HasSubstr("are about -1e-06 times"), HasSubstr("another sign"), HasSubstr("another unit")));
}

/// Those of a coarse grid may be far off.
TEST(Stresses, MayBeFarOff) {
  for (const double factor : {100.0, 0.01, 2.0, 0.0}) {
    const Record r = scored<2>(written_run::square(), factor);
    EXPECT_EQ(r.status, Status::ok) << r.reason;
    EXPECT_GT(r.error.stress, 0);
  }
}

/// Where a wave lags behind by half a period, its stresses are the negative ones, and so are its displacements.
TEST(Stresses, OfAnEndThatIsFarOffMayHaveAnySign) {
  const cases::Case c = written_run::square();
  const auto particles = codes::case_particles<2>(c);
  Snapshot s = end_with_stresses(particles, -1);
  s.time = particles.end_time;
  for (std::size_t p = 0; p < s.size(); ++p)
    s.x[p] = written_run::point<2>(particles.X[p] + 0.7 * (particles.exact(p, particles.end_time) - particles.X[p]));
  const Record r = codes::score(c, {.end = s});
  EXPECT_EQ(r.status, Status::ok) << r.reason;
}

TEST(Stresses, AreLookedAtIfTheirErrorIsAskedFor) {
  cases::Case c = written_run::square();
  c.measure.stress_error = false;
  EXPECT_EQ(scored<2>(c, 1e-6).status, Status::ok);
}

cases::Case bar(const char* end_time) {
  return make_case({{"problem", "bar"},
                    {"cells", "8"},
                    {"ppc", "2"},
                    {"cfl", "0.2"},
                    {"end_time", end_time},
                    {"stress_error", "true"}});
}

/// At a quarter of its period the bar passes through its state at rest.
TEST(Stresses, NearZeroMayBeOfAnySize) {
  const Record r = scored<1>(bar("0.00501"), 1e3);
  EXPECT_EQ(r.status, Status::ok) << r.reason;
}

TEST(Stresses, HaveNoThicknessOnALine) {
  const cases::Case c = bar("0.002");
  EXPECT_EQ(scored<1>(c, 1).status, Status::ok);
  EXPECT_THAT(scored<1>(c, 1e-6).reason, AllOf(HasSubstr("are about 1e-06 times"), Not(HasSubstr("thickness"))));
}

/// A code in mm, t and s, with stresses in MPa, whose body is 1 mm thick.
class Thickness : public testing::Test {
 protected:
  void SetUp() override {
    const auto particles = codes::case_particles<2>(c_);
    const Snapshot s = end_with_stresses(particles, 1);
    std::string text = "id,x,y,v_x,v_y,m,s_xx,s_yy,s_xy\n";
    for (std::size_t p = 0; p < s.size(); ++p)
      text += fmt::format("{},{},{},{},{},{},{},{},{}\n", s.id[p], 1e3 * s.x[p][0], 1e3 * s.x[p][1], 1e3 * s.v[p][0],
                          1e3 * s.v[p][1], 1e-6 * s.mass[p], 1e-6 * s.stress[p][0], 1e-6 * s.stress[p][4],
                          1e-6 * s.stress[p][1]);
    file_ = written_run::write("thick.csv", text);
  }
  void TearDown() override { std::filesystem::remove(file_); }

  Record record(double mass, double thickness) const {
    const codes::Columns columns{.length = 1e-3, .mass = mass, .thickness = thickness, .dimensions = 2};
    return codes::score(c_, {.end = codes::read_snapshot(file_, columns)});
  }

  const cases::Case c_ = written_run::square();
  std::filesystem::path file_;
};

TEST_F(Thickness, DividesTheMasses) {
  const Record r = record(1e3, 1e-3);
  EXPECT_EQ(r.status, Status::ok) << r.reason;
  EXPECT_NEAR(r.balance.mass, 0, 1e-12);
  EXPECT_LT(r.error.stress, 1e-6);
}

TEST_F(Thickness, IsNamedWhereMassesAreOff) {
  const std::string reason = record(1e3, 1).reason;
  EXPECT_THAT(reason, AllOf(HasSubstr("0.001 times that of the case (which is 1 m thick: --thickness, or"),
                            HasSubstr("another unit of mass, and so of stress: --mass-unit")));
}

TEST_F(Thickness, TakenForAUnitOfMassShowsInTheStresses) {
  EXPECT_THAT(record(1e6, 1).reason, HasSubstr("stresses in "));
  EXPECT_THAT(record(1e6, 1).reason, HasSubstr("are about 1000 times those of the case"));
}

}  // namespace mpmvv::stresses_test
