#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <regex>
#include <thread>
#include <vector>

#include "tests/cli/program.hpp"
#include "tests/cli/started.hpp"
#include "tests/studies/codes/mover.hpp"

/// Studies whose code goes wrong, or is stopped.
namespace mpmvv::cli::broken_codes_test {

namespace fs = std::filesystem;
using codes::Mover;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class StudyOfABrokenCode : public testing::Test {
 protected:
  StudyOfABrokenCode() {
    std::ofstream(mover_.top() / "s.toml") << Mover::study;
    mover_.adapter(
        std::string(Mover::text)
            .replace(std::string(Mover::text).find("\"{{end_time}}\""), 14, "\"{{end_time}}\", \"{{cells}}\""));
  }

  Answer in_folder(const std::string& arguments) const {
    return call(folder_, arguments, "cd '" + mover_.top().string() + "' && ");
  }
  pid_t start_study() const { return start({"study", "s.toml", "--db", "r.db", "--jobs", "1"}); }
  pid_t start(std::vector<const char*> arguments) const {
    arguments.insert(arguments.begin(), "mpmvv");
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    signal(SIGINT, SIG_DFL);  // a shell without job control has what it starts in the background ignore it
    fs::current_path(mover_.top());
    freopen("/dev/null", "w", stdout);
    freopen("messages", "w", stderr);
    execv(program().c_str(), const_cast<char* const*>(arguments.data()));
    _exit(127);
  }

  /// Interrupts it when the code has written a file. No folder of a run is left.
  void interrupt(pid_t child, const fs::path& file) const {
    for (int k = 0; k < 2000 && !fs::exists(file); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    kill(child, SIGINT);
    EXPECT_EQ(exit_code_of(child), 130);
    for (const auto& entry : fs::directory_iterator(mover_.top()))
      EXPECT_NE(entry.path().filename().string().substr(0, 10), "mpmvv-run-");
  }

  const Mover mover_;
  const Folder folder_;
};

TEST_F(StudyOfABrokenCode, SaysWhyARunFailed) {
  mover_.script(std::string(Mover::moving) + "[ $2 = 4 ] || { echo no such mesh; exit 3; }\n");
  const Answer answer = in_folder("study s.toml --db r.db");
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.out, AllOf(ContainsRegex("\n +failed +cells +why\n +theirs +8, 16 +[^\n]*mover ended with"),
                                HasSubstr("3 cases run, 0 taken from r.db, 2 failed")));
}

TEST_F(StudyOfABrokenCode, SaysOnceWhySeveralRunsOfASeriesFailed) {
  mover_.script("echo no such mesh; exit 3\n");
  EXPECT_THAT(
      in_folder("study s.toml --db r.db").out,
      AllOf(ContainsRegex("\n +theirs +4, 8, 16 +[^\n]*mover ended with status 3: no such mesh; folder of the first "
                          "one: [^\n]*mpmvv-failed-"),
            Not(ContainsRegex("no such mesh[^\r]*no such mesh"))));
}

/// It goes on to its end, far from where it should be.
TEST_F(StudyOfABrokenCode, SaysWhyItsRunsAreUnstableAndThatTheyMayHaveEnded) {
  mover_.script(std::regex_replace(Mover::moving, std::regex("\\$2 [+] t"), "$2 + 0.9 * t"));
  std::ofstream(mover_.top() / "s.toml") << std::regex_replace(Mover::study, std::regex("cfl = 0.5"),
                                                               "$&\nblowup_error = 1e-6");
  const std::string out = in_folder("study s.toml --db r.db").out;
  EXPECT_THAT(out, AllOf(ContainsRegex("\n +unstable +cells +why\n +theirs +4, 8, 16 +displacement errors 0[.0-9]+, "
                                       "0[.0-9]+, 0[.0-9]+ beyond 2.5e-07\n"),
                         HasSubstr("may have come to its end"), HasSubstr("blowup_error = 10")));
  mover_.script("echo blown up\n");
  EXPECT_THAT(in_folder("study s.toml --db other.db").out,
              AllOf(HasSubstr("the code says: blown up"), Not(HasSubstr("may have come to its end"))));
}

TEST_F(StudyOfABrokenCode, ALimitSearchThatFailsNamesTheRemedy) {
  mover_.script("echo particle outside of domain; exit 3\n");
  std::ofstream(mover_.top() / "s.toml") << R"(title = "Limit"
[fixed]
problem = "translation"
ppc = 2
cells = 4
[[series]]
name = "theirs"
code = "mover"
[limit]
key = "cfl"
from = 0.2
to = 2
)";
  const Answer answer = in_folder("study s.toml --db r.db");
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.err, AllOf(HasSubstr("particle outside of domain"),
                                HasSubstr("put words of it into `unstable` of [command] in its adapter")));
}

