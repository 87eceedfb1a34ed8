#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv::cli::run_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* bar =
    "run --problem bar --basis bspline2 --integrator cd --boundary periodic --cells 32 --ppc 4 --cfl 0.2 ";

TEST(RunCommand, RecordHasWhatTheContractNames) {
  const Folder folder;
  const Answer answer = call(folder, std::string(bar) + "--json");
  ASSERT_EQ(answer.code, 0) << answer.err;
  const auto record = answer.json();
  for (const char* key : {"problem", "scheme", "cells", "ppc", "particles", "steps", "dt", "cfl", "end_time", "status",
                          "error", "energy", "wall_seconds", "ns_per_particle_step"})
    EXPECT_TRUE(record.contains(key)) << key;
  EXPECT_EQ(record["status"], "ok");
  EXPECT_EQ(record["particles"], 128);
  EXPECT_EQ(record["scheme"]["basis"], "bspline2");
  EXPECT_EQ(record["scheme"]["start"], "half");
  EXPECT_TRUE(record["error"]["linf_all_steps"].is_null());
  EXPECT_TRUE(record["error"]["nodal_l2"].is_null());
  EXPECT_NEAR(record["dt"].get<double>() * record["steps"].get<int>(), 0.01, 1e-15);
  const auto error = [&](const char* norm) { return record["error"][norm].get<double>(); };  // null is below any number
  EXPECT_LT(error("l1"), error("l2"));
  EXPECT_LT(error("l2"), error("linf"));
  EXPECT_LT(error("linf"), 1e-3);
}

TEST(RunCommand, ErrorsThatAreAskedForAreShown) {
  const Folder folder;
  const auto error = call(folder, std::string(bar) + "--every-step --nodal-error --json").json()["error"];
  EXPECT_GE(error["linf_all_steps"], error["linf"]);
  EXPECT_GT(error["nodal_l1"], 0);
  EXPECT_LT(error["nodal_l1"], error["nodal_l2"]);
  EXPECT_LT(error["nodal_l2"], error["nodal_linf"]);
}

TEST(RunCommand, CostIsEvidenceOnlyWhenItIsAskedFor) {
  const Folder folder;
  const std::string command = "run --problem bar --cells 16 --ppc 4 --cfl 0.3 --json";
  const auto plain = call(folder, command).json(), costed = call(folder, command + " --repeat 3").json();
  EXPECT_TRUE(plain["cost"]["step_seconds"].is_null());
  const double seconds = costed["cost"]["step_seconds"];
  EXPECT_GT(seconds, 0);
  EXPECT_GE(costed["cost"]["spread"], 0);
  EXPECT_EQ(costed["cost"]["rounds"].size(), 3U);
  EXPECT_TRUE(costed["cost"]["session"].is_string());
  EXPECT_FALSE(plain["cost"].contains("rounds"));
  const std::string in_words = "run --problem bar --cells 16 --ppc 4 --repeat 3 ";
  EXPECT_THAT(call(folder, in_words + "--cfl 0.3").out, HasSubstr(" s of steps, geometric mean of 3 rounds"));
  EXPECT_THAT(call(folder, in_words + "--cfl 3").out, AllOf(HasSubstr("unstable"), Not(HasSubstr("cost"))));
  EXPECT_NEAR(seconds,
              1e-9 * costed["ns_per_particle_step"].get<double>() * costed["particles"].get<double>() *
                  costed["steps"].get<double>(),
              1e-9 * seconds);
  EXPECT_EQ(costed["error"], plain["error"]);
}

/// A quarter of the vortex, unless all of it is asked for, to be seen or to be timed.
TEST(RunCommand, TakesThePartOfABodyThatGivesTheSame) {
  const Folder folder;
  const std::string command =
      "run --problem vortex --fill conforming --basis bspline2 --integrator cd --cells 8 --ppc 2 --cfl 0.2 ";
  const auto part = call(folder, command + "--json").json(), whole = call(folder, command + "--json --whole").json();
  EXPECT_EQ(part["images"], 4);
  EXPECT_EQ(whole["images"], 1);
  EXPECT_EQ(part["particles"], whole["particles"]);
  EXPECT_NEAR(part["error"]["l2"], whole["error"]["l2"], 1e-12 * whole["error"]["l2"].get<double>());
  EXPECT_EQ(call(folder, command + "--json --vtu '" + (folder / "frames") + "'").json()["error"], whole["error"]);
  EXPECT_EQ(call(folder, command + "--json --repeat 3").json()["error"], whole["error"]);
  const std::string said = "a part was run, of which 4 images make the body (--whole runs all of it)\n";
  EXPECT_THAT(call(folder, command).out, AllOf(HasSubstr(said), Not(HasSubstr("change of momentum")),
                                               HasSubstr(" ns per particle of the part and step\n")));
  EXPECT_THAT(call(folder, command + "--whole").out, AllOf(Not(HasSubstr("images")), HasSubstr("change of momentum")));
}

