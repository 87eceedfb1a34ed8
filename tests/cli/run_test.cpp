#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv::cli {
namespace run_test {

using testing::HasSubstr;

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
  EXPECT_LT(record["error"]["l1"], record["error"]["l2"]);
  EXPECT_LT(record["error"]["l2"], record["error"]["linf"]);
  EXPECT_LT(record["error"]["linf"], 1e-3);
}

TEST(RunCommand, EveryStepBoundsTheEnd) {
  const Folder folder;
  const auto error = call(folder, std::string(bar) + "--every-step --json").json()["error"];
  EXPECT_GE(error["linf_all_steps"], error["linf"]);
}

TEST(RunCommand, NodalErrorIsShownWhenMeasured) {
  const Folder folder;
  const auto error = call(folder, std::string(bar) + "--nodal-error --json").json()["error"];
  EXPECT_GT(error["nodal_l1"], 0);
  EXPECT_LT(error["nodal_l1"], error["nodal_l2"]);
  EXPECT_LT(error["nodal_l2"], error["nodal_linf"]);
}

TEST(RunCommand, ThreadsDoNotChangeOneBit) {
  const Folder folder;
  const auto one = call(folder, std::string(bar) + "--threads 1 --json").json();
  const auto two = call(folder, std::string(bar) + "--threads 2 --json").json();
  EXPECT_EQ(one["error"], two["error"]);
  EXPECT_EQ(one["energy"], two["energy"]);
}

