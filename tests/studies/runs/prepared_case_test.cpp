#include "studies/runs/prepared_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/integrator/integrators.hpp"
#include "solver/mpm.hpp"
#include "solver/words.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::runs::prepared_case_test {

using Settings = std::vector<settings::Setting>;

solver::AnyVelocityUpdate update_of(const std::string& word, const Settings& more) {
  Settings settings{{"problem", "bar", ""},       {"cells", "8", ""},        {"ppc", "2", ""},
                    {"cfl", "0.2", ""},           {"basis", "bspline2", ""}, {"integrator", "usl", ""},
                    {"velocity_update", word, ""}};
  settings.insert(settings.end(), more.begin(), more.end());
  const cases::Case c = settings::make_case(settings);
  return prepare_case<1>(c, problems::find_problem("bar", ""), 1).scene.velocity_update;
}

/// Whether the particles carry their reference positions.
template <int D>
bool has_places(const std::string& problem, const Settings& more = {}) {
  Settings settings{{"problem", problem, ""}, {"cells", "8", ""},        {"ppc", "2", ""},
                    {"cfl", "0.2", ""},       {"basis", "bspline2", ""}, {"integrator", "usl", ""}};
  settings.insert(settings.end(), more.begin(), more.end());
  const auto prepared = prepare_case<D>(settings::make_case(settings), problems::find_problem(problem, ""), 1);
  if (prepared.scene.particles.X.empty()) return false;
  EXPECT_THAT(prepared.scene.particles.X, testing::ElementsAreArray(prepared.X));
  return true;
}

TEST(Scene, KeepsReferencePositionsWhereTheBodyForceReadsThem) {
  EXPECT_TRUE(has_places<2>("ring"));
  EXPECT_TRUE(has_places<2>("vortex"));
  EXPECT_FALSE(has_places<2>("ring", {{"body_force", "grid", ""}}));
  EXPECT_FALSE(has_places<1>("bar"));
  EXPECT_FALSE(has_places<2>("square"));
}

TEST(Scene, HasTheVelocityUpdateThatTheCaseNames) {
  constexpr auto words = solver::words<solver::AnyVelocityUpdate>();
  for (std::size_t k = 0; k < words.size(); ++k) {
    solver::AnyVelocityUpdate named;
    solver::from_word(words[k], named);
    const Settings order{{"order", "3", ""}};
    EXPECT_EQ(update_of(std::string(words[k]), solver::expands_inverse(named) ? order : Settings{}).index(), k);
  }
}

std::string text_of(const Settings& settings) {
  std::string text;
  for (const settings::Setting& setting : settings) text += setting.key + "=" + setting.value + " ";
  return text;
}

/// What the rules of a case let through, the solver's own (solver/scene.cpp) must not refuse when the run begins.
TEST(Scene, IsSoundForEveryValidScheme) {
  std::vector<Settings> updates;
  for (const char* position : {"first-order", "second-order", "particle"})
    updates.push_back({{"velocity_update", "flip", ""}, {"position", position, ""}});
  for (const auto word : solver::words<solver::AnyVelocityUpdate>())
    for (const char* order : {"", "2"}) {
      updates.push_back({{"velocity_update", std::string(word), ""}});
      if (*order) updates.back().push_back({"order", order, ""});
    }
  int valid = 0;
  const auto expect_sound = [&valid](const Settings& settings) {
    cases::Case c;
    try {
      c = settings::make_case(settings);
    } catch (const support::UsageError&) {
      return;
    }
    ++valid;
    auto prepared = prepare_case<2>(c, problems::find_problem(c.problem.name, ""), 1);
    EXPECT_NO_THROW(solver::Mpm<2>(std::move(prepared.scene))) << text_of(settings);
  };
  for (const auto basis : solver::words<solver::AnyBasis>())
    for (const auto integrator : solver::integrator_words())
      for (const Settings& update : updates)
        for (const char* mass : {"lumped", "consistent"})
          for (const char* boundary :
               {"dirichlet", "symmetry", "mirror", "free", "periodic", "xmin=wall,xmax=wall,ymin=free,ymax=free"}) {
            Settings settings{{"problem", "swing", ""},   {"cells", "8", ""},
                              {"ppc", "2", ""},           {"cfl", "0.2", ""},
                              {"mass", mass, ""},         {"basis", std::string(basis), ""},
                              {"boundary", boundary, ""}, {"integrator", std::string(integrator), ""}};
            settings.insert(settings.end(), update.begin(), update.end());
            expect_sound(settings);
          }
  EXPECT_GT(valid, 1000);
}