TEST(RunCommand, SaysTheErrorOfASolutionThatIsNotOfTheLaw) {
  const Folder folder;
  const std::string wave = "run --problem wave --cells 8 --ppc 2 --cfl 0.2 --steps 4 ";
  EXPECT_THAT(call(folder, wave + "--material neo-hookean-log").out,
              HasSubstr("error of the solution for this law (m)"));
  EXPECT_THAT(call(folder, wave).out, Not(HasSubstr("for this law")));
}

TEST(RunCommand, ABlownUpRunIsAResult) {
  const Folder folder;
  const Answer answer =
      call(folder, "run --problem bar --basis linear --integrator usl --cells 32 --ppc 4 --cfl 3 --json");
  EXPECT_EQ(answer.code, 0) << answer.err;
  const auto record = answer.json();
  EXPECT_EQ(record["status"], "unstable");
  EXPECT_TRUE(record["error"]["linf"].is_null());
  EXPECT_THAT(record["reason"].get<std::string>(), HasSubstr("at step"));
}

TEST(RunCommand, WhatABlownUpRunHasNotMeasuredHasNoRow) {
  const Folder folder;
  const std::string run = "run --problem bar --integrator usl --cells 32 --ppc 4 ";
  const std::string unstable = call(folder, run + "--cfl 3").out;
  EXPECT_THAT(unstable, AllOf(HasSubstr("status unstable ("), HasSubstr("energy at the start (J/m²)"),
                              Not(HasSubstr("change of mass")), Not(HasSubstr("linf"))));
  EXPECT_THAT(call(folder, run + "--cfl 0.3 --steps 2").out, AllOf(HasSubstr("change of mass"), HasSubstr("linf")));
}

TEST(RunCommand, EnergiesAreThoseOfASquareMetreOrOfAMetreInFewerDimensions) {
  const Folder folder;
  for (const auto& [problem, unit] : {std::pair{"bar", "J/m²"}, {"square", "J/m"}, {"cube", "J"}})
    EXPECT_THAT(call(folder, std::string("run --cells 4 --ppc 1 --cfl 0.2 --steps 1 --problem ") + problem).out,
                AllOf(HasSubstr(std::string("kinetic energy at the end (") + unit + ")"),
                      HasSubstr(std::string("strain energy at the end (") + unit + ")")));
}

TEST(RunCommand, ANegativeAmplitudeIsStable) {
  const Folder folder;
  EXPECT_EQ(call(folder, std::string(bar) + "--json --param amplitude=-0.05").json()["status"], "ok");
}

/// Every integrator with every way to treat the acceleration of held nodes: close to each other, or refused.
TEST(RunCommand, WallAccelerationsOfEveryIntegratorAgree) {
  const Folder folder;
  for (const char* integrator : {"usl", "usf", "cd", "usavg", "usl+", "usavg+"}) {
    const auto error = [&](const char* acceleration) {
      return call(
                 folder,
                 std::string(
                     "run --problem bar --basis bspline2-open --boundary dirichlet --cells 32 --ppc 4 --cfl 0.1 --json "
                     "--integrator ") +
                     integrator + " --wall-acceleration " + acceleration)
          .json()["error"]["l2"]
          .get<double>();
    };
    EXPECT_NEAR(error("difference") / error("zero"), 1, 0.1) << integrator;
  }
}

/// Bodies of every kind, near their solutions, at rest without amplitude, and on two threads to the same bit.
TEST(RunCommand, EveryProblemFollowsItsSolution) {
  const Folder folder;
  for (const char* choice :
       {"bar --basis cpgimp --cells 10", "square --basis cpgimp --cells 10", "cube --basis cpgimp --cells 10",
        "ring --basis cpgimp --cells 20", "ring --basis bspline3 --cells 10 --fill conforming --quarter",
        "ring --basis bspline3 --cells 10 --fill conforming --quarter --param poissons_ratio=0.3",
        "vortex --basis bspline3 --cells 24 --fill conforming",
        "shell --basis bspline2 --cells 10 --fill conforming --quarter"}) {
    const std::string run = std::string("run --integrator cd --ppc 2 --cfl 0.4 --json --problem ") + choice + ' ';
    const auto record = call(folder, run).json();
    EXPECT_EQ(record["status"], "ok") << choice;
    EXPECT_LT(record["error"]["l2"].get<double>(), 0.1 * record["parameters"]["amplitude"].get<double>()) << choice;
    const std::string start = run + "--steps 10 ";
    const auto at_rest = call(folder, start + "--param amplitude=0").json();
    EXPECT_EQ(at_rest["status"], "ok") << choice;
    EXPECT_LT(at_rest["error"]["linf"].get<double>(), 1e-15) << choice << ", and null is below any number";
    const auto one = call(folder, start).json();
    EXPECT_EQ(one["status"], "ok") << choice;
    EXPECT_EQ(call(folder, start + "--threads 2").json()["error"], one["error"]) << choice;
  }
}

