#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"

namespace mpmvv::cli::faults_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* two_runs = R"(title = "Two runs"
[fixed]
problem = "bar"
integrator = "cd"
boundary = "periodic"
ppc = 2
cfl = 0.3
[[series]]
name = "linear"
basis = "linear"
[sweep]
cells = [8, 16]
)";

constexpr const char* three_limits = R"(title = "Three limits"
[fixed]
problem = "bar"
integrator = "cd"
boundary = "periodic"
ppc = 2
cells = 8
[[series]]
name = "linear"
basis = "linear"
[[series]]
name = "bspline2"
basis = "bspline2"
[[series]]
name = "gimp"
basis = "gimp"
[limit]
key = "cfl"
from = 0.5
to = 2
)";

constexpr const char* a_run =
    "run --problem bar --basis bspline2 --integrator cd --boundary periodic --cells 8 --ppc 2 --cfl 0.2";

/// What only libraries, systems and debuggers say.
constexpr const char* foreign_words[] = {"std::",
                                         "what()",
                                         "json.exception",
                                         "filesystem error",
                                         "::at",
                                         "vector::",
                                         "basic_string",
                                         "terminate",
                                         "bad_",
                                         "boost",
                                         "sqlite",
                                         "SQLITE",
                                         "TOML_",
                                         "CLI::",
                                         "stoi",
                                         "stod",
                                         "iostream",
                                         "locale",
                                         "regex",
                                         "dumped",
                                         "__",
                                         "libc",
                                         "mistake in mpmvv"};

/// A store with a study, the study's file, and goldens, made once.
class Faults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<Folder>();
    fs::create_directories(*folder / "goldens");
    folder->write("two.toml", two_runs);
    folder->write("limits.toml", three_limits);
    folder->write(
        "goldens/two.toml",
        "study = \"two\"\n[[order]]\nseries = \"linear\"\nnorm = \"l2\"\nexpected = 1\nlower = 0.85\nupper = 1.15\n");
    ASSERT_EQ(call(*folder, "study " + (*folder / "two.toml") + " --db " + (*folder / "r.db")).code, 0);
  }
  static void TearDownTestSuite() { folder.reset(); }

  /// The program in the folder, given up after a while; the answer is what comes out beside the redirections.
  static Answer in_folder(const std::string& arguments, const std::string& before, const std::string& redirections) {
    return shell("cd '" + (*folder / "") + "' && " + before + " timeout 20 '" + program() + "' " + arguments + " " +
                 redirections);
  }

  static void expect_our_words(const std::string& text, const std::string& what) {
    for (const char* word : foreign_words) EXPECT_EQ(text.find(word), std::string::npos) << what << ": " << text;
    for (const char c : text) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= ' ') << what << ": " << text;
  }

  static inline std::unique_ptr<Folder> folder;
};

/// Something of every command, quick, with the exit code where nothing is wrong.
struct Call {
  const char* arguments;
  int code;
};

constexpr Call calls[] = {{a_run, 0},
                          {"solution --problem bar --at 0.2 --time 0.001", 0},
                          {"study two.toml --db r.db", 0},
                          {"gate --db r.db --goldens goldens", 3},
                          {"propose --db r.db --study absent", 2},
                          {"report --db absent.db --out report", 2},
                          {"compare absent --db r.db", 2},
                          {"trend --db r.db", 0},
                          {"cost absent", 2},
                          {"claims --db r.db", 0},
                          {"list --json", 0},
                          {"db info --db r.db", 0},
                          {"db check --db r.db", 0},
                          {"db update --db r.db", 0},
                          {"db merge r.db --db merged.db", 0},
                          {"db export --db r.db", 0},
                          {"--version", 0},
                          {"run --help", 0}};

TEST_F(Faults, AClosedOrFullStreamIsSurvived) {
  for (const Call& c : calls) {
    const bool silent = c.code == 2;
    const int unwritten = 2;
    EXPECT_EQ(in_folder(c.arguments, "", "2>&-").code, c.code) << c.arguments;
    EXPECT_EQ(in_folder(c.arguments, "", "2>/dev/full").code, c.code) << c.arguments;
    for (const char* lost : {"2>&1 >/dev/full", "2>&1 >&-"}) {
      const Answer answer = in_folder(c.arguments, "", lost);
      EXPECT_EQ(answer.code, unwritten) << c.arguments << lost;
      if (!silent) {
        EXPECT_THAT(answer.out, StartsWith("mpmvv: cannot write to standard output")) << c.arguments;
      }
      expect_our_words(answer.out, c.arguments);
    }
  }
}

