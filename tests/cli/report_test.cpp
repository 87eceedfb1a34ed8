#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "studies/store/store.hpp"
#include "studies/store/trial.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_store.hpp"
#include "tests/cli/small_study.hpp"

/// What the command gathers for a report beside the results themselves.
namespace mpmvv::cli::report_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string between(const std::string& text, const std::string& start, const std::string& end) {
  const auto at = text.find(start) + start.size();
  return text.substr(at, text.find(end, at) - at);
}

class ReportCommand : public testing::Test {
 protected:
  Answer report(const std::string& options = "") const {
    return call(folder_, "report --db " + db_ + " --out " + (folder_ / "report") + " " + options,
                "cd '" + (folder_ / "") + "' && ");
  }
  std::string page(const std::string& file) const { return read_text(folder_ / ("report/" + file)); }

  const Folder folder_;
  const std::string db_ = folder_ / "r.db";
};

TEST_F(ReportCommand, WritesPagesAndTheirFiguresOnce) {
  store_of(folder_);
  const Answer first = report();
  ASSERT_EQ(first.code, 0) << first.err;
  for (const char* name :
       {"index.html", "gate.html", "studies/small.html", "claims/S-fig10.html", "style.css", "report.js",
        "figures/small.svg", "figures/small.pdf", "figures/small.gp", "figures/small.dat", "tables/small.tex"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / (std::string("report/") + name))) << name;
  EXPECT_THAT(report().out, HasSubstr("(0 drawn)"));
}

/// What the report's script says of a figure's points.
nlohmann::json points_in(const std::string& script) {
  return nlohmann::json::parse(between(script, "tellPoints(\"figure-small\", ", ");\n"));
}

TEST_F(ReportCommand, SaysHowToRepeatEveryPoint) {
  store_of(folder_);
  ASSERT_EQ(report().code, 0);
  for (const char* file : {"studies/small.html", "claims/S-fig10.html"})
    EXPECT_THAT(page(file), HasSubstr("<script src=\"../points/small.js\" defer></script>")) << file;
  EXPECT_THAT(page("studies/small.html"), Not(HasSubstr("()</p>"))) << "a note that there is none of";
  const nlohmann::json points = points_in(page("points/small.js"));
  EXPECT_EQ(points["key"], "cells");
  ASSERT_EQ(points["series"].size(), 2u);
  for (const auto& series : points["series"]) {
    ASSERT_EQ(series["points"].size(), 4u);
    const auto& last = series["points"][3];
    std::string command = series["command"];
    command = command.substr(std::string("mpmvv ").size());
    command.replace(command.find("{}"), 2, last[2].get<std::string>());
    const double again = call(folder_, command + " --json").json()["error"]["l2"];
    EXPECT_NEAR(std::stod(last[3].get<std::string>()), again, 1e-3 * again) << command;
  }
}

TEST_F(ReportCommand, CommandsNameWordsFlagsParametersAndReplicates) {
  const std::string file = folder_.write("r.toml", R"(title = "Replicates"
[fixed]
problem = "bar"
param = { amplitude = 0.02 }
boundary = "xmin=periodic,xmax=periodic"
ppc = 2
cfl = 0.3
every_step = true
[[series]]
name = "a"
basis = "bspline2"
[sweep]
cells = [8, 16]
[replicates]
grid_offset = [0.25, 0.5]
)");
  ASSERT_EQ(call(folder_, "study " + file + " --db " + db_).code, 0);
  ASSERT_EQ(report().code, 0);
  EXPECT_THAT(page("studies/r.html"),
              AllOf(HasSubstr("mpmvv run --problem bar --param amplitude=0.02 --boundary xmin=periodic,xmax=periodic "
                              "--ppc 2 --cfl 0.3 --every-step --basis bspline2 --grid-offset 0.25 --cells 16"),
                    HasSubstr("the first of 2 replicates")));
}

/// Searches of limits probe the whole body, where a run would take a part of it.
TEST_F(ReportCommand, ALimitsCommandRunsTheWholeBody) {
  const std::string file = folder_.write("l.toml", R"(title = "limit"
[fixed]
problem = "ring"
cells = 4
ppc = 2
steps = 8
[[series]]
name = "a"
basis = "bspline2"
[[series]]
name = "b"
basis = "bspline2"
mass = "consistent"
integrator = "usl"
[limit]
key = "cfl"
from = 0.4
to = 0.5
)");
  const Answer study = call(folder_, "study " + file + " --db " + db_);
  ASSERT_EQ(study.code, 0) << study.err;
  ASSERT_EQ(report().code, 0);
  EXPECT_THAT(page("studies/l.html"),
              AllOf(HasSubstr("--basis bspline2 --cfl 0.5 --whole"),
                    HasSubstr("--basis bspline2 --mass consistent --integrator usl --cfl 0.5<")));
}

