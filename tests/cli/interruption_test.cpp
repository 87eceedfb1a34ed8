#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <thread>
#include <vector>

#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"
#include "tests/cli/started.hpp"
#include "tests/studies/codes/mover.hpp"

namespace mpmvv::cli::interruption_test {

using testing::HasSubstr;
using testing::StartsWith;

/// The signals that are sent, one after the other.
class Interrupted : public testing::TestWithParam<std::vector<int>> {
 protected:
  std::ptrdiff_t finished() {
    const Answer exported = call(folder_, "db export --db " + db_);
    return exported.code == 0 ? std::count(exported.out.begin(), exported.out.end(), '\n') - 1 : 0;
  }

  /// Short cases, and beside them some with so many steps that they outlast the test on any machine. Each is small and
  /// takes one thread.
  static std::string long_study() {
    std::string text = small_study;
    return text.insert(text.find("[sweep]"), "[[series]]\nname = \"slow\"\nbasis = \"linear\"\ncfl = 1e-7\n");
  }

  Folder folder_;
  std::string file_ = folder_.write("long.toml", long_study()), db_ = folder_ / "r.db";
};

TEST_P(Interrupted, AStudyKeepsWhatHasFinishedAndSaysHowToGoOn) {
  const pid_t child = start_in(folder_, {"study", file_, "--jobs", "8", "--db", db_});
  wait_for([&] { return finished() >= 3; });
  for (const int signal : GetParam()) {
    kill(child, signal);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_EQ(exit_code_of(child), 130);
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
  const std::string states = folder / "states";
  const pid_t child =
      start_in(folder, {"run", "--problem", "bar", "--cells", "4096", "--ppc", "4", "--cfl", "0.01", "--vtu", states});
  wait_for([&] { return std::filesystem::exists(states) && !std::filesystem::is_empty(states); });
  kill(child, SIGTERM);
  EXPECT_EQ(exit_code_of(child), 130);
  EXPECT_EQ(read_text(folder / "messages"),
            "stopped: the run of bar was ended before it had finished; what it had written is in " + states + "\n");
  EXPECT_EQ(read_text(folder / "out"), "");
}

TEST(Interruption, FromTheKeyboardEndsALoopOfTheShellToo) {
  const Folder folder;
  const std::string pid = folder / "pid", again = folder / "again";
  const std::string run = "'" + program() + "' run --problem bar --cells 4096 --ppc 4 --cfl 0.001";
  const std::string script = folder.write("loop", "for k in 1 2; do\n  [ $k = 2 ] && echo $k > '" + again +
                                                      "'\n  echo $$ > '" + pid + "'\n  " + run + "\ndone\n");
  const pid_t group = fork();
  if (group == 0) {
    setpgid(0, 0);
    signal(SIGINT, SIG_DFL);
    freopen("/dev/null", "w", stdout);
    freopen("/dev/null", "w", stderr);
    execlp("bash", "bash", script.c_str(), nullptr);
    _exit(127);
  }
  wait_for([&] { return !read_text(pid).empty(); });
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  kill(-group, SIGINT);
  EXPECT_EQ(exit_code_of(group), 130);
  EXPECT_FALSE(std::filesystem::exists(again));
}

/// Its messages go into a pipe that is full, and that nobody reads.
TEST(Interruption, IsNotHeldUpByWhoDoesNotRead) {
  const Folder folder;
  const std::string other = folder.write("other", "#!/bin/sh\nexec sleep 60\n"), pid = folder / "pid";
  std::filesystem::permissions(other, std::filesystem::perms::owner_all);
  const std::string cases = folder.write("cases.txt", "--problem bar --cells 8 --ppc 1 --cfl 0.2 --steps 4\n");
  const std::string script =
      folder.write("script", "head -c 65536 /dev/zero >&2\n'" + program() + "' cost '" + other + "' --cases '" + cases +
                                 "' &\necho $! > '" + pid + "'\nwait $!\necho $? > '" + (folder / "code") + "'\n");
  const std::jthread pipe([&] { shell("sh '" + script + "' 2>&1 >/dev/null | sleep 2"); });
  wait_for([&] { return !read_text(pid).empty(); });
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  kill(std::stoi(read_text(pid)), SIGTERM);
  for (int k = 0; k < 200 && read_text(folder / "code").empty(); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(read_text(folder / "code"), "130\n");
}

/// The other build has a process group of its own, so that the terminal sends it no signal.
TEST(Interruption, OfAnyCommandEndsWhatItHasStarted) {
  const Folder folder;
  const std::string number = folder / "number";
  const std::string other = folder.write(
      "other", "#!/bin/sh\n[ $1 = --version ] && echo mpmvv c0ffee && exit\necho $$ > " + number + "\nexec sleep 60\n");
  std::filesystem::permissions(other, std::filesystem::perms::owner_all);
  const std::string cases = folder.write("cases.txt", "--problem bar --cells 8 --ppc 1 --cfl 0.2 --steps 4\n");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::filesystem::remove(number);
    const pid_t child = start_in(folder, {"cost", other, "--cases", cases});
    wait_for([&] { return !read_text(number).empty(); });
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(WIFSIGNALED(status), signal == SIGINT) << "else a shell would go on with the loop around the command";
    EXPECT_EQ(WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), 130);
    EXPECT_FALSE(codes::Mover::goes_on(number)) << signal;
    EXPECT_EQ(read_text(folder / "messages"), "stopped: mpmvv was ended before it had finished\n");
    EXPECT_EQ(read_text(folder / "out"), "");
  }
}

using Signals = std::vector<int>;

/// SIGUSR1 alone, which a cluster may send, changes nothing.
INSTANTIATE_TEST_SUITE_P(, Interrupted,
                         testing::Values(Signals{SIGINT}, Signals{SIGTERM}, Signals{SIGHUP},
                                         Signals{SIGUSR1, SIGUSR1, SIGTERM}));

}  // namespace mpmvv::cli::interruption_test
