#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tests/cli/program.hpp"

namespace mpmvv::cli::slurm_test {

using testing::AllOf;
using testing::HasSubstr;

/// About a second a case.
constexpr const char* study = R"(title = "Squares"
claims = []
[fixed]
problem = "square"
boundary = "symmetry"
basis = "cpgimp"
integrator = "cd"
ppc = 2
cfl = 0.4
blowup_error = 10
[[series]]
name = "squares"
[sweep]
cells = [16, 32, 56, 58, 60, 62, 64, 66, 68, 70, 72, 74, 76, 78]
[[fit]]
norm = "l2"
window = [16, 64]
)";

/// Slurm on this machine, of the packages slurm-wlm and munge.
class SlurmNightly : public testing::Test {
 protected:
  void SetUp() override {
    if (geteuid() != 0) GTEST_SKIP() << "only root starts a cluster";
    if (shell("command -v slurmctld slurmd munged").code != 0) GTEST_SKIP() << "no Slurm (slurm-wlm, munge)";
    const Answer started = shell(cluster_ + "start '" + cluster_folder_ + "' 2>&1");
    is_there_ = true;
    ASSERT_EQ(started.code, 0) << started.out;
    folder_.write("squares.toml", study);
  }

  void TearDown() override {
    if (is_there_) shell(cluster_ + "stop '" + cluster_folder_ + "' 2>&1");
  }

  /// Whether this comes true within two minutes.
  template <class Condition>
  static bool wait_for(const Condition& condition) {
    for (int k = 0; k < 600; ++k) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    return false;
  }

  bool wait_for_all() const {
    return wait_for([&] { return shell(in_folder_ + "squeue --noheader").out.empty(); });
  }

  std::size_t records_in(const std::string& store) const {
    const Answer info = call(folder_, "db info --json --db " + store, in_folder_);
    return info.code == 0 ? info.json()["records"].get<std::size_t>() : 0;
  }

  /// What the study says of its results in a store, without the line of what was run.
  std::string study_from(const std::string& store) const {
    const std::string out = call(folder_, "study squares.toml --db " + store, in_folder_).out;
    return out.substr(0, out.rfind('\n', out.size() - 2));
  }

  Folder folder_;
  std::string cluster_folder_ = folder_ / "cluster", cluster_ = "'" MPMVV_SOURCE_DIR "/tests/cli/slurm_cluster' ";
  std::string in_folder_ = "cd '" + (folder_ / "") + "' && export SLURM_CONF='" + cluster_folder_ + "/slurm.conf' && ";
  bool is_there_ = false;
};

TEST_F(SlurmNightly, AKilledShardIsNamedAndSubmittedAgainAndTheResultIsThatOfOneRun) {
  const Answer submitted = call(folder_, "submit squares.toml --engine slurm --shards 3 --db r.db", in_folder_);
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  const std::string log = folder_ / "r.shards/merge.log";
  ASSERT_TRUE(wait_for([&] { return records_in("r.shards/shard-2.db") > 0; }));
  const std::string job = submitted.out.substr(submitted.out.find(": job ") + 6, 1);
  const Answer killed = shell(in_folder_ + "scancel --full --signal=KILL " + job + "_2 2>&1");
  EXPECT_EQ(killed.code, 0) << killed.out;
  ASSERT_TRUE(wait_for_all());
  EXPECT_THAT(read_text(log), AllOf(HasSubstr("missing: shards 2 of 3"), HasSubstr("submit.sh' 2\n")));
  const std::size_t kept = records_in("r.shards/shard-2.db");
  ASSERT_GT(kept, 0U);

  EXPECT_EQ(shell(in_folder_ + "r.shards/submit.sh 2 2>&1").code, 0);
  ASSERT_TRUE(wait_for_all());
  EXPECT_THAT(read_text(folder_ / "r.shards/shard-2.log"), HasSubstr("0 failed")) << "the second time";
  EXPECT_THAT(read_text(log), AllOf(HasSubstr("14 records copied from 3 stores"),
                                    HasSubstr("0 cases run, 14 taken from"), HasSubstr("report/index.html")));
  ASSERT_EQ(call(folder_, "study squares.toml --db whole.db", in_folder_).code, 0);
  EXPECT_EQ(study_from("r.db"), study_from("whole.db"));
}

}  // namespace mpmvv::cli::slurm_test
