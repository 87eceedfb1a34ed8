#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

/// What `mpmvv score` says of errors that a case asks for.
namespace mpmvv::cli::score_words_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string the_case =
    "--problem stretch-1d --basis bspline2 --cells 8 --ppc 2 --cfl 0.4 --end-time 8 --velocity-error --stress-error";

TEST(ScoreWords, TheVelocityErrorOfAnOutputIsThatAtItsEnd) {
  const Folder folder;
  const Answer run =
      carry_out(folder, "mpmvv case " + the_case + " > case.json; mpmvv run " + the_case + " --vtu frames");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("velocity, mean of all steps (% of speed)"));
  const Answer score = carry_out(folder, "mpmvv score case.json frames/particles-0010.vtu");
  EXPECT_EQ(score.code, 0) << score.err;
  EXPECT_THAT(score.out, AllOf(HasSubstr("velocity at the end (% of speed)"), Not(HasSubstr("mean of all steps"))));
}

TEST(ScoreWords, NamesTheErrorsThatAnOutputDoesNotGive) {
  const Folder folder;
  const std::string positions =
      "mpmvv case " + the_case + " > case.json; mpmvv particles " + the_case +
      " | mpmvv solution --problem stretch-1d --points - --time 8 --fields u"
      " | awk -F, 'NR == 1 { print \"id,x\" } NR > 1 { printf \"%d,%.17g\\n\", NR - 1, $1 + $3 }' > end.csv; ";
  const Answer score = carry_out(folder, positions + "mpmvv score case.json end.csv");
  EXPECT_EQ(score.code, 0) << score.out << score.err;
  EXPECT_THAT(score.out, HasSubstr("status ok"));
  EXPECT_THAT(score.err, AllOf(HasSubstr("no velocity error: end.csv has no velocities, or some that are no numbers"),
                               HasSubstr("no stress error: end.csv has no stresses, or some that are no numbers")));
}

}  // namespace mpmvv::cli::score_words_test
