#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <sstream>

#include "mms/catalogue.hpp"
#include "tests/own_folder.hpp"

/// The examples in other languages, run as their users would: each prints X, u and b of the same three points.
namespace mpmvv::examples_test {

std::string output_of(const std::string& command) {
  std::FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

void expect_the_ring(const std::string& command) {
  const auto ring =
      mms::make<2>("ring", mms::complete(mms::entry_named("ring"), {{"amplitude", 0.05}, {"poissons_ratio", 0.3}}));
  std::istringstream lines(output_of(command));
  int points = 0;
  for (std::string line; std::getline(lines, line); ++points) {
    std::istringstream numbers(line);
    mms::Vec<2> X, u, b;
    numbers >> X[0] >> X[1] >> u[0] >> u[1] >> b[0] >> b[1];
    ASSERT_TRUE(numbers) << line;
    EXPECT_LT((u - ring->u(X, 0.004)).norm(), 1e-16) << line;
    EXPECT_LT((b - ring->b(X, 0.004)).norm(), 1e-12 * b.norm()) << line;
  }
  EXPECT_EQ(points, 3);
}

TEST(Examples, InC) {
  expect_the_ring("'" MPMVV_C_EXAMPLE "'");
}

TEST(Examples, InFortran) {
  if (std::string(MPMVV_FORTRAN_EXAMPLE).empty()) GTEST_SKIP() << "there is no Fortran compiler";
  expect_the_ring("'" MPMVV_FORTRAN_EXAMPLE "'");
}

TEST(Examples, InPython) {
  expect_the_ring("python3 '" MPMVV_SOURCE_DIR "/mms/c/examples/ring.py' '" MPMVV_MMS_LIBRARY "'");
}

TEST(Examples, SeeTheInterfaceAlone) {
  std::istringstream symbols(output_of("nm -D --defined-only '" MPMVV_MMS_LIBRARY "'"));
  int seen = 0;
  for (std::string address, kind, name; symbols >> address >> kind >> name; ++seen)
    EXPECT_TRUE(name.starts_with("mpmvv_") || name == "MPMVV_MMS_1") << name;
  EXPECT_GT(seen, 15);
}

/// The libraries as installed, in a place to which they were moved, under a project that knows nothing else of mpmvv.
TEST(FindPackageNightly, GivesAProjectElsewhereTheRing) {
  namespace fs = std::filesystem;
  const fs::path folder = own_folder("package");
  const std::string installed = folder / "installed", moved = folder / "moved", build = folder / "build";
  output_of("cmake --install '" MPMVV_BUILD_DIR "' --component library --prefix '" + installed + "'");
  fs::rename(installed, moved);
  output_of("cmake -S '" MPMVV_SOURCE_DIR "/tests/package' -B '" + build + "' -DCMAKE_PREFIX_PATH='" + moved +
            "' -DRING_C='" MPMVV_SOURCE_DIR "/mms/c/examples/ring.c' && cmake --build '" + build + "'");
  expect_the_ring("'" + build + "/outside_in_c'");
  expect_the_ring("'" + build + "/outside_in_cpp'");
  EXPECT_FALSE(fs::exists(moved + "/bin")) << "the program is another component";
  fs::remove_all(folder);
}

}  // namespace mpmvv::examples_test
