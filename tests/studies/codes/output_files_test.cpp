#include "studies/codes/output_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "studies/codes/case_particles.hpp"
#include "studies/codes/external_run.hpp"
#include "studies/codes/file_order.hpp"
#include "studies/support/error.hpp"
#include "tests/own_folder.hpp"
#include "tests/studies/codes/mover.hpp"
#include "tests/studies/codes/written_run.hpp"

namespace mpmvv::output_files_test {

namespace fs = std::filesystem;
using namespace codes;
using support::UsageError;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// The last of these files, or what is said of them.
std::string last_of(const std::vector<std::string>& names) {
  try {
    return last_by_name({names.begin(), names.end()}, "*").filename().string();
  } catch (const UsageError& e) {
    return e.what();
  }
}

TEST(LastByName, ComparesNumbersByValueAndTextsAsTexts) {
  EXPECT_EQ(last_of({"state_10.csv", "state_9.csv", "state_2.csv"}), "state_10.csv");
  EXPECT_EQ(last_of({"out.10.csv", "out.9.csv"}), "out.10.csv");
  EXPECT_EQ(last_of({"nairn.9", "nairn.10", "nairn.8"}), "nairn.10");
  EXPECT_EQ(last_of({"a_0100_2.csv", "b_0001_1.csv", "a_0099_3.csv"}), "b_0001_1.csv");
  EXPECT_EQ(last_of({"run2_1.csv", "run10_0.csv"}), "run10_0.csv");
  EXPECT_EQ(last_of({"only.csv"}), "only.csv");
}

/// As codes write that name files by the time.
TEST(LastByName, ComparesDecimals) {
  EXPECT_EQ(last_of({"p_0.csv", "p_0.0075.csv", "p_0.008.csv"}), "p_0.008.csv");
  EXPECT_EQ(last_of({"p_0.0075.csv", "p_0.0080.csv"}), "p_0.0080.csv");
  EXPECT_EQ(last_of({"p_0.05.csv", "p_0.75.csv", "p_0.8.csv"}), "p_0.8.csv") << "0.05 can only be a decimal number";
  EXPECT_EQ(last_of({"p_1.csv", "p_1.5.csv", "p_2.csv"}), "p_2.csv");
  EXPECT_EQ(last_of({"p_1.csv", "p_1.5.csv"}), "p_1.5.csv");
  EXPECT_EQ(last_of({"p_1e-3.csv", "p_9e-4.csv", "p_5e-05.csv"}), "p_1e-3.csv");
  EXPECT_EQ(last_of({"p_0.0001.csv", "p_5e-05.csv"}), "p_0.0001.csv");
}

TEST(LastByName, RefusesWhatHasTwoReadings) {
  for (const auto& [decimals, whole] :
       {std::pair{"s_1.9.csv", "s_1.10.csv"}, {"s_0.8.csv", "s_0.75.csv"}, {"s_1.9999.csv", "s_1.10000.csv"}})
    EXPECT_THAT(last_of({"s_0.1.csv", decimals, whole}),
                AllOf(HasSubstr(fmt::format("'*' is {} and {}, and the last may be either", decimals, whole)),
                      HasSubstr("(the exact name, which may hold fields, as in state_{{steps}}.csv)")));
  EXPECT_EQ(last_of({"s_1.9.csv", "s_1.10.csv", "s_2.0.csv"}), "s_2.0.csv") << "of others it does not matter";
}

/// What a code left in a folder, read by an adapter.
class OutputFilesOfARun : public testing::Test {
 protected:
  OutputFilesOfARun() { code.adapter.output.end = "p_*.csv"; }
  ~OutputFilesOfARun() override { fs::remove_all(folder); }

  void write(const std::string& name, const std::string& content) const { std::ofstream(folder / name) << content; }
  Output read() const { return read_output(c, code, {}, folder); }
  records::Record scored() const { return score(c, code.adapter.stepping, read()); }
  std::string complaint() const {
    try {
      read();
    } catch (const UsageError& e) {
      return e.what();
    }
    return "";
  }

  /// The exact positions at a time, as the file states it. Those of some particles, counted from 1.
  std::string exact(double t, std::size_t from = 1, std::size_t to = 256) const {
    const auto particles = case_particles<2>(c);
    std::string text = fmt::format("# time = {:.17g}\nid,x,y\n", t);
    for (std::size_t p = from; p <= to; ++p) {
      const auto x = particles.exact(p - 1, t);
      text += fmt::format("{},{:.17g},{:.17g}\n", p, x[0], x[1]);
    }
    return text;
  }

