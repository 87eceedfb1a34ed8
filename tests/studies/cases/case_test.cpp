#include "studies/cases/case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "studies/cases/setting_keys.hpp"
#include "studies/records/record.hpp"
#include "studies/records/result.hpp"
#include "studies/support/error.hpp"
#include "tests/studies/count_members.hpp"

namespace mpmvv::cases::case_test {

using records::PartVerdict;
using records::Status;
using support::from_word;

Case bar_case() {
  return {.problem = {.name = "bar", .parameters = {{"amplitude", 0.05}, {"density", 1}}, .end_time = 0.01},
          .scheme = {.basis = "bspline2", .integrator = "cd", .boundary = "periodic"},
          .resolution = {.cells = 64, .ppc = 4, .dt = 1.0 / 3, .steps = 800},
          .measure = {}};
}

TEST(CanonicalText, IsOneLineOfEveryChoiceInAFixedOrder) {
  EXPECT_EQ(
      canonical_text(bar_case()),
      "problem=bar param.amplitude=0.05 param.density=1 end_time=0.01 quarter=false basis=bspline2 smoothing_length=0 "
      "integrator=cd start=half velocity_update=flip order=0 cfl_x=0 position=first-order wall_method=none "
      "wall_depth=0 wall_gradient=none mass=lumped boundary=periodic wall_acceleration=zero "
      "deformation=linear body_force=particles fill=lattice material=neo-hookean-log cells=64 ppc=4 grid_offset=0 "
      "shuffle=0 "
      "dt=0.3333333333333333 steps=800 "
      "every_step=false nodal_error=false velocity_error=false stress_error=false particle_errors=false blowup_error=1 "
      "blowup_energy=10 "
      "whole=false repeat=0");
}

/// What another code makes of a case knows nothing of our own solver's words.
TEST(CanonicalText, OfAnotherCodeHasNothingOfOurOwnSolver) {
  Case c = bar_case();
  c.scheme.code = "nairn", c.scheme.variant = "spline-usl", c.scheme.force_form = ForceForm::per_particle;
  c.scheme.code_version = "4.2", c.scheme.adapter = "af63dc4c8601ec8c";
  EXPECT_EQ(canonical_text(c),
            "problem=bar param.amplitude=0.05 param.density=1 end_time=0.01 quarter=false code=nairn "
            "variant=spline-usl force_form=per-particle code_version=4.2 adapter=af63dc4c8601ec8c fill=lattice "
            "material=neo-hookean-log cells=64 ppc=4 dt=0.3333333333333333 steps=800 "
            "stress_error=false particle_errors=false blowup_error=1 repeat=0");
}

TEST(CanonicalText, OfAnotherCodeDependsOnProgramAdapterAndForm) {
  Case c = bar_case();
  c.scheme.code = "nairn";
  std::set<std::string> texts{canonical_text(bar_case()), canonical_text(c)};
  for (std::string Scheme::*word : {&Scheme::code, &Scheme::variant, &Scheme::code_version, &Scheme::adapter}) {
    Case changed = c;
    changed.scheme.*word = "x";
    EXPECT_TRUE(texts.insert(canonical_text(changed)).second);
  }
  for (const ForceForm form : {ForceForm::current, ForceForm::inverse, ForceForm::misplaced, ForceForm::none}) {
    c.scheme.force_form = form;
    EXPECT_TRUE(texts.insert(canonical_text(c)).second);
  }
}

TEST(CanonicalText, NumbersReadBackAsTheSameNumber) {
  for (const double dt : {0.1, 1.0 / 3, 4e-6, 1e300, std::numeric_limits<double>::denorm_min()}) {
    Case c = bar_case();
    c.resolution.dt = dt;
    const std::string text = canonical_text(c);
    const std::size_t at = text.find(" dt=") + 4;
    EXPECT_EQ(std::strtod(text.c_str() + at, nullptr), dt);
  }
}

TEST(CanonicalText, EqualCasesHaveEqualTexts) {
  Case minus = bar_case(), plus = bar_case();
  minus.problem.parameters["amplitude"] = -0.0;
  plus.problem.parameters["amplitude"] = 0.0;
  ASSERT_EQ(minus, plus);
  EXPECT_EQ(canonical_text(minus), canonical_text(plus));
}

TEST(CanonicalText, EveryMemberMakesADifference) {
  std::set<std::string> texts{canonical_text(bar_case())};
  const auto differs = [&](auto change) {
    Case c = bar_case();
    change(c);
    return texts.insert(canonical_text(c)).second;
  };
  EXPECT_TRUE(differs([](Case& c) { c.problem.name = "x"; }));
  EXPECT_TRUE(differs([](Case& c) { c.problem.parameters["amplitude"] = std::nextafter(0.05, 1); }));
  EXPECT_TRUE(differs([](Case& c) { c.problem.parameters["more"] = 0; }));
  EXPECT_TRUE(differs([](Case& c) { c.problem.quarter = true; }));
  EXPECT_TRUE(differs([](Case& c) { c.problem.end_time = 2; }));
  for (std::string Scheme::*word :
       {&Scheme::basis, &Scheme::integrator, &Scheme::velocity_update, &Scheme::boundary, &Scheme::material})
    EXPECT_TRUE(differs([&](Case& c) { c.scheme.*word = "x"; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.start = Start::exact; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.mass = Mass::consistent; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.wall_acceleration = WallAcceleration::difference; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.position = Position::particle; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.wall_method = WallMethod::lumped; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.wall_gradient = WallGradient::given; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.deformation = Deformation::exponential; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.body_force = BodyForce::grid; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.fill = Fill::conforming; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.smoothing_length = 0.5; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.order = 7; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.cfl_x = 7; }));
  EXPECT_TRUE(differs([](Case& c) { c.scheme.wall_depth = 7; }));
  EXPECT_TRUE(differs([](Case& c) { c.resolution.cells = 7; }));
  EXPECT_TRUE(differs([](Case& c) { c.resolution.ppc = 7; }));
  EXPECT_TRUE(differs([](Case& c) { c.resolution.grid_offset = 0.5; }));
  EXPECT_TRUE(differs([](Case& c) { c.resolution.shuffle = 7; }));
  EXPECT_TRUE(differs([](Case& c) { c.resolution.dt = 7; }));
  EXPECT_TRUE(differs([](Case& c) { c.resolution.steps = 7; }));
  EXPECT_TRUE(differs([](Case& c) { c.measure.every_step = true; }));
  EXPECT_TRUE(differs([](Case& c) { c.measure.nodal_error = true; }));
  EXPECT_TRUE(differs([](Case& c) { c.measure.velocity_error = true; }));
  EXPECT_TRUE(differs([](Case& c) { c.measure.stress_error = true; }));
  EXPECT_TRUE(differs([](Case& c) { c.measure.blowup_error = 7; }));
  EXPECT_TRUE(differs([](Case& c) { c.measure.blowup_energy = 7; }));
  EXPECT_TRUE(differs([](Case& c) { c.measure.whole = true; }));
  EXPECT_TRUE(differs([](Case& c) { c.measure.repeat = 7; }));
}

/// A member without a key would be missing in the text, and two different cases have the same.
TEST(CanonicalText, EveryMemberHasItsKey) {
  const auto keys = [](CasePart part) {
    return std::ranges::count_if(setting_keys(),
                                 [part](const SettingKey& key) { return key.member && key.member->part == part; });
  };
  EXPECT_EQ(keys(CasePart::problem), count_members<ProblemChoice>() - 3) << "name, parameters and end time are its own";
  EXPECT_EQ(keys(CasePart::scheme), count_members<Scheme>());
  EXPECT_EQ(keys(CasePart::resolution), count_members<Resolution>());
  EXPECT_EQ(keys(CasePart::measure), count_members<Measure>());
}

// Known values of 64-bit FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv.
TEST(Fingerprint, IsFnv1a) {
  EXPECT_EQ(fingerprint(""), "cbf29ce484222325");
  EXPECT_EQ(fingerprint("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(fingerprint("foobar"), "85944171f73967e8");
}

TEST(Words, OfAStoreReadBack) {
  for (const Status s : {Status::ok, Status::unstable, Status::failed})
    EXPECT_EQ(from_word<Status>(to_string(s), "status"), s);
  for (const PartVerdict v : {PartVerdict::holds, PartVerdict::fails, PartVerdict::shown, PartVerdict::inconclusive})
    EXPECT_EQ(from_word<PartVerdict>(to_string(v), "verdict"), v);
  for (const char* word : {"convergence", "limit", "check"})
    EXPECT_EQ(to_string(from_word<records::StudyKind>(word, "kind of a study")), word);
  for (const char* word : {"curves", "work-precision", "particles"})
    EXPECT_EQ(to_string(from_word<records::Figure::Kind>(word, "figure kind")), word);
  EXPECT_EQ(to_string(Status::unstable), "unstable");
  EXPECT_EQ(to_string(PartVerdict::inconclusive), "inconclusive");
  EXPECT_THROW(from_word<Status>("fine", "status"), support::UsageError);
  EXPECT_THROW(from_word<PartVerdict>("", "verdict"), support::UsageError);
  EXPECT_EQ(to_string(Position::second_order), "second-order");
}

}  // namespace mpmvv::cases::case_test