TEST(RunCommand, AQuarterContinuedByItsMirrorImagesMovesAsTheWhole) {
  const Folder folder;
  const std::string run =
      "run --problem ring --basis bspline3 --integrator cd --fill conforming --cells 8 --ppc 2 --cfl 0.4 --json ";
  const auto whole = call(folder, run).json(), quarter = call(folder, run + "--quarter").json();
  EXPECT_EQ(whole["particles"], 4 * quarter["particles"].get<int>());
  EXPECT_NEAR(quarter["error"]["linf"], whole["error"]["linf"], 1e-12);
}

/// FMPM(1) loses 20 to 90 % of the energy, N section 3.1; higher orders and FLIP much less.
TEST(RunCommand, ImpactLosesSomeOfItsEnergy) {
  const Folder folder;
  const std::string run = "run --problem impact --basis gimp --integrator usl --cells 4 --ppc 2 --cfl 0.2 --json ";
  const auto loss = [&](const std::string& update) {
    const auto energy = call(folder, run + "--velocity-update " + update).json()["energy"];
    return 1 -
           (energy["kinetic"].get<double>() + energy["strain"].get<double>()) / energy["initial_total"].get<double>();
  };
  const double flip = loss("flip --position second-order"), one = loss("fmpm --order 1"), four = loss("fmpm --order 4");
  EXPECT_GT(one, 0.2);
  EXPECT_LT(one, 0.9);
  EXPECT_LT(four, one / 2);
  EXPECT_LT(std::abs(flip), 0.3);
}

TEST(RunCommand, StepsKeepTheTimeStepOfTheWholeRun) {
  const Folder folder;
  const auto whole = call(folder, std::string(bar) + "--json").json();
  const auto part = call(folder, std::string(bar) + "--steps 3 --json").json();
  EXPECT_EQ(part["steps"], 3);
  EXPECT_EQ(part["dt"], whole["dt"]);
  EXPECT_DOUBLE_EQ(part["end_time"], 3 * whole["dt"].get<double>());
}

TEST(RunCommand, VtuStatesFollowTheBar) {
  const Folder folder;
  const std::string dir = folder / "vtu";
  ASSERT_EQ(call(folder, std::string(bar) + "--vtu " + dir).code, 0);
  const std::string first = read_text(dir + "/particles-0000.vtu"), last = read_text(dir + "/particles-0010.vtu");
  EXPECT_FALSE(std::filesystem::exists(dir + "/particles-0011.vtu"));
  EXPECT_THAT(first, HasSubstr("Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">\n0\n"));
  EXPECT_THAT(last, HasSubstr("<DataArray type=\"Int64\" Name=\"id\"")) << "they are sorted anew on the way";
  EXPECT_THAT(read_text(dir + "/particles.pvd"), HasSubstr("timestep=\"0\" file=\"particles-0000.vtu\""));
  // First particle: X = h/8, u = A sin 2πX, which has changed its sign after half a period.
  const auto displacement = [](const std::string& text) {
    return std::stod(text.substr(text.find('>', text.find("\"displacement\"")) + 1));
  };
  const double u = 0.05 * std::sin(2 * std::acos(-1.0) / 256);
  EXPECT_NEAR(displacement(first), u, 1e-15);
  EXPECT_NEAR(displacement(last), -u, 0.1 * u);
}

/// A folder shows one series: what is left of a longer one goes, what is not of one stays.
TEST(RunCommand, AVtuSeriesTakesThePlaceOfTheEarlierOne) {
  const Folder folder;
  const std::string dir = folder / "vtu";
  ASSERT_EQ(call(folder, std::string(bar) + "--vtu " + dir).code, 0);
  for (const char* foreign :
       {"particles-1.vtu", "my-particles-0009.vtu", "particles-0009.vtu.bak", "particles-000x.vtu", "notes"})
    folder.write(std::string("vtu/") + foreign, "mine");
  folder.write("vtu/particles-12345.vtu", "a series of more frames");
  ASSERT_EQ(call(folder, std::string(bar) + "--steps 3 --vtu " + dir).code, 0);
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(dir)) names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::UnorderedElementsAre("particles-0000.vtu", "particles-0001.vtu", "particles-0002.vtu",
                                                   "particles-0003.vtu", "particles.pvd", "particles-1.vtu",
                                                   "my-particles-0009.vtu", "particles-0009.vtu.bak",
                                                   "particles-000x.vtu", "notes"));
}

}  // namespace mpmvv::cli::run_test
