#include <gmock/gmock.h>
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "studies/codes/external_run.hpp"
#include "studies/support/error.hpp"
#include "tests/studies/codes/mover.hpp"

/// Codes that go wrong in all the ways that programs do.
namespace mpmvv::codes::broken_codes_test {

namespace fs = std::filesystem;
using records::Failure;
using records::Record;
using records::Status;
using testing::HasSubstr;
using testing::Not;
using namespace std::chrono_literals;

class BrokenCode : public testing::Test {
 protected:
  /// Of a code that does this after it has written all as it should.
  Record run(const std::string& afterwards) const {
    mover_.script(Mover::moving + afterwards + "\n");
    return run_external(settings::make_case(Mover::settings()), mover_.code());
  }
  void limit(const std::string& seconds) const {
    std::string text = Mover::text;
    mover_.adapter(text.replace(text.find("= 20"), 4, "= " + seconds));
  }

  const Mover mover_;
};

/// What it does, and what is said of that.
struct Ending {
  std::string name, script;
  Status status;
  Failure failure;
  std::string reason;
};

class BrokenOutput : public BrokenCode, public testing::WithParamInterface<Ending> {};

TEST_P(BrokenOutput, IsSaidInOneSentenceAndGivesNoNumber) {
  const auto& [name, script, status, failure, reason] = GetParam();
  const Record record = run(script);
  EXPECT_EQ(record.status, status);
  EXPECT_EQ(record.failure, failure);
  EXPECT_THAT(record.reason, HasSubstr(reason));
  EXPECT_THAT(record.reason, Not(HasSubstr("mpmvv-run-"))) << "that folder is no more";
  EXPECT_TRUE(std::isnan(record.error.l2));
}

constexpr auto unstable = Status::unstable, failed = Status::failed;
constexpr auto of_case = Failure::of_case, of_machine = Failure::of_machine, none = Failure::none;

INSTANTIATE_TEST_SUITE_P(
    , BrokenOutput,
    testing::Values(
        Ending{"Nan", "sed -i '5s/,[^,]*,/,nan,/' particles.csv", unstable, none,
               "1 of 64 particles with a position that is no number in particles.csv (the first: particle 4)"},
        Ending{"Infinity", "sed -i '5s/,[^,]*,/,-inf,/' particles.csv", unstable, none, "a position that is no number"},
        Ending{"MassNan", "sed -i '5s/,[^,]*$/,nan/' particles.csv", failed, of_case,
               "particle 4 in particles.csv has mass nan kg (a positive one)"},
        Ending{"MassTwice",
               "awk -F, 'NR > 1 { $4 *= 2 } { print $1\",\"$2\",\"$3\",\"$4 }' particles.csv > q; mv q particles.csv",
               failed, of_case, "mass 2 kg in particles.csv, 2 times that of the case"},
        Ending{"ParticleMissing", "sed -i 5d particles.csv", failed, of_case,
               "1 of 64 particles are missing in particles.csv (of the case 4)"},
        Ending{"ParticleTwice", "sed -i 5p particles.csv", failed, of_case, "particle 4 stands twice in particles.csv"},
        Ending{"OtherTime",
               "awk -v t=\"$1\" 'BEGIN { print \"id,x,y\" } { print $1\",\"$2+t/2*$4\",\"$3+t/2*$5 }' input.txt > "
               "particles.csv",
               failed, of_case, "another time in particles.csv? It is"},
        Ending{"LineCut", "head -c 1000 particles.csv > q; mv q particles.csv", failed, of_case,
               "numbers in particles.csv:"},
        Ending{"NothingInIt", ": > particles.csv", failed, of_case, "no lines of numbers in particles.csv"},
        Ending{"NoFile", "rm particles.csv; echo no licence", failed, of_case,
               "the code wrote no file 'particles.csv'; the code ended without an error: no licence"},
        Ending{"AFolder", "rm particles.csv; mkdir particles.csv", failed, of_case,
               "cannot read 'particles.csv': a dir"},
        Ending{"NoText", "head -c 5000 /dev/zero > particles.csv", failed, of_case, "particles.csv"},
        Ending{"Status", "echo no such mesh; exit 3", failed, of_case, "mover ended with status 3: no such mesh"},
        Ending{"ItsOwnSignal", "kill -SEGV $$", failed, of_case, "was ended by signal 11 (Segmentation fault): it"},
        Ending{"ASignalFromOutside", "kill -KILL $$", failed, of_machine, "was ended by signal 9 (Killed)"}),
    [](const auto& tested) { return tested.param.name; });

TEST_F(BrokenCode, IsKilledAtTheTimeLimitWithAllThatItStarted) {
  limit("1.5");
  const std::string place = (mover_.top() / "process-").string();
  const auto start = std::chrono::steady_clock::now();
  const Record record = run("trap '' TERM INT\n" + Mover::start("", place + "1") + Mover::start("setsid", place + "2") +
                            "sleep 60; sleep 60");
  EXPECT_LT(std::chrono::steady_clock::now() - start, 10s);
  EXPECT_EQ(record.status, Status::failed);
  EXPECT_EQ(record.failure, Failure::of_machine) << "another time the machine may be less busy";
  EXPECT_THAT(record.reason, HasSubstr("was killed at the time limit of 1.5 s (time_limit of its adapter)"));
  for (const char* number : {"1", "2"}) {
    EXPECT_TRUE(fs::exists(place + number)) << "not started within the limit";
    EXPECT_FALSE(Mover::goes_on(place + number)) << number;
  }
}

/// Neither those that hold its output open nor those that have left its group.
TEST_F(BrokenCode, LeavesNothingRunning) {
  const std::string place = (mover_.top() / "process-").string();
  std::string script;
  for (const char* how : {"", "setsid", "setsid -w"})
    script += Mover::start(how, place + std::to_string(script.size()));
  const auto begin = std::chrono::steady_clock::now();
  const Record record = run(script);
  EXPECT_EQ(record.status, Status::ok) << record.reason;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 15s) << "they are not waited for";
  int started = 0;
  for (const auto& entry : fs::directory_iterator(mover_.top())) {
    if (!entry.path().string().starts_with(place)) continue;
    ++started;
    EXPECT_FALSE(Mover::goes_on(entry.path())) << entry.path();
  }
  EXPECT_EQ(started, 3);
}