/// S (11) to (15), W §4: particle velocities of `cd` are half a step behind the positions. `half` begins with those of
/// t = 0, and halves the first acceleration instead.
TEST(Scene, StartsWithTheVelocitiesThatItsStartNames) {
  for (const char* start : {"exact", "half"}) {
    const Settings settings{{"problem", "square", ""}, {"cells", "8", ""},        {"ppc", "2", ""},
                            {"cfl", "0.2", ""},        {"basis", "bspline2", ""}, {"integrator", "cd", ""},
                            {"start", start, ""}};
    const cases::Case c = settings::make_case(settings);
    const auto prepared = prepare_case<2>(c, problems::find_problem("square", ""), 1);
    const double t = start == std::string("exact") ? -0.5 * c.resolution.dt : 0;
    const auto& particles = prepared.scene.particles;
    const auto& solution = *prepared.setup.solution;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      EXPECT_LT((particles.v[p] - solution.v(prepared.X[p], t)).norm(), 1e-12) << start;
      EXPECT_LT((particles.x[p] - prepared.X[p] - solution.u(prepared.X[p], 0)).norm(), 1e-15) << start;
    }
    EXPECT_GT((solution.v(prepared.X[0], 0.5 * c.resolution.dt) - solution.v(prepared.X[0], t)).norm(), 1e-6);
  }
}

/// A node has no reference position: its body force is that of the point that has moved to it.
TEST(Scene, BodyForceOnTheGridIsThatOfTheReferencePoint) {
  const Settings settings{
      {"problem", "square", ""}, {"cells", "8", ""}, {"ppc", "2", ""}, {"cfl", "0.2", ""}, {"body_force", "grid", ""}};
  const auto prepared = prepare_case<2>(settings::make_case(settings), problems::find_problem("square", ""), 1);
  const auto& solution = *prepared.setup.solution;
  const double t = 0.003;
  for (const solver::Vec<2>& X : {solver::Vec<2>(0.3, 0.6), solver::Vec<2>(0.8, 0.1)}) {
    const solver::Vec<2> x = X + solution.u(X, t), b = solution.b(X, t);
    EXPECT_LT((prepared.scene.body_force->at_position(x, t) - b).norm(), 1e-9 * b.norm());
    EXPECT_GT((solution.b(x, t) - b).norm(), 1e-3 * b.norm());
  }
}

TEST(Scene, HasItsChoices) {
  const auto flip = std::get<solver::Flip>(update_of("flip", {{"position", "particle", ""}}));
  EXPECT_EQ(flip.position, solver::FlipPosition::particle);
  EXPECT_EQ(std::get<solver::Xpic>(update_of("xpic", {{"order", "3", ""}})).order, 3);
  const auto fmpm = std::get<solver::Fmpm>(update_of("fmpm", {{"order", "4", ""}, {"cfl_x", "1.01", ""}}));
  EXPECT_EQ(fmpm.order, 4);
  EXPECT_EQ(fmpm.interval, 5);
}

/// N §3.1: "one CFL for the simulation time step and a second CFL_X to choose the frequency of using FMPM
/// calculations". Only every so many whole steps can be FMPM's, and those nearest to CFL_X/CFL come nearest to that
/// frequency; rounded down or up, round-off would decide where CFL divides CFL_X. Never less than every step.
TEST(Scene, PeriodicFmpmTakesTheNearestNumberOfSteps) {
  for (const auto& [cfl_x, interval] : {std::pair{"0.01", 1},
                                        {"0.09", 1},
                                        {"0.11", 1},
                                        {"0.2", 1},
                                        {"0.29", 1},
                                        {"0.31", 2},
                                        {"0.4", 2},
                                        {"0.6", 3},
                                        {"0.99", 5},
                                        {"1", 5},
                                        {"1.09", 5},
                                        {"1.11", 6},
                                        {"1.15", 6},
                                        {"1.2", 6},
                                        {"2", 10},
                                        {"200", 1000}})  // CFL 0.2
    EXPECT_EQ(std::get<solver::Fmpm>(update_of("fmpm", {{"order", "2", ""}, {"cfl_x", cfl_x, ""}})).interval, interval)
        << cfl_x;
}

}  // namespace mpmvv::runs::prepared_case_test
