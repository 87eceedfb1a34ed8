#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "studies/store/provenance.hpp"
#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::submit_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A cluster's scripts, carried out by a shell in place of the cluster.
class Submit : public testing::Test {
 protected:
  void SetUp() override { folder_.write("splines.toml", small_study); }

  Answer submit(const std::string& options) const {
    return call(folder_, "submit --engine slurm splines.toml --db r.db " + options, in_folder_);
  }

  /// A golden of the study: what its first series is said to be on 8 cells.
  void write_golden(const std::string& goldens, const std::string& expected) const {
    std::filesystem::create_directories(folder_ / goldens);
    folder_.write(goldens + "/splines.toml",
                  "reviewed = \"now\"\nstudy = \"splines\"\n[[status]]\nseries = \"linear\"\nat = 8\nexpected = \"" +
                      expected + "\"\n");
  }

  /// What a script of r.shards does, and prints.
  Answer carry_out_script(const std::string& script, const std::string& variables = "") const {
    return shell(in_folder_ + variables + " r.shards/" + script + " 2>&1");
  }

  std::string script(const std::string& name) const { return read_text(folder_ / ("r.shards/" + name)); }

  Folder folder_;
  std::string in_folder_ = "cd '" + (folder_ / "") + "' && ";
};

TEST_F(Submit, WritesScriptsThatAskForWhatTheEstimateSays) {
  const Answer answer =
      submit("--shards 2 --jobs 3 --partition long --account mpm --option=--qos=night --option=--nice --dry-run");
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, AllOf(HasSubstr("2 shards, the longest about"), HasSubstr("on 3 jobs"),
                                HasSubstr("asking for 11 min"), HasSubstr("written, not submitted")));
  for (const char* name : {"shard.sh", "merge.sh"})
    EXPECT_THAT(script(name), AllOf(HasSubstr("#SBATCH --cpus-per-task=3\n"), HasSubstr("#SBATCH --partition=long\n"),
                                    HasSubstr("#SBATCH --account=mpm\n"), HasSubstr("#SBATCH --qos=night\n"),
                                    HasSubstr("#SBATCH --nice\n")));
  EXPECT_THAT(script("shard.sh"),
              AllOf(HasSubstr("#SBATCH --time=11\n"), HasSubstr("#SBATCH --mem=513M\n"), Not(HasSubstr("exclusive"))));
}

/// One run of the study's kind that took a second per particle and step.
void keep_slow_run(const std::string& file) {
  records::Record record;
  record.the_case.problem.name = "bar";
  record.the_case.scheme.basis = "linear";
  record.the_case.scheme.integrator = "cd";
  record.particles = record.steps = 1;
  record.wall_seconds = 1;
  store::Store(file, store::Store::Mode::create_or_write).keep(record, store::current_provenance());
}

TEST_F(Submit, AsksForMoreTimeWhereAStoreHasSeenMore) {
  keep_slow_run(folder_ / "seen.db");
  ASSERT_EQ(submit("--shards 2 --costs seen.db --dry-run").code, 0);
  const std::string text = script("shard.sh"), option = "--time=";
  EXPECT_GT(std::stoi(text.substr(text.find(option) + option.size())), 1000);
  EXPECT_THAT(text, HasSubstr("costs=(--costs '" + (folder_ / "r.shards/costs.db") + "')"));
  EXPECT_EQ(carry_out_script("shard.sh", "SLURM_ARRAY_TASK_ID=2").code, 0);
}

TEST_F(Submit, LeavesTheMachineToWhatIsTimed) {
  std::string timed = small_study;
  timed.replace(timed.find("ppc = 4"), 7, "ppc = 4\nrepeat = 3");
  folder_.write("splines.toml", timed);
  ASSERT_EQ(submit("--shards 2 --dry-run").code, 0);
  EXPECT_THAT(script("shard.sh"), HasSubstr("#SBATCH --exclusive\n"));
}

TEST_F(Submit, HandsAnArrayAndADependentJobToSlurm) {
  std::filesystem::create_directories(folder_ / "bin");
  folder_.write("bin/sbatch", "#!/bin/sh\necho \"$@\" >> '" + (folder_ / "calls") + "'\necho '17;here'\n");
  std::filesystem::permissions(folder_ / "bin/sbatch", std::filesystem::perms::owner_all);
  in_folder_ += "export PATH='" + (folder_ / "bin") + "':\"$PATH\" && ";
  const Answer answer = submit("--shards 4");
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("shards 1-4: job 17\nmerge, gate and report: job 17, "));
  EXPECT_EQ(carry_out_script("submit.sh 2,4").code, 0);
  const std::string shards = folder_ / "r.shards";
  EXPECT_EQ(read_text(folder_ / "calls"), "--parsable --array=1-4 " + shards + "/shard.sh\n" +
                                              "--parsable --dependency=afterany:17 " + shards + "/merge.sh\n" +
                                              "--parsable --array=2,4 " + shards + "/shard.sh\n" +
                                              "--parsable --dependency=afterany:17 " + shards + "/merge.sh\n");
}

TEST_F(Submit, SaysWhereThereIsNoSlurm) {
  const Answer answer =
      call(folder_, "submit --engine slurm splines.toml --db r.db --shards 2", in_folder_ + "PATH=/nowhere ");
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("no sbatch on PATH, which slurm submits with"));
  EXPECT_EQ(answer.out, "");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "r.shards"));
}