TEST(RunCommand, CostIsEvidenceOnlyWhenItIsAskedFor) {
  const Folder folder;
  const std::string command = "run --problem bar --cells 16 --ppc 4 --cfl 0.3 --json";
  const auto plain = call(folder, command).json(), costed = call(folder, command + " --repeat 3").json();
  EXPECT_TRUE(plain["cost"]["step_seconds"].is_null());
  const double seconds = costed["cost"]["step_seconds"];
  EXPECT_GT(seconds, 0);
  EXPECT_GE(costed["cost"]["spread"], 0);
  EXPECT_NEAR(seconds,
              1e-9 * costed["ns_per_particle_step"].get<double>() * costed["particles"].get<double>() *
                  costed["steps"].get<double>(),
              1e-9 * seconds);
  EXPECT_EQ(costed["error"], plain["error"]);
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

TEST(RunCommand, AmplitudesOfEitherSignAndNoneAreStable) {
  const Folder folder;
  for (const char* amplitude : {"0.05", "-0.05", "0"})
    EXPECT_EQ(call(folder, std::string(bar) + "--json --param amplitude=" + amplitude).json()["status"], "ok")
        << amplitude;
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

/// Every problem with a solution runs with its defaults, near its solution, at rest without amplitude, and on two
/// threads to the same bit.
TEST(RunCommand, EveryProblemFollowsItsSolution) {
  const Folder folder;
  for (const char* choice :
       {"bar --basis cpgimp --cells 10", "square --basis cpgimp --cells 10", "cube --basis cpgimp --cells 10",
        "ring --basis cpgimp --cells 10", "ring --basis bspline3 --cells 10 --fill conforming --quarter",
        "ring --basis bspline3 --cells 10 --fill conforming --quarter --param poissons_ratio=0.3",
        "vortex --basis bspline3 --cells 24 --fill conforming",
        "shell --basis bspline2 --cells 10 --fill conforming --quarter"}) {
    const std::string run = std::string("run --integrator cd --ppc 2 --cfl 0.4 --json --problem ") + choice + ' ';
    const auto record = call(folder, run).json();
    EXPECT_EQ(record["status"], "ok") << choice;
    EXPECT_LT(record["error"]["l2"], 0.1 * record["parameters"]["amplitude"].get<double>()) << choice;
    const std::string start = run + "--steps 10 ";
    EXPECT_LT(call(folder, start + "--param amplitude=0").json()["error"]["linf"], 1e-15) << choice;
    EXPECT_EQ(call(folder, start + "--threads 2").json()["error"], call(folder, start).json()["error"]) << choice;
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

struct BadInput {
  const char* arguments;
  const char* message;
};

void PrintTo(const BadInput& bad, std::ostream* out) {
  *out << bad.arguments;
}

class BadRun : public testing::TestWithParam<BadInput> {};

TEST_P(BadRun, OneLineAndExitTwo) {
  const Folder folder;
  const Answer answer = call(folder, GetParam().arguments);
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(answer.out, "");
  EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
  EXPECT_THAT(answer.err, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    , BadRun,
    testing::Values(
        BadInput{"run --problem beam --cells 8 --ppc 2 --cfl 0.1", "unknown problem 'beam' in --problem (known: bar"},
        BadInput{"run --problem bar --basis bspline4 --cells 8 --ppc 2 --cfl 0.1",
                 "unknown basis 'bspline4' in --basis (known: linear"},
        BadInput{"run --problem bar --cells 8 --ppc 0 --cfl 0.1", "ppc = 0 in --ppc (a whole number from 1"},
        BadInput{"run --problem bar --cells -8 --ppc 2 --cfl 0.1", "cells = -8 in --cells"},
        BadInput{"run --problem bar --cells 8.5 --ppc 2 --cfl 0.1", "cells = 8.5 in --cells"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl nan", "cfl = 'nan' in --cfl (a finite number)"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl -0.1", "cfl = -0.1 in --cfl (a number > 0)"},
        BadInput{"run --problem bar --cells 8 --ppc 2", "neither cfl nor dt"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.1 --repeat 2", "repeat = 2 in --repeat (a whole number"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.1 --repeat 3 --threads 2", "--threads beside --repeat"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.1 --repeat 3 --vtu frames", "--vtu beside --repeat"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.1 --dt 1e-5", "both cfl and dt"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --dt 3e-6",
                 "does not divide the end time 0.01 s (the nearest that does: 3.00"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.2 --param density=1 --param density=2",
                 "each parameter once"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.1 --param amplitud=0.1", "unknown parameter 'amplitud'"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.1 --param amplitude=0.5", "allowed: between"},
        BadInput{"run --problem bar --basis bspline2-open --boundary periodic --cells 8 --ppc 2 --cfl 0.1",
                 "has no ghost nodes"},
        BadInput{"run --problem bar --boundary xmin=dirichlet --cells 8 --ppc 2 --cfl 0.1",
                 "does not name face 'xmax'"},
        BadInput{"run --problem bar --boundary xmin=periodic,xmax=free --cells 8 --ppc 2 --cfl 0.1", "one face only"},
        BadInput{"run --problem bar --boundary free --wall-acceleration difference --cells 8 --ppc 2 --cfl 0.1",
                 "holds no node"},
        BadInput{"run --problem bar --basis ugimp --cells 8 --ppc 2 --cfl 0.1", "without smoothing_length"},
        BadInput{"run --problem bar --integrator usl --start half --cells 8 --ppc 2 --cfl 0.1",
                 "no meaning for integrator 'usl'"},
        BadInput{"run --problem bar --colour red", "--colour"}, BadInput{"", "unknown command"},
        BadInput{"frobnicate", "unknown command 'frobnicate' (known: run"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl ''", "--cfl: an empty text"},
        BadInput{"run --problem bar --boundary '' --cells 8 --ppc 2 --cfl 0.1", "--boundary: an empty text"},
        BadInput{
            "run --problem bar --boundary dirichlet --integrator uvf --wall-acceleration difference --cells 8 --ppc 2 "
            "--cfl 0.1",
            "maps the velocity after"},
        BadInput{"solution --problem bar --at 0.5, --time 0", "coordinate = ''"},
        BadInput{"list > /dev/full", "standard output"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.1 --vtu /dev/null/x", "--vtu"},
        BadInput{"solution --problem bar --at 0.2 --time 1e308", "time = 1e308 in --time (0, or a number from 1e-150"},
        BadInput{"solution --problem stretch --param rate=1e10 --at 0.2,0.2 --time 1e150",
                 "not finite with --at 0.2,0.2 and --time 1e150"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.2 --vtu ''", "--vtu: an empty text"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.2 --param ''", "--param: an empty text"},
        BadInput{"compare '' --db /tmp/never.db", "from: an empty text"},
        BadInput{"report --db /tmp/never.db --out ''", "--out: an empty text"},
        BadInput{"gate --db /tmp/never.db --junit ''", "--junit: an empty text"},
        BadInput{"db export --db /tmp/never.db --out ''", "--out: an empty text"},
        BadInput{"study '' --db /tmp/never.db", "files: an empty text"},
        BadInput{"solution --problem ring --at 0.1,0.1 --time 0", "between the radii"},
        BadInput{"solution --problem ring --at 0.6,0.1 --time 0 --param outer_radius=1.5", "three times"},
        BadInput{"solution --problem ring --at 0.6,0.1 --time 0 --param amplitude=0.9", "det F"},
        BadInput{"solution --problem vortex --at 0.8,0.1 --time 0 --param inner_radius=2", "not below"},
        BadInput{"run --problem bar --velocity-update fmpm --cells 8 --ppc 2 --cfl 0.1", "no order given"},
        BadInput{"run --problem bar --velocity-update pic --order 2 --cells 8 --ppc 2 --cfl 0.1", "no meaning"},
        BadInput{"run --problem bar --velocity-update pic --position particle --cells 8 --ppc 2 --cfl 0.1",
                 "only flip takes it"},
        BadInput{"run --problem bar --velocity-update xpic --order 0 --cells 8 --ppc 2 --cfl 0.1", "order = 0"},
        BadInput{"run --problem bar --velocity-update xpic --order 2 --cfl-x 1 --cells 8 --ppc 2 --cfl 0.1",
                 "only fmpm takes it"},
        BadInput{"run --problem bar --velocity-update fmpm --order 2 --integrator cd --cells 8 --ppc 2 --cfl 0.1",
                 "at their ends"},
        BadInput{"run --problem bar --velocity-update fmpm --order 2 --mass consistent --cells 8 --ppc 2 --cfl 0.1",
                 "nothing is expanded"},
        BadInput{"run --problem impact --nodal-error --cells 4 --ppc 2 --cfl 0.2", "no exact acceleration"},
        BadInput{"run --problem impact --integrator cd --start exact --cells 4 --ppc 2 --cfl 0.2", "no exact velocity"},
        BadInput{"run --problem impact --material neo-hookean-log --cells 4 --ppc 2 --cfl 0.2", "it is of neo-hookean"},
        BadInput{"run --problem vortex --quarter --cells 8 --ppc 2 --cfl 0.1", "no planes of symmetry"},
        BadInput{"run --problem square --fill conforming --cells 8 --ppc 2 --cfl 0.1", "a lattice fills"},
        BadInput{"run --problem ring --param poissons_ratio=0.3 --cells 8 --ppc 2 --cfl 0.1", "use conforming"},
        BadInput{"solution --problem bar --at 1.5 --time 0", "outside the body"},
        BadInput{"solution --problem bar --at 0.5,0.5 --time 0", "has 2 coordinates"},
        BadInput{"solution --problem cube --at 0.5,0.5 --time 0", "has 2 coordinates"},
        BadInput{"run --problem square --cells 8 --ppc 2 --cfl 0.1 --param amplitude=0.32", "between -1/pi and 1/pi"},
        BadInput{"run --problem cube --cells 8 --ppc 2 --cfl 0.1 --param poissons_ratio=0.5",
                 "allowed: > -1 and < 0.5"},
        BadInput{"solution --problem one-particle --at 0.5 --time 0", "no exact solution"},
        BadInput{"list colours", "nothing to list under 'colours'"},
        BadInput{"claims --db /nowhere/at/all.db", "/nowhere/at/all.db"},
        BadInput{"study /nowhere.toml --db /tmp/never.db", "/nowhere.toml"}));

TEST(SolutionCommand, GivesTheFieldsOfTheBar) {
  const Folder folder;
  const auto s = call(folder, "solution --problem bar --at 0.2 --time 0.001 --json").json();
  const double pi = std::acos(-1.0), u = 0.05 * std::sin(0.4 * pi) * std::cos(0.1 * pi);
  const double F = 1 + 0.1 * pi * std::cos(0.4 * pi) * std::cos(0.1 * pi);
  EXPECT_NEAR(s["u"][0], u, 1e-15);
  EXPECT_NEAR(s["F"][0][0], F, 1e-15);
  EXPECT_NEAR(s["P"][0][0], 5000 * (F - 1 / F), 1e-10);
  EXPECT_NEAR(s["b"][0], 1e4 * pi * pi * u * (2 / (F * F) + 1), 1e-9);
}

/// W (56) to (59) and S (51) to (53) as printed.
TEST(SolutionCommand, GivesTheFieldsOfSquareAndCube) {
  const Folder folder;
  const double pi = std::acos(-1.0), E = 1e4, lambda = E * 0.3 / (1.3 * 0.4), mu = E / 2.6;
  const auto square = call(folder, "solution --problem square --at 0.2,0.7 --time 0.001 --json").json();
  {
    const double u = 0.1 * std::sin(0.2 * pi) * std::cos(0.1 * pi);
    const double F = 1 + 0.1 * pi * std::cos(0.2 * pi) * std::cos(0.1 * pi);
    const double K = std::log(F * (1 + 0.1 * pi * std::cos(0.7 * pi) * std::sin(0.1 * pi)));
    EXPECT_NEAR(square["u"][0], u, 1e-15);
    EXPECT_NEAR(square["F"][0][0], F, 1e-15);
    EXPECT_NEAR(square["P"][0][0], lambda / F * K + mu / F * (F * F - 1), 1e-10);
    EXPECT_NEAR(square["b"][0], pi * pi * u * (lambda / (F * F) * (1 - K) + mu * (1 + 1 / (F * F)) - E), 1e-9);
  }
  const auto cube = call(folder, "solution --problem cube --at 0.2,0.7,0.4 --time 0.001 --json").json();
  {
    const double phase = 2 * pi / 3, u = 0.05 * std::sin(1.4 * pi) * std::sin(phase + 0.1 * pi);
    const auto F_at = [&](double x, double shift) {
      return 1 + 0.1 * pi * std::cos(2 * pi * x) * std::sin(shift + 0.1 * pi);
    };
    const double F = F_at(0.7, phase), K = std::log(F_at(0.2, 0) * F * F_at(0.4, 2 * phase));
    EXPECT_NEAR(cube["u"][1], u, 1e-15);
    EXPECT_NEAR(cube["F"][1][1], F, 1e-15);
    EXPECT_NEAR(cube["b"][1], pi * pi * u * (4 * mu - E - 4 * (lambda * (K - 1) - mu) / (F * F)), 1e-9);
  }
}

TEST(ListCommand, NamesProblemsAndWords) {
  const Folder folder;
  const auto all = call(folder, "list --json").json();
  EXPECT_THAT(all["bases"].get<std::vector<std::string>>(),
              testing::IsSupersetOf({"linear", "bspline2", "bspline3", "bspline2-open", "bspline3-open", "ugimp",
                                     "gimp", "cpgimp", "cpdi"}));
  EXPECT_EQ(all["problems"][0]["name"], "bar");
}

}  // namespace run_test
}  // namespace mpmvv::cli
