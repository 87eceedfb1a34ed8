#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

/// Errors that are the problem's and not the method's.
namespace mpmvv::cli::study_floor_test {

using testing::HasSubstr;

/// At this amplitude the nonlinear law moves the wave by more than our solver errs.
constexpr const char* finite_wave_study = R"(title = "Wave of a finite law"
claims = []
[fixed]
problem = "wave"
param = { amplitude = 0.02 }
material = "neo-hookean-log"
ppc = 2
cfl = 0.4
end_time = 0.02155
[[series]]
name = "gimp"
basis = "cpgimp"
integrator = "cd"
[sweep]
cells = [8, 16, 32]
[[fit]]
norm = "l2"
window = [8, 32]
)";

TEST(StudyCommand, GivesNoOrderNearTheErrorOfTheSolution) {
  const Folder folder;
  const Answer answer =
      call(folder, "study " + folder.write("wave.toml", finite_wave_study) + " --db " + (folder / "r.db"));
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out,
              HasSubstr("left out of the order of 'gimp' in l2: 8, 16, 32 (within 10 times the error of the "
                        "solution,"));
}

}  // namespace mpmvv::cli::study_floor_test