/// The store's number is not that of a closed stream: messages would go there.
TEST_F(Faults, NoFileTakesTheNumberOfAClosedStream) {
  EXPECT_EQ(in_folder("study two.toml --db closed.db --set shuffle=1", "", "<&- >&- 2>&-").code, 2);
  EXPECT_EQ(in_folder("db check --db closed.db", "", "2>&1").out, "closed.db is sound\n");
}

TEST_F(Faults, WhatTheSystemRefusesIsSaidInOurWords) {
  struct Refusal {
    const char* before;
    const char* arguments;
    const char* message;
  };
  const Refusal refusals[] = {
      {"ulimit -f 0;", "study two.toml --db new.db", "new.db"},
      {"ulimit -f 0;", "db merge r.db --db new.db", "new.db"},
      {"ulimit -f 0;", "db export --db r.db --out new.csv", "cannot write new.csv"},
      {"ulimit -f 0;", "gate --db r.db --goldens goldens --junit new.xml", "cannot write new.xml"},
      {"ulimit -f 0;", "report --db r.db --out new", "new"}};
  for (const Refusal& r : refusals) {
    const Answer answer = in_folder(r.arguments, r.before, "2>&1");
    EXPECT_EQ(answer.code, 2) << r.arguments;
    EXPECT_THAT(answer.out, HasSubstr(r.message)) << r.before << r.arguments;
    expect_our_words(answer.out, r.arguments);
  }
}

/// Several threads wait for what the store does not take.
TEST_F(Faults, AFullDiskEndsASearchForLimits) {
  const auto blocks = fs::file_size(*folder / "r.db") / 512 + 1;
  fs::copy_file(*folder / "r.db", *folder / "full.db");
  const Answer answer =
      in_folder("study limits.toml --db full.db --jobs 4", "ulimit -f " + std::to_string(blocks) + ";", "2>&1");
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.out, HasSubstr("full.db"));
  expect_our_words(answer.out, "limits");
}

/// Address space for part of the threads or for part of the particles.
TEST_F(Faults, LittleMemoryEndsInAMessageOrInFewerThreads) {
  for (const char* limit : {"60000", "90000", "150000"}) {
    const std::string before = std::string("ulimit -v ") + limit + ";";
    const Answer threads = in_folder(std::string(a_run) + " --threads 16", before, "2>&1");
    EXPECT_EQ(threads.code, 0) << limit << threads.out;
    EXPECT_THAT(threads.out, HasSubstr("status ok"));
    EXPECT_EQ(in_folder("study two.toml --db few.db --jobs 16", before, "2>&1").code, 0) << limit;
    const Answer particles = in_folder(
        "run --problem cube --basis linear --integrator usl --boundary periodic --cells 128 --ppc 4 --cfl 0.2", before,
        "2>&1");
    EXPECT_EQ(particles.code, 1) << limit << particles.out;
    EXPECT_THAT(particles.out, testing::AllOf(HasSubstr("failed (not enough memory"), testing::Not(HasSubstr("nan"))));
  }
}

/// Every option that takes a file or a folder, with P for it.
constexpr const char* options_with_paths[] = {
    "study P --db r.db",
    "study two.toml --db P",
    "gate --goldens goldens --db P",
    "gate --db r.db --goldens P",
    "gate --db r.db --goldens goldens --junit P",
    "propose --study two --db P",
    "propose --study two --db r.db --goldens P",
    "report --db P --out P",
    "compare a --db P",
    "trend --db P",
    "cost P",
    "cost /bin/true --cases P",
    "claims --db P",
    "db info --json --db P",
    "db check --db P",
    "db update --db P",
    "db merge P --db r.db",
    "db merge r.db --db P",
    "db export --db r.db --out P",
};