TEST_F(StudyOfABrokenCode, TheGateSaysOnceWhatARunSaid) {
  unsetenv("GITHUB_ACTIONS");  // or the gate prints annotations, too
  mover_.script("echo no such mesh; exit 3\n");
  in_folder("study s.toml --db r.db");
  fs::create_directories(mover_.top() / "goldens");
  std::ofstream(mover_.top() / "goldens/s.toml") << R"(study = "s"
reviewed = "now"
[[order]]
series = "theirs"
norm = "l2"
window = [4, 16]
points = 3
expected = 2
lower = 1.85
upper = 2.15
finest = [16, 0.001]
[[error]]
series = "theirs"
norm = "l2"
at = 16
expected = 0.001
band = 0.1
)";
  const Answer gate = in_folder("gate --db r.db --goldens goldens --junit g.xml");
  EXPECT_EQ(gate.code, 1) << gate.err;
  EXPECT_THAT(gate.out,
              AllOf(ContainsRegex("order of 'theirs'[^\n]* in .1.85, 2.15., not measured [(]the runs at 4, 8 and 16 "
                                  "failed; at 16: [^\n]*mover ended with [^\n]*no such mesh"),
                    HasSubstr("± 10 %, not measured (the run at 16 failed: as above)\n"), Not(HasSubstr("nan"))));
  EXPECT_THAT(read_text(mover_.top() / "g.xml"),
              AllOf(ContainsRegex("message=\"the run at 16 failed: [^\n]*mover ended[^\n]*no such mesh"),
                    Not(HasSubstr("nan"))));
  for (const auto& result : in_folder("gate --db r.db --goldens goldens --json").json()["results"]) {
    EXPECT_TRUE(result["measured"].is_null());
    EXPECT_THAT(result["reason"].get<std::string>(), HasSubstr("no such mesh"));
  }
}

/// Where the problem has no body force, none is no mistake.
TEST_F(StudyOfABrokenCode, NoneIsTheRightBodyForceOfTranslation) {
  std::ofstream(mover_.top() / "s.toml") << std::regex_replace(Mover::study, std::regex("code = .mover.\n"),
                                                               "$&force_form = \"none\"\n");
  ASSERT_EQ(in_folder("study s.toml --db r.db").code, 0);
  EXPECT_THAT(in_folder("propose --db r.db --study s").err, Not(HasSubstr("planted")));
}

/// A licence, a library: what was missing may be there the next time, with the same code.
TEST_F(StudyOfABrokenCode, IsTriedAgainWhereARunFailed) {
  const fs::path surroundings = mover_.top() / "surroundings.sh";
  mover_.script(". " + surroundings.string() + "\n" + Mover::moving);
  const auto study_where = [&](const std::string& what_happens) {
    std::ofstream(surroundings) << what_happens;
    return in_folder("study s.toml --db r.db").out;
  };
  EXPECT_THAT(study_where("echo no licence; exit 1"), HasSubstr("no licence"));
  EXPECT_THAT(study_where("echo no library; exit 1"),
              AllOf(HasSubstr("3 cases run, 0 taken from r.db, 3 failed"), HasSubstr("no library")));
  EXPECT_THAT(in_folder("db export --db r.db").out, AllOf(HasSubstr("no library"), Not(HasSubstr("no licence"))));
  EXPECT_THAT(in_folder("study s.toml --db r.db --plan").out, ContainsRegex("\ns +3 +0 +0 +3"));
  EXPECT_THAT(in_folder("study s.toml --db r.db --no-retry").out,
              HasSubstr("0 cases run, 3 taken from r.db, 3 failed"));
  EXPECT_THAT(study_where("[ $2 = 4 ] || echo blown up"), HasSubstr("3 cases run, 0 taken from r.db"));
  EXPECT_THAT(in_folder("study s.toml --db r.db --verbose").out,
              AllOf(ContainsRegex("\n  unstable +cells +why\n"), HasSubstr("the code says: blown up")));
  EXPECT_THAT(study_where(""), HasSubstr("0 cases run, 3 taken from r.db")) << "what is unstable has been carried out";
}

