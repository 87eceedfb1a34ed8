#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv::cli::run_refusal_test {

using testing::HasSubstr;

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

TEST(NoCommand, IsAnsweredByTheHelpOnStandardError) {
  const Folder folder;
  for (const std::string command : {"", "db"}) {
    const Answer answer = call(folder, command);
    EXPECT_EQ(answer.code, 2);
    EXPECT_EQ(answer.out, "");
    EXPECT_EQ(answer.err, call(folder, command + " --help").out);
  }
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
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 1e308", "cfl = 1e308 in --cfl (a number from 1e-150 to"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.2 --cfl 0.3", "--cfl stands there several times (once)"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl", "--cfl without its value"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.2 --threads 0", "--threads: 0 (a whole number from 1 to"},
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
        BadInput{"run --problem bar --colour red", "--colour"},
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
        BadInput{"run --problem bar --velocity-update fmpm --cells 8 --ppc 2 --cfl 0.1",
                 "velocity_update 'fmpm' without order (its k, from 1 on: --order 2"},
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
        BadInput{"solution --problem one-particle --at 0.5 --time 0",
                 "no exact solution (problems that have one: bar, square, "},
        BadInput{"list colours", "unknown list 'colours'"},
        BadInput{"claims --db /nowhere/at/all.db", "/nowhere/at/all.db"},
        BadInput{"study /nowhere.toml --db /tmp/never.db", "/nowhere.toml"}));

}  // namespace mpmvv::cli::run_refusal_test