TEST_F(Submit, TheLastJobNamesMissingShardsAndMergesWhenAllAreThere) {
  write_golden("goldens", "ok");
  ASSERT_EQ(submit("--shards 3 --dry-run").code, 0);
  EXPECT_EQ(carry_out_script("shard.sh", "SLURM_ARRAY_TASK_ID=2").code, 0);
  const Answer missing = carry_out_script("merge.sh");
  EXPECT_EQ(missing.code, 1);
  EXPECT_THAT(missing.out, AllOf(HasSubstr("missing: shards 1,3 of 3"), HasSubstr("submit.sh' 1,3\n")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "r.db"));
  for (const char* number : {"1", "3"})
    EXPECT_EQ(carry_out_script("shard.sh", std::string("SLURM_ARRAY_TASK_ID=") + number).code, 0);
  const Answer merge = carry_out_script("merge.sh");
  EXPECT_EQ(merge.code, 0) << merge.out;
  EXPECT_THAT(merge.out, AllOf(HasSubstr("8 records copied from 3 stores"), HasSubstr("0 cases run, 8 taken"),
                               HasSubstr("gate"), HasSubstr("report/index.html")));
}

TEST_F(Submit, TheLastJobGatesByTheGoldensThatItIsGiven) {
  write_golden("strict", "unstable");
  const Answer submitted = submit("--shards 1 --goldens strict --dry-run");
  ASSERT_EQ(submitted.code, 0);
  EXPECT_THAT(submitted.out, HasSubstr("1 shard, the longest"));
  ASSERT_EQ(carry_out_script("shard.sh", "SLURM_ARRAY_TASK_ID=1").code, 0);
  const Answer merge = carry_out_script("merge.sh");
  EXPECT_EQ(merge.code, 1) << merge.out;
  EXPECT_THAT(merge.out, HasSubstr("gate: 0 pass, 1 fail"));
}

TEST_F(Submit, LeavesTheStoreOfAllResultsAlone) {
  std::filesystem::create_directories(folder_ / "runs");
  keep_slow_run(folder_ / "last.db");
  for (const std::string db : {"runs/costs.db", "runs/shard-1.db"}) {
    keep_slow_run(folder_ / db);
    const std::string before = read_text(folder_ / db);
    const Answer answer =
        call(folder_,
             "submit --engine slurm splines.toml --db " + db + " --folder runs --costs last.db --shards 2 --dry-run",
             in_folder_);
    EXPECT_EQ(answer.code, 2) << db;
    EXPECT_THAT(answer.err, HasSubstr("--db " + (folder_ / db) + " is a store that the submission in --folder"));
    EXPECT_EQ(read_text(folder_ / db), before);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "runs/submit.sh"));
  EXPECT_EQ(call(folder_, "submit --engine slurm splines.toml --db runs/all.db --folder runs --shards 2 --dry-run",
                 in_folder_)
                .code,
            0);
}

TEST_F(Submit, LeavesThePlaceOfTheStoreFree) {
  const Answer answer =
      call(folder_, "submit --engine slurm splines.toml --shards 2 --db all.shards --dry-run", in_folder_);
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("all.shards is the folder of the submission, too (another name, or --folder)"));
  EXPECT_EQ(call(folder_, "submit --engine slurm splines.toml --shards 2 --db all --folder all/", in_folder_).code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "all.shards"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "all"));
}

/// A line break would make a line of its own, which the jobs carry out.
TEST_F(Submit, RefusesWhatDoesNotStayInItsLineOfAScript) {
  for (const char* name : {"'a\ntouch evil'", "'a\rb'", "'a b'", "'a#b'", "\"a'b\""})
    for (const std::string option : {"--partition", "--account"}) {
      const Answer answer = submit("--shards 2 --dry-run " + option + " " + name);
      EXPECT_EQ(answer.code, 2) << option << name;
      EXPECT_THAT(answer.err, AllOf(HasSubstr(option + ": 'a"), HasSubstr("(a name without blanks, line breaks,")));
    }
  for (const char* option : {"foo", "'--qos=a\ntouch evil'"}) {
    const Answer answer = submit(std::string("--shards 2 --dry-run --option=") + option);
    EXPECT_EQ(answer.code, 2) << option;
    EXPECT_THAT(answer.err, HasSubstr("(an option such as --qos=long, in one line)"));
  }
  for (const char* folder : {"\"it's/cl\"", "'a\nb'", "'a\"b'"})
    EXPECT_THAT(submit(std::string("--shards 2 --dry-run --folder ") + folder).err, HasSubstr("a name without quotes"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "r.shards"));
  EXPECT_EQ(submit("--shards 2 --dry-run --partition a,b --option='--comment=\"two words\"'").code, 0);
}

TEST_F(Submit, RefusesWhatNoClusterTakes) {
  EXPECT_THAT(submit("--shards 0 --dry-run").err, HasSubstr("--shards"));
  EXPECT_THAT(submit("--shards 2 --folder 'a%b' --dry-run").err, HasSubstr("per cent signs"));
  EXPECT_THAT(call(folder_, "submit --engine pbs splines.toml --db r.db --shards 2", in_folder_).err,
              HasSubstr("--engine: unknown word 'pbs' (known: slurm)"));
  EXPECT_THAT(call(folder_, "submit --help").out, HasSubstr("what hands jobs to machines: slurm"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "r.shards"));
}

}  // namespace mpmvv::cli::submit_test