/// The commands of runs that stand on a study's page.
std::vector<std::string> run_commands(const std::string& page) {
  static const std::regex command("<code>mpmvv (run [^<]*)</code>");
  std::vector<std::string> commands;
  for (std::sregex_iterator it(page.begin(), page.end(), command), end; it != end; ++it) commands.push_back((*it)[1]);
  return commands;
}

/// The number of cells of the search is none for the sweep, and the CFL number of the sweep none for the search.
/// Nothing that is searched here is stable.
TEST_F(ReportCommand, ASweepAndASearchHaveACommandEach) {
  const std::string file = folder_.write("both.toml", R"(title = "A sweep and a limit"
[fixed]
problem = "bar"
integrator = "cd"
boundary = "periodic"
cells = 64
ppc = 2
cfl = 0.2
[[series]]
name = "a"
basis = "bspline2"
[sweep]
cells = [8, 16]
[limit]
key = "cfl"
from = 4
to = 5
[[figure]]
caption = "Errors"
xlabel = "cells"
ylabel = "error"
)");
  const Answer study = call(folder_, "study " + file + " --db " + db_);
  ASSERT_EQ(study.code, 0) << study.err;
  ASSERT_EQ(report().code, 0);
  const auto commands = run_commands(page("studies/both.html"));
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_THAT(commands[0], AllOf(HasSubstr("--cfl 0.2 --basis bspline2 --cells 16"), Not(HasSubstr("--cells 64"))));
  EXPECT_THAT(commands[1], AllOf(HasSubstr("--cells 64 --ppc 2 --basis bspline2 --cfl "), Not(HasSubstr("--cfl 0.2"))));
  for (const auto& [command, status] : {std::pair{commands[0], "ok"}, {commands[1], "unstable"}}) {
    const Answer run = call(folder_, command + " --json");
    ASSERT_EQ(run.code, 0) << command << ": " << run.err;
    EXPECT_EQ(run.json()["status"], status) << command;
  }
  EXPECT_THAT(page("points/both.js"), AllOf(HasSubstr("--cells {}"), Not(HasSubstr("--cfl {}"))));
  EXPECT_THAT(page("points/both-map.js"), AllOf(HasSubstr("--cfl {}"), Not(HasSubstr("--cells {}"))));
}

