#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/cli/program.hpp"
#include "tests/walk.hpp"

/// What `cmake --install` and the Debian package put on a system.
namespace mpmvv::cli::install_test {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

const std::string build = std::filesystem::path(MPMVV_PROGRAM).parent_path();

TEST(Install, TheProgramFindsItsStudiesAndGoldensWhereverItLies) {
  const Folder folder;
  const std::string installed = folder / "installed", moved = folder / "moved", before = folder.write("before", "");
  const Answer install = shell("cmake --install '" + build + "' --prefix '" + installed + "' 2>&1");
  ASSERT_EQ(install.code, 0) << install.out;
  for (const char* file :
       {"share/man/man1/mpmvv.1.gz", "share/bash-completion/completions/mpmvv", "share/zsh/site-functions/_mpmvv",
        "share/fish/vendor_completions.d/mpmvv.fish", "share/doc/mpmvv/README.md",
        "share/doc/mpmvv/docs/first-study.md", "share/mpmvv/studies/s-fig10.toml", "share/mpmvv/studies/cost.txt",
        "share/mpmvv/adapters/small-mpm/adapter.toml"})
    EXPECT_TRUE(std::filesystem::exists(installed + "/" + file)) << file;
  EXPECT_FALSE(std::filesystem::exists(installed + "/share/mpmvv/studies/CMakeLists.txt"));
  EXPECT_EQ(shell("find '" + build + "' -name 'mpmvv.*' -newer '" + before + "'").out, "") << "left in the build";
  std::filesystem::rename(installed, moved);
  const Answer gate = shell("cd '" + (folder / "") + "' && PATH='" + moved +
                            "/bin':\"$PATH\" && mpmvv study s-jump --db r.db "
                            "&& mpmvv gate --only s-jump --db r.db 2>&1");
  EXPECT_EQ(gate.code, 0) << gate.out;
  EXPECT_THAT(shell("'" + moved + "/bin/mpmvv' list codes 2>&1").out, HasSubstr("small-mpm  1.0"));
  EXPECT_THAT(gate.out, HasSubstr("3 pass, 0 fail, 0 inconclusive"));
}

/// Configures a build for another machine with this CMake toolchain file, and returns what CMake says.
std::string configured_elsewhere(const Folder& folder, const std::string& toolchain) {
  const Answer said =
      shell("cmake -S '" MPMVV_SOURCE_DIR "' --preset release -B '" + (folder / "build") +
            "' -DBUILD_TESTING=OFF --toolchain '" + folder.write("toolchain.cmake", toolchain) + "' 2>&1");
  EXPECT_EQ(said.code, 0) << said.out;
  return said.out;
}

TEST(BuildForAnotherMachine, AsksNoProcessorUnlessAnEmulatorAnswers) {
  const std::string other = "set(CMAKE_SYSTEM_NAME Linux)\n";
  const std::string emulated = other + "set(CMAKE_CROSSCOMPILING_EMULATOR /usr/bin/env)\n";
  const std::string unknown = "this machine cannot ask the other's processor, so -march is left to the compiler";
  const Folder alone, answered;
  EXPECT_THAT(configured_elsewhere(alone, other), HasSubstr(unknown));
  EXPECT_THAT(read_text(alone / "build/build.ninja"), Not(HasSubstr("-march")));
  EXPECT_THAT(read_text(alone / "build/cmake_install.cmake"), Not(HasSubstr("Manual.cmake")));
  EXPECT_THAT(configured_elsewhere(answered, emulated), Not(HasSubstr(unknown)));
  EXPECT_THAT(read_text(answered / "build/cmake_install.cmake"), HasSubstr("/usr/bin/env"));
}

/// Debian 12 as its installer leaves it, in a folder, and the package in it with what it depends on.
class PackageNightly : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<Folder>();
    made = shell("cd '" + build + "' && DEBFULLNAME='A. Tester' DEBEMAIL=tester@example.org cpack -G DEB -B '" +
                 (*folder / "package") + "' 2>&1");
  }
  static void TearDownTestSuite() { folder.reset(); }

  /// Here, as a suite whose beginning fails counts as skipped with CTest.
  void SetUp() override { ASSERT_EQ(made.code, 0) << made.out; }

  static inline std::unique_ptr<Folder> folder;
  static inline Answer made;
};

TEST_F(PackageNightly, NamesTheLibrariesThatItsProgramNeeds) {
  const Answer fields = shell("dpkg-deb --field '" + (*folder / "package") + "'/*.deb");
  for (const char* depends :
       {"libc6", "libstdc++6", "libsqlite3-0", "libfmt9", "libtomlplusplus3", "gnuplot-nox | gnuplot"})
    EXPECT_THAT(fields.out, HasSubstr(depends));
}

TEST_F(PackageNightly, SaysOfWhichCommitItIsByWhomAndForWhichProcessors) {
  const Answer fields = shell("dpkg-deb --field '" + (*folder / "package") + "'/*.deb");
  EXPECT_THAT(fields.out, HasSubstr("Maintainer: A. Tester <tester@example.org>\n"));
  EXPECT_THAT(fields.out, ContainsRegex("Version: 0[.]1[.]0(~git[0-9]{12}[.][0-9a-f]+)?\n"));
  EXPECT_THAT(
      fields.out,
      ContainsRegex("It (needs a processor with (AVX-512|AVX2 and FMA)|runs on every processor of its architecture)"));
}

