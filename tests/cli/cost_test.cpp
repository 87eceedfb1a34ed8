#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>

#include "tests/cli/program.hpp"

namespace mpmvv::cli::cost_command_test {

using testing::HasSubstr;

/// A baseline that answers as it is told.
class CostCommand : public testing::Test {
 protected:
  Answer beside(const std::string& answer, const std::string& form = " --json") {
    const std::string baseline =
        folder_.write("baseline", "#!/bin/sh\n[ \"$1\" = --version ] && echo mpmvv c0ffee && exit\n" + answer + "\n");
    std::filesystem::permissions(baseline, std::filesystem::perms::owner_all);
    const std::string cases = folder_.write(
        "cost.txt", "# one\n\n--problem bar --basis linear --integrator cd --cells 8 --ppc 1 --cfl 0.2 --steps 4\n");
    return call(folder_, "cost " + baseline + " --cases " + cases + form);
  }
  static std::string cost(double ns) {
    return "echo '{\"status\": \"ok\", \"ns_per_particle_step\": " + std::to_string(ns) + "}'";
  }

  const Folder folder_;
};

TEST_F(CostCommand, FailsWhatCostsMoreThanTheBaseline) {
  const Answer slower = beside(cost(1e-3)), faster = beside(cost(1e9));
  EXPECT_EQ(slower.code, 1);
  EXPECT_EQ(slower.json()["cases"][0]["verdict"], "fail");
  EXPECT_EQ(slower.json()["mean"]["verdict"], "fail");
  EXPECT_GT(slower.json()["mean"]["least"], 1.03);
  EXPECT_EQ(faster.code, 0);
  EXPECT_EQ(faster.json()["cases"][0]["verdict"], "pass");
  EXPECT_EQ(faster.json()["mean"]["verdict"], "pass");
  EXPECT_LT(faster.json()["mean"]["most"], 1);
}

TEST_F(CostCommand, EndsWithTheMeanOfTheCases) {
  EXPECT_THAT(beside(cost(1e9), "").out,
              HasSubstr("cost: 1 pass, 0 fail, 0 inconclusive (at most 1.1 of the baseline's); mean of the "
                        "cases: pass, 0.000 (99 %: 0.000 to 0.000; at most 1.03)\n"));
}

/// What runs once finds the machine cold.
TEST_F(CostCommand, CountsRepeatedTimes) {
  EXPECT_EQ(beside("case \"$*\" in *'--repeat 3'*) " + cost(1e9) + ";; *) " + cost(1e-3) + ";; esac").code, 0);
}

/// Rounds that are no numbers do not count. mpmvv writes null where nothing was measured.
TEST_F(CostCommand, TakesTheMedianOfTheRounds) {
  const auto rounds = [&](const std::string& list) {
    return beside("echo '{\"status\": \"ok\", \"ns_per_particle_step\": 1e9, \"cost\": " + list + "}'").code;
  };
  EXPECT_EQ(rounds(R"({"rounds": [1e-3, 1e-3, 1e9]})"), 1);
  for (const char* none : {R"({"rounds": [1e-3, null]})", R"({"rounds": []})", R"({"rounds": 1e-3})", "[]", "null"})
    EXPECT_EQ(rounds(none), 0) << none;
}

/// A part has fewer particles to a node than the body. Versions that know of no parts run all of it anyway.
TEST_F(CostCommand, TimesWholeBodies) {
  const std::string at_whole = "case \"$*\" in *--whole*) ";
  EXPECT_EQ(beside(at_whole + cost(1e9) + ";; *) " + cost(1e-3) + ";; esac").code, 0);
  EXPECT_EQ(beside(at_whole + "exit 2;; *) " + cost(1e9) + ";; esac").code, 0);
}

TEST_F(CostCommand, LeavesOutWhatTheBaselineDoesNotKnow) {
  const Answer answer = beside("echo 'mpmvv: unknown basis' >&2; exit 2");
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.err, HasSubstr("left out"));
  EXPECT_EQ(answer.json()["left_out"].size(), 1U);
  EXPECT_EQ(answer.json()["cases"].size(), 0U);
  EXPECT_TRUE(answer.json()["mean"].is_null());
}