/// A store with studies of one's own alone: the goldens that it has nothing for are a line, and no verdict.
TEST_F(ReportCommand, OfOwnStudiesIsAboutThese) {
  store_of(folder_);
  ASSERT_EQ(report("--goldens '" MPMVV_SOURCE_DIR "/goldens'").code, 0);
  const std::string front = page("index.html");
  EXPECT_THAT(front,
              AllOf(HasSubstr("<title>mpmvv: not judged</title>"), HasSubstr("that this report has no result of"),
                    HasSubstr("data-id=\"S-fig10\""), Not(HasSubstr("data-id=\"S-fig9\""))));
  EXPECT_LT(front.size(), 20'000u);
  EXPECT_THAT(page("studies/small.html"), HasSubstr("<code>mpmvv study small.toml --db results.db</code>"));
  EXPECT_THAT(page("gate.html"), Not(HasSubstr("<tr><th scope=\"row\">order of")));
}

/// The commands of page and claim bring the same study once more, a trial with what it was tried with.
TEST_F(ReportCommand, RepeatsAStudyOfTheProgramByItsNameAndATrialAsOne) {
  const std::string file = folder_.write("small.toml", small_study);
  ASSERT_EQ(call(folder_, "study s-jump --db " + db_).code, 0);
  ASSERT_EQ(call(folder_, "study " + file + " --set shuffle=3 --set ppc=2 --db " + db_).code, 0);
  ASSERT_EQ(report().code, 0);
  for (const char* on : {"studies/s-jump.html", "claims/S-jump.html"})
    EXPECT_THAT(page(on), HasSubstr("<code>mpmvv study s-jump --db results.db</code>")) << on;
  for (const char* on : {"studies/small.html", "claims/S-fig10.html"})
    EXPECT_THAT(page(on), HasSubstr("<code>mpmvv study small.toml --set shuffle=3 --set ppc=2 --db trial.db</code>"))
        << on;
  EXPECT_THAT(call(folder_, "claims S-jump --db " + db_).out, HasSubstr("repeat: mpmvv study s-jump --db " + db_));
  const Answer trial = call(folder_, "claims S-fig10 --db " + db_);
  const std::string command = between(trial.out, "repeat: mpmvv ", "\n");
  EXPECT_EQ(command, "study small.toml --set shuffle=3 --set ppc=2 --db " + db_);
  EXPECT_THAT(call(folder_, command, "cd '" + (folder_ / "") + "' && ").out, HasSubstr("0 cases run, 8 taken from"));
}

/// As the store of ./run codes has them.
TEST_F(ReportCommand, RepeatsAStudyOfAnAdapterFromItsFolder) {
  std::filesystem::create_directories(folder_ / "adapters/mine/studies");
  folder_.write("adapters/mine/studies/small.toml", small_study);
  const std::string here = "cd '" + (folder_ / "") + "' && ", study = "study adapters/mine/studies/small.toml --db ";
  ASSERT_EQ(call(folder_, study + db_, here).code, 0);
  EXPECT_THAT(call(folder_, "claims S-fig10 --db " + db_, here).out, HasSubstr("repeat: mpmvv " + study + db_));
}

TEST_F(ReportCommand, SaysWhatChangedSinceTheVersionBefore) {
  store_of(folder_);
  {
    store::Store store(db_, store::Store::Mode::write);
    store::Provenance earlier = store::current_provenance();
    auto study = store.studies(earlier.digest).at(0);
    study.series[1].orders[0].order += 0.5;
    study.parts.at(0).verdict = records::PartVerdict::fails;
    for (auto& series : study.series) series.points.clear();
    study.values = {{"gap", 1, "a gap"}};
    earlier.digest = "00ff", earlier.commit = "c0ffee0123456789", earlier.time = "2001-01-01T00:00:00Z";
    earlier.dirty = true;
    store.keep_study(study, {{}, {}}, earlier);
    study.name = "elsewhere", study.claims.clear(), study.parts.clear();
    store.keep_study(study, {{}, {}}, earlier);
  }
  ASSERT_EQ(report().code, 0);
  EXPECT_THAT(page("index.html"),
              AllOf(HasSubstr("results differ from c0ffee012345-dirty"), HasSubstr(", 1 without a result"),
                    HasSubstr("small: value &apos;gap&apos;: no result"),
                    HasSubstr("small: order of &apos;bspline2&apos; in l2 over [8, 64]: "),
                    HasSubstr("small: criterion of S-fig10: second order: fails -&gt; holds"),
                    HasSubstr("claim S-fig10: "), Not(HasSubstr(": claim S-fig10"))));
}

/// A study of a series that another code ran and of one of ours, and the goldens of both.
records::StudyResult study_of_another_code() {
  records::StudyResult study;
  study.name = "theirs";
  study.kind = records::StudyKind::convergence;
  study.sweep = "cells";
  for (const char* name : {"theirs", "ours"})
    study.series.push_back({name, {{8, records::Status::ok, "", {{"l2", 1e-2}}}}, {}, {}});
  study.series[0].code = records::OtherCode{"my-code", "1.3", "", "reference", "aa11"};
  return study;
}

void write_goldens(const Folder& folder, const records::StudyResult& study) {
  std::filesystem::create_directories(folder / "goldens");
  std::string text = "reviewed = \"now\"\nstudy = \"" + study.name + "\"\n";
  for (const records::Series& series : study.series)
    text += "[[status]]\nseries = \"" + series.name + "\"\nat = 8\nexpected = \"ok\"\n";
  folder.write("goldens/" + study.name + ".toml", text);
}

/// A golden of another code's series counts in both, that of a trial in neither.
TEST_F(ReportCommand, ComparesTheGateOfTwoVersionsByTheSameGoldens) {
  const records::StudyResult study = study_of_another_code();
  records::StudyResult trial = study;
  trial.name = "tried", trial.text = store::with_trial("", "ppc = 4 in 1 of 1 series");
  trial.series.erase(trial.series.begin());
  const store::Provenance now = store::current_provenance();
  store::Provenance then = now;
  then.digest = "00ff", then.commit = "c0ffee0123456789", then.time = "2001-01-01T00:00:00Z";
  {
    store::Store store(db_, store::Store::Mode::create_or_write);
    store.keep_study(study, {}, then);
    for (const auto& kept : {study, trial}) store.keep_study(kept, {}, now);
  }
  for (const auto& judged : {study, trial}) write_goldens(folder_, judged);
  const Answer answer = report("--goldens " + (folder_ / "goldens"));
  ASSERT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(page("index.html"), HasSubstr("goldens: 1 inconclusive, 2 pass</span> <span class=\"change\">Since the "
                                            "version before: as before (2 of 3 compared)</span>"));
}

}  // namespace mpmvv::cli::report_test
