#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <thread>
#include <vector>

#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::interruption_test {

using testing::HasSubstr;
using testing::StartsWith;

/// The signals that are sent, one after the other.
class Interrupted : public testing::TestWithParam<std::vector<int>> {
 protected:
  /// Starts a study of many short cases and a few long ones, its messages in a file.
  pid_t start() {
    const pid_t child = fork();
    if (child != 0) return child;
    signal(SIGINT, SIG_DFL);  // a shell without job control has what it starts in the background ignore it
    signal(SIGHUP, SIG_DFL);  // as does nohup
    freopen("/dev/null", "w", stdout);
    freopen((folder_ / "messages").c_str(), "w", stderr);
    execl(program().c_str(), "mpmvv", "study", file_.c_str(), "--jobs", "8", "--db", db_.c_str(), nullptr);
    _exit(127);
  }

  std::ptrdiff_t finished() {
    const Answer exported = call(folder_, "db export --db " + db_);
    return exported.code == 0 ? std::count(exported.out.begin(), exported.out.end(), '\n') - 1 : 0;
  }

  static std::string long_study() {
    std::string text = small_study;
    return text.replace(text.find("[8, 16, 32, 64]"), 15, "[8, 16, 32, 64, 2048, 2560]");
  }

  Folder folder_;
  std::string file_ = folder_.write("long.toml", long_study()), db_ = folder_ / "r.db";
};

TEST_P(Interrupted, AStudyKeepsWhatHasFinishedAndSaysHowToGoOn) {
  const pid_t child = start();
  for (int k = 0; k < 1000 && finished() < 3; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  for (const int signal : GetParam()) {
    kill(child, signal);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const std::string kept = std::to_string(finished()) + " cases finished and kept in " + db_;
  const std::string messages = read_text(folder_ / "messages");
  EXPECT_THAT(messages, StartsWith("stopped: " + kept));
  EXPECT_THAT(messages, HasSubstr("the same command goes on from there\n"));
  EXPECT_EQ(std::count(messages.begin(), messages.end(), '\n'), 1) << messages;
  EXPECT_EQ(call(folder_, "db check --db " + db_).code, 0);
}

/// As a study does: by the exit code of an interrupt, where the signal itself would give another one.
TEST(Interruption, ARunSaysThatItIsNoWholeOne) {
  const Folder folder;
  const std::string states = folder / "states", messages = folder / "messages";
  const pid_t child = fork();
  if (child == 0) {
    freopen((folder / "out").c_str(), "w", stdout);
    freopen(messages.c_str(), "w", stderr);
    execl(program().c_str(), "mpmvv", "run", "--problem", "bar", "--cells", "4096", "--ppc", "4", "--cfl", "0.01",
          "--vtu", states.c_str(), nullptr);
    _exit(127);
  }
  const auto has_begun = [&] { return std::filesystem::exists(states) && !std::filesystem::is_empty(states); };
  for (int k = 0; k < 3000 && !has_begun(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  kill(child, SIGTERM);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(read_text(messages),
            "stopped: the run of bar was ended before it had finished; what it had written is in " + states + "\n");
  EXPECT_EQ(read_text(folder / "out"), "");
}

using Signals = std::vector<int>;

/// SIGUSR1 alone, which a cluster may send, changes nothing.
INSTANTIATE_TEST_SUITE_P(, Interrupted,
                         testing::Values(Signals{SIGINT}, Signals{SIGTERM}, Signals{SIGHUP},
                                         Signals{SIGUSR1, SIGUSR1, SIGTERM}));

}  // namespace mpmvv::cli::interruption_test
