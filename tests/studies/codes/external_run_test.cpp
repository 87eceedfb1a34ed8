#include "studies/codes/external_run.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "studies/support/error.hpp"
#include "tests/studies/codes/mover.hpp"

namespace mpmvv::codes::external_run_test {

using records::Record;
using records::Status;
using support::UsageError;
using testing::HasSubstr;

class ExternalRun : public testing::Test {
 protected:
  Record run() const { return run_external(settings::make_case(Mover::settings()), mover_.code()); }

  /// Of the code itself, before any run.
  std::string complaint() const {
    try {
      mover_.code();
    } catch (const UsageError& e) {
      return e.what();
    }
    return "";
  }

  const Mover mover_;
};

TEST_F(ExternalRun, IsScoredAsARunOfOurs) {
  const Record record = run();
  EXPECT_EQ(record.status, Status::ok) << record.reason;
  EXPECT_EQ(record.particles, 64);
  EXPECT_LT(record.error.linf, 1e-15);
  EXPECT_GT(record.wall_seconds, 0);
}

/// A body that moves as a whole has no stress.
TEST_F(ExternalRun, HasTheStressErrorThatIsAskedFor) {
  auto settings = Mover::settings();
  settings.push_back({"stress_error", "true", "test"});
  const cases::Case c = settings::make_case(settings);
  EXPECT_THAT(run_external(c, mover_.code()).reason,
              HasSubstr("no stresses in particles.csv for stress_error (columns"));
  const auto with_stress = [&](const char* stress) {
    mover_.script(
        "echo id,x,y,s_xx,s_yy,s_xy > particles.csv\n"
        "awk -v t=\"$1\" '{ printf \"%d,%.17g,%.17g," +
        std::string(stress) + ",0,0\\n\", $1, $2 + t * $4, $3 + t * $5 }' input.txt >> particles.csv");
    return run_external(c, mover_.code());
  };
  EXPECT_NEAR(with_stress("3").error.stress, 3, 1e-6);
  EXPECT_THAT(with_stress("nan").reason, HasSubstr("stresses that are no numbers in particles.csv"));
}

TEST_F(ExternalRun, KeepsItsFolderWhereItIsToldTo) {
  const auto kept = mover_.top() / "kept";
  run_external(settings::make_case(Mover::settings()), mover_.code(), kept);
  for (const char* file : {"input.txt", "particles.csv", "log.txt"})
    EXPECT_TRUE(std::filesystem::exists(kept / file)) << file;
}

TEST_F(ExternalRun, SaysHowTheProgramEnded) {
  mover_.script("echo no such mesh >&2; exit 3");
  const Record record = run();
  EXPECT_EQ(record.status, Status::failed);
  EXPECT_EQ(record.failure, records::Failure::of_case);
  EXPECT_THAT(record.reason, HasSubstr("ended with status 3: no such mesh; its folder: "));
  const std::filesystem::path folder = record.reason.substr(record.reason.rfind(' ') + 1);
  EXPECT_TRUE(std::filesystem::exists(folder / "log.txt"));
}

/// What templates cannot work out themselves.
TEST_F(ExternalRun, TellsTheParticlesOfACellAndATimeJustBeforeTheEnd) {
  mover_.write("input.mustache", "{{ppc}} {{particles_per_cell}} {{end_time}} {{before_end}} {{dt}} {{dimension}}");
  run_external(settings::make_case(Mover::settings()), mover_.code(), mover_.top() / "kept");
  double ppc = 0, particles = 0, end = 0, before = 0, dt = 0, dimension = 0;
  std::ifstream(mover_.top() / "kept" / "input.txt") >> ppc >> particles >> end >> before >> dt >> dimension;
  EXPECT_EQ(particles, std::pow(ppc, dimension));
  EXPECT_DOUBLE_EQ(end - before, dt / 2);
}

/// A result of the method, which the search of a limit can use.
TEST_F(ExternalRun, ThatSaysThatItBlewUpIsUnstable) {
  mover_.script("echo blown up at step 3; exit 1");
  EXPECT_EQ(run().status, Status::unstable);
}

/// Shell characters in a value are no commands.
TEST_F(ExternalRun, StartsWithoutAShell) {
  std::string text = Mover::text;
  text.replace(text.find("\"{{end_time}}\""), 14, "\"{{end_time}}\", \"; touch hit\"");
  mover_.adapter(text);
  const auto kept = mover_.top() / "kept";
  run_external(settings::make_case(Mover::settings()), mover_.code(), kept);
  EXPECT_FALSE(std::filesystem::exists(kept / "hit"));
}

TEST_F(ExternalRun, IsTimedInTheSameRoundsAsOurOwnSolver) {
  auto settings = Mover::settings();
  settings.push_back({"repeat", "3", "test"});
  std::vector<settings::Setting> of_own;
  for (const auto& [key, value] : {std::pair{"problem", "bar"},
                                   {"basis", "bspline2"},
                                   {"integrator", "cd"},
                                   {"cells", "8"},
                                   {"ppc", "2"},
                                   {"cfl", "0.4"},
                                   {"steps", "20"},
                                   {"repeat", "3"}})
    of_own.push_back({key, value, "test"});
  const cases::Case own = settings::make_case(of_own);
  const Codes codes{{"mover", mover_.code()}};
  const auto records =
      time_in_rounds({run_untimed(settings::make_case(settings), codes), run_untimed(own, codes)}, codes);
  for (const Record& record : records) {
    EXPECT_EQ(record.status, Status::ok) << record.reason;
    EXPECT_GT(record.cost.step_seconds, 0);
    EXPECT_GE(record.cost.spread, 0);
    EXPECT_EQ(record.cost.rounds.costs.size(), 3U);
  }
  EXPECT_EQ(records.at(0).cost.rounds.session, records.at(1).cost.rounds.session);
}

TEST_F(ExternalRun, ThatFailsInARepetitionHasFailed) {
  const std::string starts = "'" + (mover_.top() / "starts").string() + "'";
  mover_.script(std::string(Mover::moving) + "echo >> " + starts + "; test $(wc -l < " + starts +
                ") -lt 3 || exit 3\n");
  auto settings = Mover::settings();
  settings.push_back({"repeat", "3", "test"});
  const Codes codes{{"mover", mover_.code()}};
  const Record record = time_in_rounds({run_untimed(settings::make_case(settings), codes)}, codes).at(0);
  EXPECT_EQ(record.status, Status::failed);
  EXPECT_THAT(record.reason, HasSubstr("ended with status 3: it printed nothing; its folder: "));
  EXPECT_EQ(record.the_case.measure.repeat, 3);
  EXPECT_TRUE(std::isnan(record.cost.step_seconds));
}

TEST_F(ExternalRun, OfAnotherTimeHasFailed) {
  mover_.script(
      "echo id,x,y,m,time > particles.csv\n"
      "awk -v t=\"$1\" '{ print $1 \",\" $2 \",\" $3 \",\" $6 \",\" t / 2 }' input.txt >> particles.csv");
  const Record record = run();
  EXPECT_EQ(record.status, Status::failed);
  EXPECT_THAT(record.reason, HasSubstr("and not of the end time"));
}

/// A step of 0 is what some codes write of all.
TEST_F(ExternalRun, OfAnotherStepHasFailed) {
  std::string text = Mover::text;
  mover_.adapter(text.replace(text.find("particles.csv"), 13, "particles.dump"));
  const auto dump_of_step = [&](const char* step) {
    mover_.script("{ echo ITEM: TIMESTEP; echo " + std::string(step) +
                  "\nprintf 'ITEM: NUMBER OF ATOMS\\n64\\nITEM: ATOMS id x y\\n'\n"
                  "awk -v t=\"$1\" '{ printf \"%d %.17g %.17g\\n\", $1, $2 + t * $4, $3 + t * $5 }' input.txt\n"
                  "} > particles.dump");
    return run();
  };
  EXPECT_THAT(dump_of_step("7").reason, HasSubstr("particles.dump is of step 7 and not of the last one, 16"));
  EXPECT_EQ(dump_of_step("16").status, Status::ok);
  EXPECT_EQ(dump_of_step("0").status, Status::ok);
}

/// Without its motion the body is where it was at time zero: of a planted mistake that is an error like any other. To
/// leave out a body force that the problem has not is none.
TEST_F(ExternalRun, APlantedMistakeHasAnErrorAndNoOtherTime) {
  mover_.script(
      "echo id,x,y,m > particles.csv\n"
      "awk '{ print $1 \",\" $2 \",\" $3 \",\" $6 }' input.txt >> particles.csv");
  const auto run_of = [this](const char* problem, const char* form) {
    auto settings = Mover::settings();
    settings[0].value = problem;
    for (const auto& [key, value] : {std::pair{"force_form", form}, {"blowup_error", "100"}, {"end_time", "0.004"}})
      settings.push_back({key, value, "test"});
    return run_external(settings::make_case(settings), mover_.code());
  };
  for (const char* form : {"reference", "none"}) EXPECT_EQ(run_of("translation", form).status, Status::failed) << form;
  EXPECT_EQ(run_of("square", "reference").status, Status::failed);
  const Record record = run_of("square", "none");
  EXPECT_EQ(record.status, Status::ok) << record.reason;
  EXPECT_GT(record.error.l2, 0.01);
}

/// By which a code that knows places alone can be told which particle is meant.
TEST_F(ExternalRun, ABoxAboutAParticleHasThatOneInIt) {
  mover_.write("input.mustache", "{{#particles}}\n{{x_below}} {{x}} {{x_above}}\n{{/particles}}\n");
  run_external(settings::make_case(Mover::settings()), mover_.code(), mover_.top() / "kept");
  std::ifstream input(mover_.top() / "kept" / "input.txt");
  double below = 0, x = 0, above = 0;
  for (int p = 0; p < 64; ++p) {
    ASSERT_TRUE(input >> below >> x >> above);
    EXPECT_NEAR(x - below, 0.125 / 4, 1e-15);
    EXPECT_NEAR(above - x, 0.125 / 4, 1e-15);
  }
}

TEST_F(ExternalRun, UnknownFieldsAreNamed) {
  mover_.write("input.mustache", "{{cells}}\n{{#is_plane}}\n{{celsius}}{{/is_plane}}{{ cels }}\n{{cels}}");
  EXPECT_THAT(run().reason, HasSubstr("unknown field 'celsius' in "));
  EXPECT_THAT(run().reason, HasSubstr("/input.mustache:3 (docs/adapters.md"));
  mover_.write("input.mustache", "{{lower_x}} {{lower_z}}");
  EXPECT_THAT(run().reason, HasSubstr("unknown field 'lower_z' in "));
  EXPECT_THAT(run().reason, HasSubstr("(the case has fewer dimensions: between {{#is_plane}} and {{/is_plane}}, or"));
}

TEST_F(ExternalRun, TrueAndFalseOfAVariantAreConditions) {
  mover_.write("input.mustache",
               "{{#is_plain}}plain{{/is_plain}}{{^is_odd}}, not odd{{/is_odd}}{{#is_odd}}, odd{{/is_odd}}\n");
  auto settings = Mover::settings();
  settings.push_back({"variant", "plain", "test"});
  const Record record = run_external(settings::make_case(settings), mover_.code(), mover_.top() / "kept");
  std::string line;
  std::ifstream input(mover_.top() / "kept" / "input.txt");
  std::getline(input, line);
  EXPECT_EQ(line, "plain, not odd") << record.reason;
}

TEST_F(ExternalRun, EveryBoundaryIsACondition) {
  mover_.write("input.mustache",
               "{{#is_periodic}}periodic{{/is_periodic}}{{#is_dirichlet}}no{{/is_dirichlet}}"
               "{{#is_symmetry}}no{{/is_symmetry}}{{#is_mirror}}no{{/is_mirror}}{{#is_free}}no{{/is_free}}"
               "{{#is_wall}}no{{/is_wall}}\n");
  const Record record = run_external(settings::make_case(Mover::settings()), mover_.code(), mover_.top() / "kept");
  std::string line;
  std::ifstream input(mover_.top() / "kept" / "input.txt");
  std::getline(input, line);
  EXPECT_EQ(line, "periodic") << record.reason;
}

TEST_F(ExternalRun, NumbersHaveAllTheirDigits) {
  mover_.write("input.mustache", "{{h}} {{dt}} {{is_plane}} {{#is_line}}no{{/is_line}}");
  auto settings = Mover::settings("3");
  run_external(settings::make_case(settings), mover_.code(), mover_.top() / "kept");
  double h = 0, dt = 0;
  std::ifstream(mover_.top() / "kept" / "input.txt") >> h >> dt;
  EXPECT_EQ(h, 1.0 / 3);
  EXPECT_EQ(dt, settings::make_case(settings).resolution.dt);
}

TEST_F(ExternalRun, TheVersionIsThatOfTheProgramOrItsFile) {
  const std::string of_file = mover_.code().version;
  mover_.script("echo another");
  EXPECT_NE(mover_.code().version, of_file);
  std::string text = Mover::text;
  text.replace(text.find("[[input]]"), 0, "version = [\"{{program}}\", \"--version\"]\n");
  mover_.adapter(text);
  mover_.script("echo mover, version 2.1/b");
  EXPECT_EQ(mover_.code().version, "2.1_b");
  const std::string digest = mover_.code().digest;
  mover_.script("echo mover, version 2.1/b # with another force");
  EXPECT_NE(mover_.code().digest, digest) << "the version may be forgotten";
}

TEST_F(ExternalRun, SaysWhyThereIsNoVersion) {
  std::string text = Mover::text;
  text.replace(text.find("[[input]]"), 0, "version = [\"{{program}}\", \"--version\"]\n");
  mover_.adapter(text);
  mover_.script("echo no module numpy >&2; exit 1");
  EXPECT_THAT(
      complaint(),
      HasSubstr("mover --version ended with status 1: no module numpy (the version as its last word, within 20 s)"));
  mover_.script(":");
  EXPECT_THAT(complaint(), HasSubstr("mover --version printed nothing ("));
}

TEST_F(ExternalRun, SaysWhyAProgramCannotBeRun) {
  const auto complaint_of = [this](const std::string& program) {
    setenv("MPMVV_TEST_MOVER", program.c_str(), 1);
    const std::string message = complaint();
    unsetenv("MPMVV_TEST_MOVER");
    return message;
  };
  EXPECT_THAT(complaint_of("/usr/bin/python3 mover.py"),
              HasSubstr("(a program that can be run: its name alone; arguments"));
  EXPECT_THAT(complaint_of((mover_.folder() / "adapter.toml").string()), HasSubstr("it is not executable, chmod +x)"));
  EXPECT_THAT(complaint_of("/no/mover"), HasSubstr("there is no such file)"));
  EXPECT_THAT(complaint_of("no-mover-of-that-name"), HasSubstr("it is not on PATH)"));
}

}  // namespace mpmvv::codes::external_run_test
