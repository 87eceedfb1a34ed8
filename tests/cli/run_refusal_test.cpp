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

/// Of settings one or two: tests/studies/settings/refusal_test.cpp has the others.
INSTANTIATE_TEST_SUITE_P(
    , BadRun,
    testing::Values(
        BadInput{"run --problem bar --basis bspline4 --cells 8 --ppc 2 --cfl 0.1",
                 "unknown basis 'bspline4' in --basis; did you mean 'bspline2'? (known: linear, bspline2"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.2 --cfl 0.3", "--cfl stands there several times (once)"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl", "--cfl without its value"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.2 --threads 0", "--threads: 0 (a whole number from 1 to"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.1 --repeat 3 --threads 2", "--threads beside --repeat"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.1 --repeat 3 --vtu frames", "--vtu beside --repeat"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.2 --param density=1 --param density=2",
                 "each parameter once"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl ''", "--cfl: an empty text"},
        BadInput{"solution --problem bar --at 0.5, --time 0", "coordinate = ''"},
        BadInput{"list > /dev/full", "standard output"},
        BadInput{"run --problem bar --cells 8 --ppc 2 --cfl 0.1 --vtu /dev/null/x", "--vtu"},
        BadInput{"solution --problem bar --at 0.2 --time 1e308", "time = 1e308 in --time (0, or a number from 1e-150"},
        BadInput{"solution --problem stretch --param rate=1e10 --at 0.2,0.2 --time 1e150",
                 "not finite with --at 0.2,0.2 and --time 1e150"},
        BadInput{"report --db /tmp/never.db --out ''", "--out: an empty text"},
        BadInput{"study '' --db /tmp/never.db", "files: an empty text"},
        BadInput{"solution --problem ring --at 0.1,0.1 --time 0", "between the radii"},
        BadInput{"run --problem vortex --quarter --cells 8 --ppc 2 --cfl 0.1", "no planes of symmetry"},
        BadInput{"solution --problem bar --at 1.5 --time 0", "outside the body"},
        BadInput{"solution --problem cube --at 0.5,0.5 --time 0", "has 2 coordinates"},
        BadInput{"solution --problem one-particle --at 0.5 --time 0",
                 "no exact solution (problems that have one: bar, square, "},
        BadInput{"claims --db /nowhere/at/all.db", "/nowhere/at/all.db"},
        BadInput{"study /nowhere.toml --db /tmp/never.db", "/nowhere.toml"}));

}  // namespace mpmvv::cli::run_refusal_test
