#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include "cli/submit_text.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"
#include "tests/cli/started.hpp"
#include "tests/studies/codes/mover.hpp"

/// What is said where a cluster does not queue what it should.
namespace mpmvv::cli::sbatch_test {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// An sbatch that does as it is told.
class Sbatch : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_ / "bin");
    setenv("PATH", ((folder_ / "bin") + ":" + path_).c_str(), 1);
  }
  void TearDown() override { setenv("PATH", path_.c_str(), 1); }

  void sbatch(const std::string& body) const {
    const std::string file = folder_.write("bin/sbatch", "#!/bin/sh\n" + body + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  std::vector<std::string> arguments() const {
    return {"submit", folder_ / "splines.toml", "--engine", "slurm", "--shards", "2", "--db", folder_ / "r.db"};
  }
  Answer submit() const {
    std::string line;
    for (const std::string& word : arguments()) line += word + " ";
    return call(folder_, line);
  }

  Folder folder_;
  std::string study_ = folder_.write("splines.toml", small_study), path_ = std::getenv("PATH");
};

TEST_F(Sbatch, SaysWhichArrayIsLeftWithoutItsMerge) {
  sbatch("case \"$*\" in *--dependency*) echo 'sbatch: error: QOS limit' >&2; exit 1;; esac; echo 12");
  const Answer answer = submit();
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, AllOf(HasSubstr("submit.sh' ended with 1: shards 1-2: job 12; sbatch: error: QOS limit; "),
                                HasSubstr("job 12 is queued without its merge (before the next try: scancel 12)")));
  EXPECT_THAT(answer.out, Not(HasSubstr("job 12")));
}

TEST_F(Sbatch, IsBelievedWhereItAnswersWithANumberAlone) {
  for (const char* odd :
       {"true", "echo Submitted batch job 12", "echo '12 13'", "echo '12; 13'", "echo 12x", "echo ';'"}) {
    sbatch(odd);
    const Answer answer = submit();
    EXPECT_EQ(answer.code, 2) << odd;
    EXPECT_THAT(answer.err, HasSubstr("error: sbatch --parsable answers '")) << odd;
    EXPECT_THAT(answer.err, Not(HasSubstr("without its merge"))) << odd;
  }
  EXPECT_THAT(submit().err, HasSubstr("answers ';' (a job's number; squeue --me lists what is queued)"));
  for (const char* number : {"echo 12", "echo '12;here'", "echo 'sbatch: warning: slow' >&2; echo 12"}) {
    sbatch(number);
    const Answer answer = submit();
    EXPECT_EQ(answer.code, 0) << answer.err;
    EXPECT_THAT(answer.out, AllOf(HasSubstr("\nshards 1-2: job 12\n"), HasSubstr("\nmerge, gate and report: job 12, ")))
        << number;
  }
}

TEST_F(Sbatch, ErrorsAreToldBehindWarnings) {
  sbatch("echo 'sbatch: warning: slow' >&2; echo 'sbatch: error: no such partition' >&2; exit 1");
  EXPECT_THAT(submit().err, HasSubstr("ended with 1: sbatch: warning: slow; sbatch: error: no such partition (--dry"));
}

TEST_F(Sbatch, IsEndedWithTheProgram) {
  const std::string number = folder_ / "number";
  sbatch("case \"$*\" in *--dependency*) echo $$ > " + number + "; exec sleep 60;; esac; echo 12");
  const pid_t child = start_in(folder_, arguments());
  wait_for([&] { return !read_text(number).empty(); });
  kill(child, SIGINT);
  EXPECT_EQ(exit_code_of(child), 130);
  EXPECT_FALSE(codes::Mover::goes_on(number));
  EXPECT_THAT(
      read_text(folder_ / "messages"),
      AllOf(StartsWith("stopped: '"), HasSubstr("submit.sh' was ended before it had finished: shards 1-2: job 12 "),
            EndsWith("(squeue --me lists what is queued, scancel JOB takes it back)\n")));
}

TEST(SubmitFault, SaysWhyAScriptDidNotStartOrEnd) {
  using std::chrono::minutes;
  support::ProcessEnd no_start, no_answer;
  no_start.start_error = EACCES;
  EXPECT_EQ(submit_fault("/a/submit.sh", no_start, minutes(5), "squeue"),
            "'/a/submit.sh' could not be started: Permission denied (a --folder from which programs can be started)");
  no_answer.timed_out = true;
  no_answer.exit_code = 137;
  no_answer.output = "\n";
  EXPECT_EQ(submit_fault("/a/submit.sh", no_answer, minutes(5), "squeue"),
            "'/a/submit.sh' gave no answer for 5 minutes and was ended: it printed nothing (squeue)");
}

TEST(SubmitFault, HasTheLastLinesThatAreNotEmpty) {
  support::ProcessEnd end;
  end.exit_code = 1;
  for (int k = 1; k < 9; ++k) end.output += std::to_string(k) + "\n\n";
  EXPECT_THAT(submit_fault("submit.sh", end, std::chrono::minutes(5), ""), HasSubstr("ended with 1: 4; 5; 6; 7; 8 ("));
}

}  // namespace mpmvv::cli::sbatch_test
