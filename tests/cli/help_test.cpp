#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "cli/lines.hpp"
#include "studies/store/provenance.hpp"
#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::help_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The lines of a help's section, without the blanks before them.
std::vector<std::string> section(const std::string& help, const std::string& head) {
  std::vector<std::string> lines;
  std::istringstream text(help);
  bool is_inside = false;
  for (std::string line; std::getline(text, line);) {
    if (is_inside && line.starts_with("  ")) lines.push_back(line.substr(2));
    is_inside = line == head + ":" || (is_inside && line.starts_with("  "));
  }
  return lines;
}

class Help : public testing::Test {
 protected:
  std::string help(const std::string& command) {
    const Answer answer = call(folder_, command + " --help");
    EXPECT_EQ(answer.code, 0) << command;
    return answer.out;
  }

  Folder folder_;
};

/// The folder that the examples speak of: a study with results and a golden, versions, cases to time.
class HelpExamples : public Help {
 protected:
  void SetUp() override {
    const std::string study = folder_.write("splines.toml", small_study);
    for (const char* sub : {"goldens", "other"}) std::filesystem::create_directories(folder_ / sub);
    folder_.write("goldens/splines.toml",
                  "reviewed = \"now\"\nstudy = \"splines\"\n"
                  "[[status]]\nseries = \"linear\"\nat = 8\nexpected = \"ok\"\n");
    write_output();
    folder_.write("cases.txt", "--problem bar --cells 8 --ppc 2 --cfl 0.4\n");
    folder_.write("points.csv", "X,Y,t\n0.2,0.7,0.001\n");
    folder_.write("other/mpmvv",
                  "#!/bin/sh\n[ $1 = --version ] && echo mpmvv c0ffee && exit\necho '{\"status\": \"ok\", "
                  "\"ns_per_particle_step\": 1e9}'\n");
    std::filesystem::permissions(folder_ / "other/mpmvv", std::filesystem::perms::owner_all);
    ASSERT_EQ(call(folder_, "study " + study + " --db " + db_).code, 0);
    for (const auto& [digest, of_code] : {std::pair{"3f2a91", "1.3"}, {"c0ffee", "1.4"}}) {
      store::Provenance version = store::current_provenance();
      version.digest = version.commit = digest;
      records::StudyResult result;
      result.name = "splines";
      result.values = {{"gap", 1, "a gap"}};
      result.series.resize(1);
      result.series[0].code = records::OtherCode{"my-code", of_code, "", "reference", digest};
      store::Store(db_, store::Store::Mode::write).keep_study(result, {}, version);
    }
    for (const char* shard : {"shard-1.db", "shard-2.db"}) std::filesystem::copy_file(db_, folder_ / shard);
  }

  /// What another code wrote of a case, in its own units and names, too: here the exact solution.
  void write_output() {
    const std::string the_case = " --problem square-rest --cells 16 --ppc 2 --cfl 0.2 --end-time 0.008";
    ASSERT_EQ(call(folder_, "case" + the_case + " > " + (folder_ / "case.json")).code, 0);
    const std::string of_a_code = "case --code small-mpm --variant linear";
    ASSERT_EQ(call(folder_, of_a_code + the_case + " > " + (folder_ / "theirs.json")).code, 0);
    ASSERT_EQ(call(folder_, "particles" + the_case + " --vtu " + (folder_ / "start.vtu")).code, 0);
    ASSERT_EQ(call(folder_, "run --basis cpdi" + the_case + " --vtu " + (folder_ / "run")).code, 0);
    std::filesystem::rename(folder_ / "run/particles-0010.vtu", folder_ / "end.vtu");
    const Answer exact = carry_out(folder_, "mpmvv particles" + the_case +
                                                " | mpmvv solution --problem square-rest --points - --time 0.008 "
                                                "--fields u | tee end.csv");
    ASSERT_EQ(exact.code, 0) << exact.err;
    folder_.write("end.dump", dump_of(exact.out));
  }