TEST_F(Faults, APathOfAnyKindIsTakenOrRefusedInOneLine) {
  folder->write("file", "x\n");
  fs::create_directories(*folder / "empty");
  ASSERT_EQ(shell("mkfifo '" + (*folder / "pipe") + "'").code, 0);
  constexpr const char* stores[] = {"\xff\xfe", "a\033]0;\nb"};
  std::vector<std::string> paths{"absent/x", "empty",     "file", "file/x",
                                 "pipe",     "/dev/full", "''",   std::string(300, 'x')};
  for (const char* name : stores) paths.push_back("'" + std::string(name) + "'");
  for (const std::string option : options_with_paths)
    for (const std::string& path : paths) {
      std::string arguments = option;
      for (std::size_t at; (at = arguments.find(" P")) != std::string::npos;) arguments.replace(at, 2, " " + path);
      for (const char* name : stores)
        fs::copy_file(*folder / "r.db", *folder / name, fs::copy_options::overwrite_existing);
      const Answer answer = in_folder(arguments, "", "2>&1 >/dev/null");
      EXPECT_TRUE(answer.code >= 0 && answer.code <= 3) << arguments << " " << answer.code;
      if (answer.code == 2) {
        EXPECT_EQ(std::count(answer.out.begin(), answer.out.end(), '\n'), 1) << answer.out;
      }
      expect_our_words(answer.out, arguments);
    }
}

TEST_F(Faults, ATextOfAUserDoesNotDriveTheTerminal) {
  std::string text = two_runs;
  text.replace(text.find("Two runs"), 8, "Two\\u001B[2J\\n::error::runs\\u009B\\u202E");
  folder->write("hostile.toml", text);
  const std::string db = "'hostile\033[2J\n::error::.db'";
  const Answer answer = in_folder("study hostile.toml --db " + db, "", "2>&1");
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.out, StartsWith("hostile: Two\\x1b[2J\\n::error::runs\\xc2\\x9b\\xe2\\x80\\xae\n"));
  expect_our_words(answer.out, "study");
  EXPECT_THAT(in_folder("db check --db " + db, "", "2>&1").out, HasSubstr("\\n::error::.db is sound"));
}

TEST_F(Faults, AStudyIsReadOnceFromAFile) {
  const std::string piped = "cat two.toml | ";
  const Answer answer = in_folder("study /dev/stdin --db piped.db", piped, "2>&1");
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.out, HasSubstr("cannot read '/dev/stdin': a pipe or a device"));
  EXPECT_FALSE(fs::exists(*folder / "piped.db"));
}

TEST_F(Faults, AFlagTakesTrueAndFalseAlone) {
  const std::string run = std::string(a_run) + " --json ";
  const auto nodal_error = [&](const std::string& flag) {
    const Answer answer = call(*folder, run + flag);
    EXPECT_EQ(answer.code, 0) << flag << answer.err;
    return !answer.json()["error"]["nodal_l2"].is_null();
  };
  EXPECT_TRUE(nodal_error("--nodal-error"));
  EXPECT_TRUE(nodal_error("--nodal-error=true"));
  EXPECT_FALSE(nodal_error("--nodal-error=false"));
  EXPECT_THAT(call(*folder, std::string(a_run) + " --json=false").out, StartsWith("bar "));
  for (const std::string& arguments :
       {run + "--nodal-error=banana", run + "--every-step=1", std::string("list --json=5"),
        std::string("list --json=banana"), std::string("--version=banana")}) {
    const Answer answer = call(*folder, arguments);
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_THAT(answer.err, HasSubstr("(true or false)")) << arguments;
  }
}

/// Root has no such limit.
TEST(Limits, WithoutAThreadToSpareACommandThatNeedsNoneWorks) {
  const std::string as_nobody = geteuid() == 0 ? "setpriv --reuid=65534 --clear-groups " : "";
  const auto version = [&](const std::string& limit) {
    return shell(as_nobody + "bash -c '" + limit + " exec \"" + program() + "\" --version' 2>&1");
  };
  const Answer usual = version("");
  if (usual.code != 0) GTEST_SKIP() << "nobody may call the program: " << usual.out;
  const Answer limited = version("ulimit -u 1;");
  EXPECT_EQ(limited.code, 0);
  EXPECT_EQ(limited.out, usual.out);
}

}  // namespace mpmvv::cli::faults_test
