#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv::cli::score_test {

using testing::AllOf;
using testing::HasSubstr;

/// A case, the state that a run of ours ends with, and what the run says of itself.
class Score : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(call(folder_, "case" + the_case_ + " > '" + file_ + "'").code, 0);
    const Answer run = call(folder_, "run" + the_case_ + " --json --vtu '" + (folder_ / "frames") + "'");
    ASSERT_EQ(run.code, 0) << run.err;
    run_ = run.json();
  }

  /// The first state in a file that does not say its time.
  std::string start_without_time() {
    std::string text = read_text(folder_ / "frames/particles-0000.vtu");
    const auto from = text.find("<FieldData>"), to = text.find("<Piece");
    return "'" + folder_.write("start.vtu", text.erase(from, to - from)) + "'";
  }
  Answer score(const std::string& rest) { return call(folder_, "score '" + file_ + "' " + rest); }

  const std::string the_case_ =
      " --problem square --basis bspline2 --cells 8 --ppc 2 --cfl 0.2 --end-time 0.004 --boundary mirror "
      "--param amplitude=0.03";
  Folder folder_;
  const std::string file_ = folder_ / "case.json", end_ = "'" + (folder_ / "frames/particles-0010.vtu") + "'",
                    start_ = "'" + (folder_ / "frames/particles-0000.vtu") + "'";
  nlohmann::json run_;
};

TEST_F(Score, OurOwnRunIsScoredAsItWasMeasured) {
  const Answer answer = score(end_ + " --json");
  ASSERT_EQ(answer.code, 0) << answer.out << answer.err;
  const nlohmann::json scored = answer.json();
  EXPECT_EQ(scored["status"], "ok") << scored["reason"];
  for (const char* path : {"/error/l1", "/error/l2", "/error/linf", "/balance/momentum", "/energy/kinetic"}) {
    const nlohmann::json::json_pointer at(path);
    EXPECT_NEAR(scored[at].get<double>(), run_[at].get<double>(), 1e-13 * std::max(1.0, run_[at].get<double>()))
        << path;
  }
  for (const char* key : {"problem", "parameters", "cells", "ppc", "particles", "steps", "dt", "end_time"})
    EXPECT_EQ(scored[key], run_[key]) << key;
  EXPECT_TRUE(scored["scheme"].is_null()) << "whose output it is, the case does not say";
}

TEST_F(Score, ATableAsARunHasIt) {
  const Answer answer = score(end_ + " --start " + start_);
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out,
              AllOf(HasSubstr("square as another code has solved it: "), HasSubstr("17 digits"), HasSubstr("status ok"),
                    HasSubstr("displacement at the end (m)"), HasSubstr("error that the output's digits make (m)")));
}

TEST_F(Score, AnOutputOfAnotherTimeHasFailed) {
  const Answer answer = score(start_);
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.out, HasSubstr("status failed (time 0 s in "));
  EXPECT_THAT(score(start_without_time()).out, AllOf(HasSubstr("status failed (another time in "),
                                                     HasSubstr("let it say so: # time = 0.004 in a text")));
}

TEST_F(Score, SaysWhereTheEndOfACaseIsItsStart) {
  const std::string rest = " --problem square-rest --basis bspline2 --cells 8 --ppc 2 --cfl 0.2";
  ASSERT_EQ(call(folder_, "case" + rest + " > '" + file_ + "'").code, 0);
  ASSERT_EQ(call(folder_, "run" + rest + " --vtu '" + (folder_ / "frames") + "'").code, 0);
  const Answer answer = score(end_ + " --json");
  EXPECT_EQ(answer.code, 0) << answer.out;
  EXPECT_THAT(answer.json()["caution"], HasSubstr("a code that does nothing has no error"));
  EXPECT_THAT(answer.err, AllOf(HasSubstr("mpmvv: at the end of the case, 0.02 s"), HasSubstr("such as 0.01)")));
  const Answer at_rest = score(start_without_time());
  EXPECT_EQ(at_rest.code, 1);
  EXPECT_THAT(at_rest.out, HasSubstr("are where they were at time zero, and so are those of the exact solution"));
}

/// The exact end of a body that is 1 mm thick.
TEST_F(Score, DividesMassesByTheThicknessOfAPlaneBody) {
  const std::string write =
      "mpmvv particles" + the_case_ +
      " > start.csv; mpmvv solution --problem square --param amplitude=0.03 --points start.csv --time 0.004 --fields u "
      "> "
      "u.csv; paste -d, start.csv u.csv | awk -F, 'NR == 1 { print \"id,x,y,m\" } NR > 1 { printf "
      "\"%d,%.17g,%.17g,%.17g\\n\", $1, $2 + $(NF - 1), $3 + $NF, 1e-3 * $8 }' > end.csv";
  const Answer written = carry_out(folder_, write);
  ASSERT_EQ(written.code, 0) << written.err;
  const std::string end = "'" + (folder_ / "end.csv") + "'";
  const Answer thin = score(end);
  EXPECT_EQ(thin.code, 1);
  EXPECT_THAT(thin.out, HasSubstr("0.001 times that of the case (which is 1 m thick: --thickness, or thickness in "));
  const Answer answer = score(end + " --thickness 1e-3 --json");
  ASSERT_EQ(answer.code, 0) << answer.out;
  EXPECT_NEAR(answer.json()["balance"]["mass"].get<double>(), 0, 1e-12);
  EXPECT_EQ(score(end + " --thickness 0").code, 2);
}

TEST_F(Score, OfALineHasNoThickness) {
  ASSERT_EQ(call(folder_, "case --problem bar --cells 4 --ppc 2 --cfl 0.2 > '" + file_ + "'").code, 0);
  const Answer answer = score(end_ + " --thickness 1e-3");
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("--thickness 1e-3 of a case in 1 dimension (it is that of a plane body)"));
}

TEST_F(Score, RefusesWhatItCannotRead) {
  const auto refusal = [&](const std::string& rest) {
    const Answer answer = score(rest);
    EXPECT_EQ(answer.code, 2) << rest;
    EXPECT_EQ(answer.out, "") << rest;
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    return answer.err;
  };
  EXPECT_THAT(refusal(end_ + " --format ppm"), HasSubstr("unknown format 'ppm' in --format (known: csv, vtu, ply"));
  EXPECT_THAT(refusal(folder_.write("end.xyz", "1 2\n")), HasSubstr("does not say its format (--format csv|vtu|"));
  EXPECT_THAT(refusal("absent.csv"), HasSubstr("absent.csv"));
  EXPECT_THAT(refusal(end_ + " --step 3"), HasSubstr("--step 3 of "));
  EXPECT_THAT(refusal(folder_.write("end.csv", "x,y\n1,one\n")), HasSubstr("'one' for 'y' in"));
  EXPECT_THAT(refusal(end_ + " --length-unit 0"), HasSubstr("--length-unit"));
  folder_.write("case.json", "{}");
  EXPECT_THAT(refusal(end_), HasSubstr("no field 'case' in "));
  folder_.write("case.json", "problem");
  EXPECT_THAT(refusal(end_), HasSubstr("no JSON in"));
}

TEST_F(Score, ACaseThatWasEditedIsRefused) {
  nlohmann::json edited = nlohmann::json::parse(read_text(file_));
  edited["parameters"]["amplitude"] = 0.04;
  folder_.write("case.json", edited.dump());
  const Answer answer = score(end_);
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("settings that make another case than its text"));
}

}  // namespace mpmvv::cli::score_test