/// Both run what the store does not hold, and both find it sound.
TEST_F(StudyOfABrokenCode, TwoAtOnceShareAStore) {
  const pid_t first = start_study(), second = start_study();
  for (const pid_t each : {first, second}) {
    int status = 0;
    waitpid(each, &status, 0);
    EXPECT_EQ(status, 0) << read_text(mover_.top() / "messages");
  }
  EXPECT_EQ(in_folder("db check --db r.db").code, 0);
  EXPECT_THAT(in_folder("study s.toml --db r.db").out, HasSubstr("0 cases run, 3 taken"));
}

/// A caller that asks for no news of its children: the program still hears of its own.
TEST_F(StudyOfABrokenCode, HearsOfTheEndOfItsRuns) {
  mover_.adapter(std::regex_replace(Mover::text, std::regex("time_limit = 20"), "time_limit = 100"));
  const auto begin = std::chrono::steady_clock::now();
  const Answer answer =
      call(folder_, "study s.toml --db r.db", "cd '" + mover_.top().string() + "' && env --ignore-signal=CHLD ");
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(90)) << "100 is the time limit of a run";
}

TEST_F(StudyOfABrokenCode, ThatIsStoppedLeavesNothingRunning) {
  const fs::path group = mover_.top() / "group", session = mover_.top() / "session";
  mover_.script(std::string(Mover::moving) + "[ $2 = 4 ] && exit 0\n" + Mover::start("", group) +
                Mover::start("setsid", session) + "sleep 60\n");
  const pid_t child = start_study();
  interrupt(child, session);
  for (const fs::path& file : {group, session}) EXPECT_FALSE(Mover::goes_on(file)) << file;
  EXPECT_THAT(read_text(mover_.top() / "messages"), HasSubstr("the same command goes on from there"));
}

/// Before a study begins, too.
TEST_F(StudyOfABrokenCode, ThatIsAskedForItsVersionEndsWithTheProgram) {
  const fs::path number = mover_.top() / "number";
  mover_.adapter(
      std::regex_replace(Mover::text, std::regex("command = .*\n"), "$&version = [\"{{program}}\", \"--version\"]\n"));
  mover_.script(Mover::start("", number) + "sleep 60\n");
  for (const std::vector<const char*>& command : {std::vector{"list", "codes"}, {"study", "s.toml", "--db", "r.db"}}) {
    fs::remove(number);
    interrupt(start(command), number);
    EXPECT_FALSE(Mover::goes_on(number)) << command.front();
    EXPECT_EQ(read_text(mover_.top() / "messages"), "stopped: mpmvv was ended before it had finished\n");
  }
}

TEST_F(StudyOfABrokenCode, ARunThatIsStoppedSaysSoAndLeavesNoFolder) {
  mover_.script("echo > " + (mover_.top() / "begun").string() + "\nsleep 60\n");
  const pid_t child = start({"run", "--code", "mover", "--variant", "plain", "--problem", "translation", "--cells", "4",
                             "--ppc", "2", "--cfl", "0.5"});
  interrupt(child, mover_.top() / "begun");
  EXPECT_EQ(read_text(mover_.top() / "messages"), "stopped: mover was ended before it had finished\n");
}

}  // namespace mpmvv::cli::broken_codes_test