  const cases::Case c = written_run::square();
  const double end_time = static_cast<double>(c.resolution.steps) * c.resolution.dt;
  const fs::path folder = own_folder("output-files");
  Code code;
};

TEST_F(OutputFilesOfARun, TheLastThatMatchesIsRead) {
  write("p_0.0035.csv", exact(end_time / 2));
  write("p_0.004.csv", exact(end_time));
  EXPECT_LT(score(c, read()).error.linf, 1e-15);
  write("p_0.9.csv", "x,y\n1,2\n"), write("p_0.10.csv", "x,y\n1,2\n");
  fs::remove(folder / "p_0.0035.csv"), fs::remove(folder / "p_0.004.csv");
  EXPECT_THAT(complaint(), HasSubstr("'p_*.csv' is p_0.9.csv and p_0.10.csv, and the last may be either"));
  code.adapter.output.end = "q_*.csv";
  EXPECT_EQ(complaint(), "the code wrote no file 'q_*.csv'");
}

TEST_F(OutputFilesOfARun, AllThatMatchArePartsWhereTheAdapterSaysSo) {
  for (const std::size_t from : {1, 65, 129, 193})
    write(fmt::format("p_{}.csv", from / 16), exact(end_time, from, from + 63));
  EXPECT_THAT(score(c, read()).reason, HasSubstr("192 of 256 particles are missing in"));
  code.adapter.output.are_parts = true;
  const Output output = read();
  std::vector<std::string> names;
  for (const SnapshotPart& part : output.end.parts) names.push_back(fs::path(part.file).filename());
  EXPECT_THAT(names, ElementsAre("p_0.csv", "p_4.csv", "p_8.csv", "p_12.csv"));
  const records::Record r = score(c, output);
  EXPECT_EQ(r.status, records::Status::ok) << r.reason;
  EXPECT_LT(r.error.linf, 1e-15);
  write("p_16.csv", exact(end_time / 2, 1, 1));
  EXPECT_THAT(complaint(), HasSubstr("p_16.csv is of another time than"));
}

/// As processes write that have no particles, or say which one they are.
TEST_F(OutputFilesOfARun, OfIdleProcessesAndTheirNumbersAreParts) {
  code.adapter.output.are_parts = true;
  write("p_0.csv", "# rank = 0\n# cells = 8\n" + exact(end_time, 1, 100));
  write("p_1.csv", "# rank = 1\nid,x,y\n");
  write("p_2.csv", "# rank = 2\n# cells = 8\n" + exact(end_time, 101, 256));
  EXPECT_EQ(scored().reason, "");
  write("p_2.csv", "# rank = 2\n# cells = 9\n" + exact(end_time, 101, 256));
  EXPECT_THAT(scored().reason, AllOf(HasSubstr("cells = 9 in "), HasSubstr("p_2.csv, the case has 8")));
  fs::remove(folder / "p_0.csv"), fs::remove(folder / "p_2.csv");
  write("p_3.csv", "id,x,y\n");
  EXPECT_THAT(complaint(), HasSubstr("p_1.csv and 1 more (parts of one state, one at least with particles)"));
}

/// Two files, as of two processes, by an adapter.
TEST(OutputParts, AreAskedForInTheAdapter) {
  const Mover mover;
  std::string text = Mover::text;
  text.replace(text.find("\"particles.csv\""), 15, "\"part_*.csv\"\nparts = true");
  mover.adapter(text);
  mover.script(std::string(Mover::moving) +
               "(head -1 particles.csv; tail -32 particles.csv) > part_1.csv; head -33 particles.csv > part_0.csv\n");
  const records::Record r = run_external(settings::make_case(Mover::settings()), mover.code());
  EXPECT_EQ(r.status, records::Status::ok) << r.reason;
  EXPECT_EQ(r.particles, 64);
}

/// A code that chooses its steps and ends beyond the end time has no error there that another time would have.
TEST_F(OutputFilesOfARun, IsScoredAtTheTimeThatItStates) {
  const double late = 1.02 * end_time;
  write("p_1.csv", exact(late));
  EXPECT_THAT(scored().reason, HasSubstr("(time_tolerance of the adapter: 1e-09)"));
  code.adapter.stepping.time_tolerance = 0.1;
  const records::Record r = scored();
  EXPECT_EQ(r.status, records::Status::ok) << r.reason;
  EXPECT_LT(r.error.linf, 1e-15);
}

/// As rounded for print: what is stated is the end time then.
TEST_F(OutputFilesOfARun, IsScoredAtTheEndTimeWhereTheTimeIsRounded) {
  std::string text = exact(end_time);
  text.replace(0, text.find('\n'), fmt::format("# time = {:.17g}", end_time * (1 + 1.5e-6)));
  write("p_1.csv", text);
  code.adapter.stepping.time_tolerance = 0.1;
  EXPECT_LT(scored().error.linf, 1e-15);
}

TEST_F(OutputFilesOfARun, OfAnotherStepInACommentIsRefused) {
  write("p_1.csv", fmt::format("# step = {}\n", c.resolution.steps - 1) + exact(end_time));
  EXPECT_THAT(scored().reason, HasSubstr("and not of the last one"));
  EXPECT_THAT(score(c, read()).reason, HasSubstr("and not of the last one"));
  code.adapter.stepping.is_given = false;
  const records::Record r = scored();
  EXPECT_EQ(r.reason, "");
  EXPECT_EQ(r.steps, c.resolution.steps - 1);
  EXPECT_TRUE(std::isnan(r.cfl));
}

}  // namespace mpmvv::output_files_test
