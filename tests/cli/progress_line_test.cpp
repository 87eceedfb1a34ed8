#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::progress_line_test {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST(ProgressLine, SaysOnATerminalHowLongTheRestTakes) {
  const Folder folder;
  const std::string study =
      "'" + program() + "' study '" + folder.write("small.toml", small_study) + "' --db '" + (folder / "r.db") + "'";
  const std::string shown = shell("SHELL=/bin/sh script -qec \"" + study + "\" /dev/null").out;
  EXPECT_THAT(shown, ContainsRegex("\r\033\\[K\\[0/8\\] about [0-9.]+ (s|min|h) left"));
  EXPECT_THAT(shown, ContainsRegex("\\[8/8\\] all done  bar [a-z0-9]+ cd periodic"));
  EXPECT_THAT(shown, HasSubstr("\r\033[Ksmall: Small\r\n")) << "gone before the results";
}

TEST(ProgressLine, SaysOfARunHowFarItsStepsHaveCome) {
  const std::string run =
      "'" + program() + "' run --problem bar --basis bspline2 --integrator cd --cells 4096 --ppc 2 --cfl 0.4";
  const std::string shown = shell("SHELL=/bin/sh script -qec \"" + run + "\" /dev/null").out;
  EXPECT_THAT(shown, ContainsRegex("\r\033\\[K\\[[0-9]+/[0-9]+\\] about [0-9.]+ (s|min|h) left  steps of bar"));
  EXPECT_THAT(shell(run + " 2>&1").out, Not(HasSubstr("steps of bar"))) << "not where nobody watches";
}

}  // namespace mpmvv::cli::progress_line_test