TEST(ProcessorNightly, WithoutTheInstructionsOfTheBuildGetsALine) {
  const std::string built = read_text(build + "/generated/mpmvv_build_info.hpp");
  if (built.find("-march=x86-64-v3") == std::string::npos) GTEST_SKIP() << "built for every processor";
  const Answer old = shell("qemu-x86_64 -cpu Nehalem '" MPMVV_PROGRAM "' --version 2>&1");
  EXPECT_EQ(old.code, 2);
  EXPECT_THAT(old.out, MatchesRegex("mpmvv: this processor lacks .*AVX2 and FMA[^\n]*\n"));
  const Answer newer = shell("qemu-x86_64 -cpu Haswell '" MPMVV_PROGRAM "' --version 2>&1");
  EXPECT_EQ(newer.code, built.find("-mavx512vl") == std::string::npos ? 0 : 2);
  if (newer.code != 0) {
    EXPECT_THAT(newer.out, HasSubstr("mpmvv: this processor lacks what the program is built for, AVX-512;"));
  }
}

/// What a run found; not what it cost.
nlohmann::json found_by(const std::string& program, const std::string& options) {
  nlohmann::json found = shell("'" + program + "' run --json " + options).json();
  for (const char* time : {"cost", "ns_per_particle_step", "wall_seconds"}) found.erase(time);
  return found;
}

/// Built for Haswell, which knows the same instructions as x86-64-v3, the program has neither the registers in space
/// nor the tuning (cmake/Flags.cmake).
TEST(ProcessorNightly, RegistersInSpaceAndTuningChangeNoBitOfAResult) {
  if (read_text(build + "/generated/mpmvv_build_info.hpp").find("-mtune=") == std::string::npos)
    GTEST_SKIP() << "built without them";
  const Folder folder;
  const std::string plain = folder / "plain";
  const Answer built = shell("cmake -S '" MPMVV_SOURCE_DIR "' --preset release -B '" + plain +
                             "' -DMPMVV_ARCH=haswell -DBUILD_TESTING=OFF >/dev/null && cmake --build '" + plain +
                             "' --target mpmvv 2>&1");
  ASSERT_EQ(built.code, 0) << built.out;
  for (const std::string problem : {"cube", "square"})
    for (const std::string bases : {"linear", "bspline2", "bspline3", "bspline2-open", "gimp", "cpdi", "b2cpdi"})
      for (const std::string scheme :
           {"cd", "rk4", "usl --velocity-update apic", "usl --velocity-update fmpm --order 3"}) {
        if (scheme.ends_with("apic") && (bases == "linear" || bases.ends_with("open") || bases.ends_with("cpdi")))
          continue;
        const std::string options = "--problem " + problem +
                                    " --cells 8 --ppc 2 --cfl 0.4 --boundary symmetry --blowup-error 10 --basis " +
                                    bases + " --integrator " + scheme;
        const auto found = found_by(program(), options);
        EXPECT_EQ(found["steps"], problem == "cube" ? 20 : 40) << options;
        EXPECT_EQ(found, found_by(plain + "/mpmvv", options)) << options;
      }
  for (const std::string options :
       {"--problem impact --deformation exponential --basis cpdi --integrator usl --velocity-update fmpm --order 4 "
        "--cells 3 --ppc 2 --cfl 0.2",
        "--problem ring --quarter --fill conforming --basis cpgimp --integrator cd --cells 8 --ppc 2 --cfl 0.4",
        "--problem shell --quarter --fill conforming --basis bspline3 --integrator usavg+ --cells 6 --ppc 2 --cfl 0.4",
        "--problem vortex --fill conforming --basis bspline3 --integrator cd --cells 16 --ppc 2 --cfl 0.2"})
    EXPECT_EQ(found_by(program(), options), found_by(plain + "/mpmvv", options)) << options;
}

TEST_F(PackageNightly, TakesAFirstStudyToAGateThatPassesOnABareDebian) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can make a system in a folder";
  const std::string bare = *folder / "bare", home = bare + "/root/";
  const Answer debian = shell("mmdebstrap --quiet --variant=apt bookworm '" + bare +
                              "' http://deb.debian.org/debian 2>&1 && "
                              "cp '" +
                              (*folder / "package") + "'/*.deb '" + home + "mpmvv.deb'");
  ASSERT_EQ(debian.code, 0) << debian.out;
  const auto inside = [&](const std::string& command) {
    std::ofstream(home + "command") << "set -e; cd /root\n" << command;
    Answer answer = shell("chroot '" + bare + "' sh /root/command 2>&1");
    EXPECT_EQ(answer.code, 0) << command << "\n" << answer.out;
    return answer.out;
  };
  inside(
      "apt-get -qq update; DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends ./mpmvv.deb");
  std::ofstream(home + "splines.toml") << walk("splines.toml");
  for (const char* step : {"study", "report", "propose", "review"}) inside(walk(step));
  EXPECT_THAT(inside(walk("gate")), HasSubstr("0 fail, 0 inconclusive"));
  EXPECT_TRUE(std::filesystem::exists(home + "report/figures/splines.pdf"));
  EXPECT_THAT(inside("mpmvv study s-jump --db shipped.db && cd / && mpmvv gate --only s-jump --db /root/shipped.db"),
              HasSubstr("3 pass"));
  inside("apt-get -qq remove -y mpmvv");
  EXPECT_FALSE(std::filesystem::exists(bare + "/usr/share/mpmvv"));
}

}  // namespace mpmvv::cli::install_test