TEST_F(BrokenCode, MayWriteMoreThanAMemoryHolds) {
  const fs::path kept = mover_.top() / "kept";
  mover_.script(std::string(Mover::moving) + "echo first; yes step | head -c 40000000; echo blown up; exit 1");
  const Record record = run_external(settings::make_case(Mover::settings()), mover_.code(), kept);
  EXPECT_EQ(record.status, Status::unstable) << record.reason;
  EXPECT_LT(fs::file_size(kept / "log.txt"), 17U << 20);
}

/// A limit in bytes on the size of files, beyond which a write fails; what was before comes back.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t most) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit little{most, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &little);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

/// A disk that takes no more.
TEST_F(BrokenCode, MayDoBetterWithMoreRoom) {
  const Code code = mover_.code();
  const Record record = [&] {
    const FileSizeLimit full(100);
    return run_external(settings::make_case(Mover::settings()), code);
  }();
  EXPECT_EQ(record.status, Status::failed);
  EXPECT_EQ(record.failure, Failure::of_machine);
  EXPECT_THAT(record.reason, HasSubstr("cannot write input.txt (File too large)"));
}

TEST_F(BrokenCode, MayLoseItsFolder) {
  const Record record = run("rm -r \"$PWD\"");
  EXPECT_EQ(record.status, Status::failed);
  EXPECT_EQ(record.failure, Failure::of_machine);
  EXPECT_THAT(record.reason, HasSubstr("cannot write log.txt (No such file or directory)"));
}

TEST_F(BrokenCode, NeedsAFolderThatIsThere) {
  const Code code = mover_.code();
  setenv("TMPDIR", "/no/folder", 1);
  try {
    run_external(settings::make_case(Mover::settings()), code);
    FAIL();
  } catch (const support::UsageError& e) {
    EXPECT_STREQ(e.what(), "TMPDIR is '/no/folder', which is no folder (one that is there and can be written)");
  }
}

/// Runs that begin while others end.
TEST_F(BrokenCode, DoesNotDisturbOthersThatRunBesideIt) {
  const Code code = mover_.code();
  const cases::Case c = settings::make_case(Mover::settings());
  std::vector<std::jthread> threads;
  std::atomic<int> ok = 0;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&] {
      for (int n = 0; n < 10; ++n) ok += run_external(c, code).status == Status::ok ? 1 : 0;
    });
  threads.clear();
  EXPECT_EQ(ok, 40);
}

}  // namespace mpmvv::codes::broken_codes_test
