#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv::cli::vtu_test {

/// The reader of VTK, Debian's python3-vtk9.
TEST(VtuNightly, VtkReadsTheSeriesAndTheErrorIsThatOfTheRecord) {
  if (shell("/usr/bin/python3 -c 'import vtkmodules.vtkIOXML' 2>&1").code != 0) GTEST_SKIP() << "no VTK (python3-vtk9)";
  const Folder folder;
  const Answer run = call(folder,
                          "run --problem square --basis cpgimp --integrator cd --boundary symmetry --cells 8 "
                          "--ppc 2 --cfl 0.4 --json --vtu '" +
                              (folder / "frames") + "'");
  ASSERT_EQ(run.code, 0) << run.err;
  const Answer read = shell("/usr/bin/python3 '" MPMVV_SOURCE_DIR "/tests/cli/read_vtu.py' '" + (folder / "frames") +
                            "' '" + program() + "' square 2>&1");
  ASSERT_EQ(read.code, 0) << read.out;
  const auto record = run.json(), found = read.json();
  EXPECT_EQ(found["frames"], 11);
  for (const auto& particles : found["particles"]) EXPECT_EQ(particles, record["particles"]);
  EXPECT_EQ(found["cells"], record["particles"]);
  EXPECT_EQ(found["start"], 0);
  EXPECT_NEAR(found["time"].get<double>(), record["end_time"].get<double>(), 1e-12);
  EXPECT_NEAR(found["l2"].get<double>(), record["error"]["l2"].get<double>(), 1e-12);
}

}  // namespace mpmvv::cli::vtu_test
