#include "studies/settings/part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "solver/basis/bases.hpp"
#include "solver/words.hpp"
#include "studies/runs/run_case.hpp"
#include "studies/runs/run_part.hpp"
#include "studies/settings/settings.hpp"
#include "studies/settings/traits.hpp"

namespace mpmvv::runs::part_test {

using records::Record;

/// "key=value ..." on top of a cube of few steps.
cases::Case case_of(const std::string& text) {
  std::map<std::string, std::string> chosen{{"problem", "cube"}, {"basis", "bspline2"}, {"integrator", "cd"},
                                            {"cells", "10"},     {"ppc", "2"},          {"cfl", "0.4"},
                                            {"steps", "12"}};
  std::istringstream words(text);
  for (std::string word; words >> word;) chosen[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  std::vector<settings::Setting> settings;
  for (const auto& [key, value] : chosen) settings.push_back({key, value, "the test"});
  return settings::make_case(settings);
}

/// All that a record says of the whole: errors to 1e-12 and the round-off of a position or a velocity, energies to
/// 1e-12 of what there is. Sums over many particles of what should be zero are zero to 1e-11.
void expect_same(const Record& part, const Record& whole) {
  const double farthest = whole.the_case.problem.name.starts_with("stretch") ? 12 : 1;  // m from the origin
  EXPECT_EQ(part.the_case, whole.the_case);
  EXPECT_EQ(part.particles, whole.particles);
  EXPECT_EQ(part.steps, whole.steps);
  EXPECT_EQ(part.cfl, whole.cfl);
  EXPECT_EQ(part.status, whole.status);
  for (const records::RunNumber& number : records::run_errors()) {
    const double a = number.get(part), b = number.get(whole);
    const bool is_change = std::string(number.name).ends_with("_change");
    const double unit = std::string(number.name) == "velocity_error" ? 100 : farthest;  // %, or m
    EXPECT_EQ(std::isnan(a), std::isnan(b)) << number.name;
    if (!std::isnan(b)) {
      EXPECT_NEAR(a, b, is_change ? 1e-11 : 1e-12 * b + 4e-16 * unit) << number.name;
    }
  }
  const double most = whole.energy.initial_total + whole.energy.kinetic + whole.energy.strain;
  EXPECT_NEAR(part.energy.kinetic, whole.energy.kinetic, 1e-12 * most);
  EXPECT_NEAR(part.energy.strain, whole.energy.strain, 1e-12 * most);
  EXPECT_NEAR(part.energy.initial_total, whole.energy.initial_total, 1e-12 * most);
}

void expect_part_for_whole(const std::string& text) {
  SCOPED_TRACE(text);
  const cases::Case c = case_of(text);
  const auto part = settings::part_of(c);
  ASSERT_TRUE(part) << "nothing to compare";
  const auto record = run_part(c, *part, 1);
  const Record whole = run_case(c, 1);
  ASSERT_TRUE(record) << "nothing to compare: it blows up, " << whole.reason;
  expect_same(*record, whole);
}

/// Those with ghost nodes, and the fewest cells that have room for their images.
std::vector<std::string> bases() {
  std::vector<std::string> all;
  for (const auto word : solver::words<solver::AnyBasis>()) {
    const std::string basis(word);
    if (basis.ends_with("-open")) continue;
    const int cells = 4 * ghosts_of(settings::named<solver::AnyBasis>(basis));
    all.push_back("basis=" + basis + " cells=" + std::to_string(cells) +
                  (basis == "ugimp" ? " smoothing_length=0.5" : "") + (cells > 8 ? " steps=4" : ""));
  }
  return all;
}

TEST(Part, OfTheCubeHasTheNumbersOfTheWholeWithEveryBasisAndBoundary) {
  for (const std::string& basis : bases())
    for (const char* boundary : {"periodic", "symmetry", "mirror"})
      expect_part_for_whole(basis + " boundary=" + boundary + " every_step=true stress_error=true");
}

TEST(Part, OfTheCubeHasTheNumbersOfTheWholeWithEveryIntegratorAndVelocityUpdate) {
  for (const solver::Integrator& integrator : solver::integrators())
    for (const char* boundary : {"periodic", "symmetry"})
      expect_part_for_whole("integrator=" + std::string(integrator.word) + " boundary=" + boundary);
  for (const auto word : solver::words<solver::AnyVelocityUpdate>())
    for (const char* boundary : {"periodic", "symmetry"}) {
      const std::string update(word);
      const bool has_order = solver::expands_inverse(settings::named<solver::AnyVelocityUpdate>(update));
      expect_part_for_whole("integrator=usl velocity_update=" + update + (has_order ? " order=3" : "") + " cfl=0.2" +
                            " boundary=" + boundary + " deformation=exponential");
    }
}

TEST(Part, OfTheCubeHasTheNumbersOfTheWholeUntilItsEnd) {
  expect_part_for_whole("cells=16 ppc=2 steps=40 boundary=periodic cfl=0.5");
  expect_part_for_whole("cells=16 ppc=2 steps=40 boundary=symmetry basis=cpgimp");
  expect_part_for_whole("cells=16 ppc=2 steps=40 boundary=periodic basis=linear cfl=0.2");
}

/// The blocks meet on step 122; with linear functions they come to no end.
TEST(Part, OfTwoBlocksHasTheNumbersOfTheWholeWithEveryBasis) {
  const std::string impact = "problem=impact integrator=usl deformation=exponential cfl=0.2 cells=4 ";
  for (const std::string& basis : bases())
    for (const char* update :
         {"flip position=second-order", "fmpm order=1", "fmpm order=4", "fmpm order=8", "xpic order=2"})
      expect_part_for_whole(impact + basis.substr(0, basis.find(" cells")) +
                            (basis.find("linear") != std::string::npos ? " steps=100" : " steps=300") +
                            (basis.find("ugimp") != std::string::npos ? " smoothing_length=0.5" : "") +
                            " velocity_update=" + update);
  expect_part_for_whole(impact + "steps=500 basis=cpdi velocity_update=fmpm order=16");
}

TEST(Part, OfTwoBlocksHasTheNumbersOfTheWholeWithEveryIntegrator) {
  for (const solver::Integrator& integrator : solver::integrators())
    expect_part_for_whole("problem=impact steps=500 cells=4 basis=cpdi cfl=0.2 integrator=" +
                          std::string(integrator.word));
}

TEST(Part, OfARingAndAShellHasTheNumbersOfTheWhole) {
  for (const std::string& basis : bases())
    for (const char* fill : {"lattice", "conforming"})
      for (const char* quarter : {"false", "true"})
        expect_part_for_whole(
            "problem=ring param.amplitude=0.05 steps=40 cfl=0.2 every_step=true stress_error=true fill=" +
            std::string(fill) + " quarter=" + quarter + " " + basis);
  for (const char* basis : {"bspline3", "cpgimp", "cpdi"})
    for (const char* body : {"problem=ring", "problem=ring quarter=true", "problem=shell quarter=true cells=6"})
      expect_part_for_whole(std::string(body) +
                            " steps=20 cfl=0.2 fill=conforming param.poissons_ratio=0.3 basis=" + basis);
  for (const char* basis : {"bspline2-open", "bspline3-open"})
    for (const char* body : {"problem=ring", "problem=shell cells=5"})
      expect_part_for_whole(std::string(body) + " steps=20 cfl=0.2 fill=conforming basis=" + basis);
  expect_part_for_whole("problem=shell steps=20 cfl=0.2 basis=bspline3 fill=conforming");
  expect_part_for_whole("problem=shell steps=20 cfl=0.2 basis=cpgimp");
  for (const char* basis : {"bspline3", "cpgimp", "cpdi"})
    expect_part_for_whole("problem=shell steps=20 cfl=0.2 quarter=true fill=conforming basis=" + std::string(basis));
}

TEST(Part, OfAVortexHasTheNumbersOfTheWhole) {
  std::vector<std::string> all = bases();
  for (const char* open : {"basis=bspline2-open", "basis=bspline3-open cells=11"}) all.emplace_back(open);
  for (const std::string& basis : all)
    for (const char* fill : {"lattice", "conforming"})
      expect_part_for_whole(
          "problem=vortex param.amplitude=0.3 steps=16 cfl=0.1 every_step=true stress_error=true fill=" +
          std::string(fill) + " " + basis);
}

TEST(Part, OfAQuarterRingAndAVortexHasTheNumbersOfTheWholeWithEveryIntegratorAndVelocityUpdate) {
  for (const char* body : {"problem=ring quarter=true", "problem=vortex param.amplitude=0.3"}) {
    const std::string all = body + std::string(" steps=40 basis=bspline3 fill=conforming cfl=0.2 ");
    for (const solver::Integrator& integrator : solver::integrators())
      expect_part_for_whole(all + "integrator=" + std::string(integrator.word));
    for (const auto word : solver::words<solver::AnyVelocityUpdate>()) {
      const std::string update(word);
      const bool has_order = solver::expands_inverse(settings::named<solver::AnyVelocityUpdate>(update));
      expect_part_for_whole(all + "integrator=usl velocity_update=" + update + (has_order ? " order=8" : ""));
    }
  }
}

TEST(Part, OfARingAndAVortexHasTheNumbersOfTheWholeUntilItsEnd) {
  for (const char* basis : {"bspline3", "cpgimp", "cpdi"})
    expect_part_for_whole("problem=ring quarter=true cells=24 steps=240 fill=conforming basis=" + std::string(basis));
  for (const char* vortex : {"basis=bspline3 cfl=0.2", "basis=cpdi ppc=4 cfl=0.1"})
    expect_part_for_whole("problem=vortex cells=16 steps=150 fill=conforming " + std::string(vortex));
}

/// A plane between two cells, through the middles of some, and one that particles lie on.
TEST(Part, OfABarWithAPlaneAlongItsMiddleHasTheNumbersOfTheWhole) {
  for (const std::string& basis : bases())
    for (const char* grid : {"cells=4", "cells=5", "cells=5 ppc=3"})
      for (const char* body : {"problem=pulse stress_error=true", "problem=stretch velocity_error=true"})
        expect_part_for_whole(basis + " steps=12 cfl=0.2 integrator=usl every_step=true " + body + " " + grid);
  for (const char* more : {"usl velocity_update=fmpm order=8 deformation=exponential", "usl velocity_update=apic",
                           "usl velocity_update=xpic order=2", "usf", "usl+"})
    for (const char* body : {"problem=pulse cells=5 steps=40", "problem=stretch-3d cells=3 steps=20"})
      expect_part_for_whole("basis=bspline2 cfl=0.2 " + std::string(body) + " integrator=" + more);
  for (const char* integrator : {"cd", "uvf", "rk4"})
    expect_part_for_whole("problem=pulse cells=5 steps=40 basis=cpgimp cfl=0.2 integrator=" + std::string(integrator));
  for (const char* update : {"flip position=second-order", "xpic order=4", "fmpm order=4"})
    expect_part_for_whole(
        "problem=shock cells=9 basis=b2cpdi integrator=usl cfl=0.2 deformation=exponential steps=40 "
        "velocity_update=" +
        std::string(update));
  for (const char* update : {"flip position=second-order", "fmpm order=2"})
    expect_part_for_whole(
        "problem=stretch-3d cells=4 basis=cpdi integrator=usl cfl=0.2 velocity_error=true steps=40 "
        "velocity_update=" +
        std::string(update));
}

TEST(Part, HasTheErrorsOfAllParticlesWithTheirPlaces) {
  for (const char* body : {"problem=ring quarter=true fill=conforming",
                           "problem=vortex param.amplitude=0.3 fill=conforming", "problem=pulse"}) {
    const cases::Case c = case_of(body + std::string(" basis=cpdi cfl=0.1 steps=40 particle_errors=true"));
    const auto places = [](std::vector<records::ParticleError> all) {
      std::ranges::sort(all, {}, [](const records::ParticleError& one) {
        return std::pair(std::round(1e9 * one.x), std::round(1e9 * one.y));
      });
      return all;
    };
    const auto of_part = run_part(c, settings::part_of(c).value(), 1);
    ASSERT_TRUE(of_part);
    const auto part = places(of_part->particle_errors), whole = places(run_case(c, 1).particle_errors);
    ASSERT_EQ(part.size(), whole.size());
    for (std::size_t k = 0; k < part.size(); ++k) {
      EXPECT_NEAR(part[k].x, whole[k].x, 1e-12);
      EXPECT_NEAR(part[k].y, whole[k].y, 1e-12);
      EXPECT_NEAR(part[k].error, whole[k].error, 1e-12);
    }
  }
}

TEST(Part, HasSoManyImages) {
  const std::pair<const char*, int> known[]{{"problem=cube", 8},
                                            {"problem=impact integrator=usl cfl=0.2", 4},
                                            {"problem=ring", 8},
                                            {"problem=ring basis=bspline2-open", 2},
                                            {"problem=ring quarter=true", 2},
                                            {"problem=shell", 16},
                                            {"problem=shell quarter=true", 2},
                                            {"problem=pulse cells=5", 2},
                                            {"problem=stretch integrator=usl", 2},
                                            {"problem=shock cells=4 integrator=usl", 2},
                                            {"problem=stretch-3d cells=4 integrator=usl", 2},
                                            {"problem=vortex cfl=0.2", 4},
                                            {"problem=vortex cfl=0.1 basis=cpdi", 4}};
  for (const auto& [text, images] : known) {
    SCOPED_TRACE(text);
    const cases::Case c = case_of(text);
    const auto part = settings::part_of(c);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->count(), images);
    EXPECT_EQ(run_part(c, *part, 1).value().images, images);
  }
}

TEST(Part, HasTheSameNumbersOnManyThreads) {
  const cases::Case c = case_of("problem=ring quarter=true cells=24 fill=conforming basis=cpgimp");
  const auto part = settings::part_of(c).value();
  const Record one = run_part(c, part, 1).value(), three = run_part(c, part, 3).value();
  EXPECT_EQ(one.error.l2, three.error.l2);
  EXPECT_EQ(one.error.linf, three.error.linf);
  EXPECT_EQ(one.energy.kinetic, three.energy.kinetic);
}

TEST(Part, IsNotRunWhereTheRestIsNoImageOfIt) {
  for (const char* more :
       {"grid_offset=0.25",
        "shuffle=1",
        "cells=11",
        "cells=6",
        "cfl=0.6",
        "velocity_update=fmpm integrator=usl order=2 cfl=0.4",
        "velocity_update=fmpm integrator=usl order=9 cfl=0.1",
        "nodal_error=true",
        "repeat=3",
        "body_force=grid",
        "mass=consistent integrator=usl",
        "boundary=dirichlet",
        "boundary=free",
        "whole=true",
        "problem=cube quarter=true",
        "problem=cube cfl=0.4 param.poissons_ratio=0.45",
        "problem=bar",
        "problem=square",
        "problem=stretch-1d integrator=usl",
        "problem=pulse boundary=symmetry",
        "problem=ring quarter=true boundary=xmin=symmetry,xmax=symmetry,ymin=symmetry,ymax=symmetry",
        "problem=vortex cfl=0.3",
        "problem=vortex basis=cpdi cfl=0.2",
        "problem=vortex grid_offset=0.25 cfl=0.2",
        "problem=vortex mass=consistent integrator=usl cfl=0.2",
        "basis=bspline2-open boundary=symmetry",
        "boundary=xmin=symmetry,xmax=symmetry,ymin=periodic,ymax=periodic,zmin=periodic,zmax=periodic"}) {
    SCOPED_TRACE(more);
    EXPECT_FALSE(settings::part_of(case_of(more)));
  }
}

TEST(Part, ThatBlowsUpIsNoRecordOfTheWhole) {
  const cases::Case c = case_of("blowup_error=1e-9");
  EXPECT_FALSE(run_part(c, settings::part_of(c).value(), 1));
}

TEST(Part, IsLeftToTheCaseThatAsksForTheWhole) {
  EXPECT_TRUE(case_of("whole=true").measure.whole);
  EXPECT_EQ(case_of("whole=true problem=bar"), case_of("problem=bar")) << "one case, where there is one way to run it";
}

}  // namespace mpmvv::runs::part_test