TEST_F(CostCommand, RefusesABaselineThatIsNoSuchProgram) {
  for (const char* answer : {"echo 3", "echo '{}'", "echo '{\"status\": 1}'", "exit 1", "exit 0"}) {
    const Answer beside_none = beside(answer);
    EXPECT_EQ(beside_none.code, 2) << answer;
    EXPECT_THAT(beside_none.err, HasSubstr("a program like this one")) << answer;
  }
  EXPECT_THAT(beside("echo '{\"status\": \"unstable\", \"reason\": \"at step 3\"}'").err,
              HasSubstr("a run that ends ok): unstable (at step 3)"));
  EXPECT_THAT(beside("exit 3").err, HasSubstr("it prints nothing, and its exit code is 3\n"));
  EXPECT_THAT(call(folder_, "cost /nope").err, HasSubstr("baseline '/nope' is no program (another build of this one)"));
  const Answer beside_ls = call(folder_, "cost /bin/ls");
  EXPECT_EQ(beside_ls.code, 2);
  EXPECT_THAT(beside_ls.err, testing::AllOf(HasSubstr("baseline '/bin/ls' is no mpmvv"), HasSubstr("'ls (")));
  EXPECT_EQ(beside(cost(0)).code, 2);
  EXPECT_EQ(beside(cost(-1)).code, 2);
  EXPECT_EQ(call(folder_, "cost " + folder_.write("text", "no program") + " --cases " + (folder_ / "cost.txt")).code,
            2);
}

TEST_F(CostCommand, RefusesWhatIsNoCase) {
  const std::string program = cli::program();
  for (const auto& [text, said] :
       {std::pair{"# none\n", "names no case"}, {"\n--problem bar\n", "does not carry out the case in "}}) {
    const Answer answer = call(folder_, "cost " + program + " --cases " + folder_.write("cases.txt", text));
    EXPECT_EQ(answer.code, 2);
    EXPECT_THAT(answer.err, HasSubstr(said));
  }
  const Answer barr = call(folder_, "cost " + program + " --cases " + folder_.write("cases.txt", "\n--problem barr\n"));
  EXPECT_THAT(barr.err, testing::AllOf(HasSubstr("cases.txt:2"), HasSubstr("unknown problem 'barr'"),
                                       testing::Not(HasSubstr("\\n"))));
  EXPECT_EQ(call(folder_, "cost " + program + " --cases nowhere.txt").code, 2);
  EXPECT_EQ(call(folder_, "cost nowhere").code, 2);
}

/// The cases that ./run cost times, by their first steps.
TEST_F(CostCommand, EveryCaseOfTheTreeIsOne) {
  std::istringstream lines(read_text(MPMVV_SOURCE_DIR "/studies/cost.txt"));
  std::set<std::string> bases, integrators, masses;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    const Answer answer = call(folder_, "run --json --steps 2 " + line);
    ASSERT_EQ(answer.code, 0) << line << answer.err;
    EXPECT_EQ(answer.json()["status"], "ok") << line;
    const auto scheme = answer.json()["scheme"];
    bases.insert(scheme["basis"]), integrators.insert(scheme["integrator"]), masses.insert(scheme["mass"]);
  }
  EXPECT_THAT(bases, testing::IsSupersetOf({"linear", "bspline2", "bspline3", "bspline2-open", "bspline3-open", "ugimp",
                                            "gimp", "cpgimp", "cpdi", "b2gimp", "b2cpdi"}));
  EXPECT_THAT(integrators, testing::IsSupersetOf({"usf", "usl", "usavg", "usl+", "usavg+", "cd", "uvf", "rk4"}));
  EXPECT_THAT(masses, testing::UnorderedElementsAre("lumped", "consistent"));
}

}  // namespace mpmvv::cli::cost_command_test