  /// Particles in mm, with names of their own.
  static std::string dump_of(const std::string& points) {
    std::string text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1024\nITEM: ATOMS tag px py\n";
    std::istringstream lines(points.substr(points.find('\n') + 1));
    int tag = 0;
    for (std::string line; std::getline(lines, line);) {
      double X = 0, Y = 0, t = 0, u = 0, v = 0;
      EXPECT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &X, &Y, &t, &u, &v), 5);
      text += fmt::format("{} {} {}\n", ++tag, 1e3 * (X + u), 1e3 * (Y + v));
    }
    return text;
  }

  /// Runs the examples of a command, and of those below it.
  void run_examples(const std::string& command) {
    ++commands_;
    const std::string text = help(command);
    const auto examples = section(text, "Examples");
    EXPECT_FALSE(examples.empty()) << "mpmvv " << command << " --help ends without examples";
    for (const std::string& example : examples) run_example(example);
    for (const std::string& line : section(text, "Subcommands"))
      if (!line.starts_with(' ')) run_examples(command + " " + line.substr(0, line.find(' ')));
  }

  void run_example(const std::string& example) {
    ASSERT_TRUE(example.starts_with("mpmvv ")) << example;
    const Answer answer = call(folder_, example.substr(6), "cd '" + (folder_ / "") + "' && ");
    EXPECT_EQ(answer.code, 0) << example << "\n" << answer.err;
    if (example.starts_with("mpmvv run")) {
      EXPECT_THAT(answer.out, Not(HasSubstr("unstable"))) << example;
    }
    EXPECT_LE(example.size(), 98U) << example;
  }

  std::string db_ = folder_ / "results.db";
  int commands_ = 0;
};

TEST_F(HelpExamples, OfEveryCommandEndsWithExamplesThatRun) {
  run_examples("");
  EXPECT_GE(commands_, 25) << "the program, its commands and those of db";
}

TEST_F(Help, OfEveryCommandFitsATerminalOf80Columns) {
  const auto check = [&](const auto& self, const std::string& command) -> void {
    const std::string text = on_terminal(folder_, 80, command + " --help");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(columns_of(line), 80U) << command << ": " << line;
    EXPECT_THAT(text, Not(HasSubstr("\n\n\n"))) << command;
    const std::string joined = std::regex_replace(text, std::regex(" \\\\\n +"), " ");
    EXPECT_EQ(section(joined, "Examples"), section(help(command), "Examples")) << command;
    for (const std::string& line : section(text, "Subcommands"))
      if (!line.starts_with(' ')) self(self, command + " " + line.substr(0, line.find(' ')));
  };
  check(check, "");
}

TEST_F(Help, IsWrappedOnTheNarrowestTerminal) {
  std::istringstream lines(on_terminal(folder_, 20, "db --help"));
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("  mpmvv")) {
      EXPECT_LE(columns_of(line), 42U) << line;
    }
}

TEST_F(Help, ShowsValuesAndDefaults) {
  const std::string run = help("run");
  EXPECT_THAT(run, AllOf(HasSubstr("--basis WORD            grid basis functions: linear, bspline2, "),
                         HasSubstr("cpdi, b2gimp, b2cpdi (default: linear)"), HasSubstr("what is solved: bar, square"),
                         HasSubstr("(this or --dt is required)"), HasSubstr("(default: the problem's)"),
                         HasSubstr("--threads NUMBER        threads of the step, 1 to 256 (default: 1)")));
  std::istringstream lines(run);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  EXPECT_THAT(help("score"), AllOf(HasSubstr("  output FILE ... "), Not(HasSubstr("... ..."))));
}

TEST_F(Help, SaysWhichOptionsAnExpressionNeedsForParticlesAlone) {
  const std::string text = std::regex_replace(help("expression"), std::regex("\n +"), " ");
  EXPECT_THAT(text, AllOf(HasSubstr("cells per length L of the problem (required with --form per-particle)"),
                          HasSubstr("(this or --dt is required with --form per-particle)"), HasSubstr(" (required) "),
                          HasSubstr("which alone takes the options of a whole case")));
}

}  // namespace mpmvv::cli::help_test
