#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv::cli::reference_test {

/// In numpy, Debian's python3-numpy: tests/reference/mpm.py.
TEST(ReferenceNightly, ASecondImplementationHasTheSameParticles) {
  if (shell("/usr/bin/python3 -c 'import numpy' 2>&1").code != 0) GTEST_SKIP() << "no numpy (python3-numpy)";
  const Answer compared =
      shell("/usr/bin/python3 '" MPMVV_SOURCE_DIR "/tests/reference/compare.py' '" + program() + "' 2>&1");
  EXPECT_EQ(compared.code, 0) << compared.out;
}

}  // namespace mpmvv::cli::reference_test
