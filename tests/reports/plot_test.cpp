#include "reports/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <map>
#include <thread>

#include "studies/support/error.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports::plot_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::vector<Plot> plots(const records::StudyResult& study) {
  std::vector<Plot> result;
  for (const auto& chart : charts_of(study)) result.push_back(plot_of(chart));
  return result;
}

std::string message(const std::vector<Plot>& drawn, const fs::path& folder,
                    std::chrono::milliseconds limit = std::chrono::seconds(60)) {
  try {
    draw(drawn, folder, limit);
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Plot, DrawsSvgAndPdf) {
  const TempFolder folder;
  EXPECT_EQ(draw(plots(synthetic::convergence()), folder.path()), 1);
  EXPECT_THAT(content(folder / "s-fig10.svg"), AllOf(HasSubstr("</svg>"), HasSubstr("2.01 ± 0.03")));
  EXPECT_THAT(content(folder / "s-fig10.pdf"), testing::StartsWith("%PDF"));
  EXPECT_FALSE(fs::exists(folder / "s-fig10.gp.part"));
}

TEST(Plot, DataHasSeventeenDigits) {
  auto study = synthetic::convergence();
  study.series[1].points[3].y["l2"] = 1.0 / 3;
  EXPECT_THAT(plots(study)[0].data, HasSubstr("64 0.33333333333333331 0.33333333333333331 1\n"));
}

TEST(Plot, RedrawsOnlyWhatChanged) {
  const TempFolder folder;
  auto study = synthetic::convergence();
  study.figures.push_back(study.figures[0]);
  study.figures[1].name = "second";
  study.figures[1].quantity = "linf";
  EXPECT_EQ(draw(plots(study), folder.path()), 2);
  const auto drawn_at = fs::last_write_time(folder / "second.svg");
  EXPECT_EQ(draw(plots(study), folder.path()), 0);
  study.series[1].points[3].y["l2"] *= 1.0000001;
  EXPECT_EQ(draw(plots(study), folder.path()), 1);
  EXPECT_EQ(fs::last_write_time(folder / "second.svg"), drawn_at);
  fs::remove(folder / "second.pdf");
  EXPECT_EQ(draw(plots(study), folder.path()), 1);
  EXPECT_TRUE(fs::exists(folder / "second.pdf"));
}

TEST(Plot, NothingToDrawNeedsNoGnuplot) {
  const TempFolder folder;
  draw(plots(synthetic::check()), folder.path());
  const PathVariable path(folder.path().string());
  EXPECT_EQ(draw(plots(synthetic::check()), folder.path()), 0);
}

TEST(Plot, PicturesAreReproducible) {
  const TempFolder folder;
  fs::create_directories(folder / "a");
  fs::create_directories(folder / "b");
  draw(plots(synthetic::limits()), folder / "a");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // dates in pictures have seconds
  draw(plots(synthetic::limits()), folder / "b");
  for (const char* file : {"bar-cfl-map.svg", "bar-cfl-map.pdf"})
    EXPECT_TRUE(content_without_date(folder / "a" / file) == content_without_date(folder / "b" / file)) << file;
}

TEST(Plot, MissingGnuplotIsNamed) {
  const TempFolder folder;
  const PathVariable path(folder.path().string());
  EXPECT_EQ(message(plots(synthetic::check()), folder.path()),
            "cannot draw figure 's-fig4': gnuplot is not on the PATH; install it with: apt-get install gnuplot-nox");
}

TEST(Plot, BadScriptIsReportedWithGnuplotsLastLineAndTriedAgain) {
  const TempFolder folder;
  const auto drawn = plots(synthetic::check());
  const std::vector<Plot> bad{drawn[0], {"broken", "set nonsense\n", ""}};
  EXPECT_THAT(message(bad, folder.path()),
              AllOf(HasSubstr("cannot draw figure 'broken'"), HasSubstr("ended with code 1"), HasSubstr("line 1")));
  EXPECT_FALSE(fs::exists(folder / "broken.gp"));
  EXPECT_THAT(message(bad, folder.path()), HasSubstr("broken"));
}

TEST(Plot, GnuplotThatDrawsNothingIsReported) {
  const TempFolder folder;
  pretend_gnuplot(folder / "bin", "echo 'unknown terminal' >&2; exit 0");
  const PathVariable path((folder / "bin").string() + ":/bin:/usr/bin");
  EXPECT_THAT(message(plots(synthetic::check()), folder.path()),
              AllOf(HasSubstr("figure 's-fig4'"), HasSubstr("left a picture out"), HasSubstr("unknown terminal")));
}

TEST(Plot, GnuplotThatHangsIsStopped) {
  const TempFolder folder;
  pretend_gnuplot(folder / "bin", "sleep 60");
  const PathVariable path((folder / "bin").string() + ":/bin:/usr/bin");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(message(plots(synthetic::check()), folder.path(), std::chrono::milliseconds(200)),
              HasSubstr("still running after 0.2 s"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Plot, ManyFiguresHaveMoreTime) {
  const TempFolder folder;
  pretend_gnuplot(folder / "bin", "sleep 60");
  const PathVariable path((folder / "bin").string() + ":/bin:/usr/bin");
  std::vector<Plot> many(21, plots(synthetic::check())[0]);
  for (std::size_t k = 0; k < many.size(); ++k) many[k].name = "figure-" + std::to_string(k);
  EXPECT_THAT(message(many, folder.path(), std::chrono::milliseconds(100)), HasSubstr("still running after 0.3 s"));
}

TEST(Plot, GnuplotThatDiesIsReported) {
  const TempFolder folder;
  pretend_gnuplot(folder / "bin", "kill -9 $$");
  const PathVariable path((folder / "bin").string() + ":/bin:/usr/bin");
  EXPECT_THAT(message(plots(synthetic::check()), folder.path()), HasSubstr("ended with code 137"));
}

TEST(Plot, TheUsersEnvironmentDecidesNothing) {
  const TempFolder folder;
  fs::create_directories(folder / "a");
  fs::create_directories(folder / "b");
  std::ofstream(folder / ".gnuplot") << "exit status 7\n";
  draw(plots(synthetic::check()), folder / "a");
  std::map<std::string, std::string> strange{{"GNUTERM", "qt"}, {"GNUPLOT_LIB", "/"},          {"GDFONTPATH", "/"},
                                             {"LANG", "x"},     {"LC_NUMERIC", "de_DE.UTF-8"}, {"HOME", folder.path()}};
  for (auto& [name, value] : strange) {
    const char* before = std::getenv(name.c_str());
    const std::string old = before ? before : "";
    setenv(name.c_str(), value.c_str(), 1);
    value = old;
  }
  EXPECT_EQ(message(plots(synthetic::check()), folder / "b"), "no error");
  for (const auto& [name, value] : strange)
    value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
  for (const char* file : {"s-fig4.svg", "s-fig4.pdf"})
    EXPECT_TRUE(content_without_date(folder / "a" / file) == content_without_date(folder / "b" / file)) << file;
}

TEST(Plot, PicturesThatAreCutOffAreNotTaken) {
  const TempFolder folder;
  pretend_gnuplot(folder / "bin", "printf '<svg' > s-fig4.svg; printf '%%PDF' > s-fig4.pdf");
  const PathVariable path((folder / "bin").string() + ":/bin:/usr/bin");
  EXPECT_THAT(message(plots(synthetic::check()), folder.path()),
              AllOf(HasSubstr("left a picture out"), Not(HasSubstr("install"))));
}

TEST(Plot, AFullDiskIsNamed) {
  const TempFolder folder;
  const auto drawn = plots(synthetic::convergence());
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{8000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string said = message(drawn, folder.path());
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(said,
              AllOf(HasSubstr("cannot write"), HasSubstr("s-fig10.svg (File too large)"), Not(HasSubstr("install"))));
}

TEST(Plot, OldPicturesDoNotSurviveAFailure) {
  const TempFolder folder;
  auto study = synthetic::check();
  draw(plots(study), folder.path());
  study.figures[0].xlabel = "another";
  {
    const PathVariable path(folder.path().string());
    EXPECT_THAT(message(plots(study), folder.path()), HasSubstr("gnuplot is not on the PATH"));
  }
  EXPECT_EQ(draw(plots(study), folder.path()), 1);
}

TEST(Plot, TextIsDrawnAsItIsWritten) {
  const TempFolder folder;
  auto study = synthetic::check();
  study.series[0].name = "it's `date` \"q\" a_b^{2} <i>\\n\n@x";
  study.figures[0].xlabel = "l_p^0 & 'h'";
  draw(plots(study), folder.path());
  const auto svg = content(folder / "s-fig4.svg");
  EXPECT_THAT(svg, HasSubstr("a_b^{2}"));
  EXPECT_THAT(svg, HasSubstr("`date`"));
  EXPECT_THAT(svg, HasSubstr("&lt;i"));
  EXPECT_THAT(svg, HasSubstr("l_p^0"));
  EXPECT_THAT(svg, testing::Not(HasSubstr("<i>")));
}

TEST(Plot, ALabelLongerThanItsAxisStandsInTwoLines) {
  auto study = synthetic::check();
  study.figures[0].ylabel = "the velocity's error, in % of the problem's speed, as the mean of all of its particles";
  const Plot plot = plots(study)[0];
  EXPECT_THAT(plot.script, HasSubstr("\"the velocity\\047s error, in % of the problem\\047s\".\"\\n\".\"speed, as"));
  const TempFolder folder;
  draw({plot}, folder.path());
  EXPECT_THAT(content(folder / "s-fig4.svg"), HasSubstr("as the mean of all of its particles</text>"));
  EXPECT_THAT(plot.script, HasSubstr("particles\" noenhanced offset 0,0\n"));
  study.figures[0].ylabel += ", each of which counts once, whatever its mass is, and wherever it lies";
  EXPECT_THAT(plots(study)[0].script, HasSubstr("\" noenhanced offset -1.5,0\n")) << "four lines, clear of the tics";
}

TEST(Plot, StudyWithoutAnyPointIsStillDrawn) {
  const TempFolder folder;
  auto study = synthetic::check();
  for (auto& s : study.series) s.points.clear();
  EXPECT_EQ(draw(plots(study), folder.path()), 1);
  EXPECT_THAT(content(folder / "s-fig4.svg"), HasSubstr("nothing to draw"));
}

TEST(Plot, StudyWithoutAnyValueIsStillDrawn) {
  const TempFolder folder;
  auto study = synthetic::convergence();
  study.figures[0].quantity = "unknown";
  for (auto& s : study.series)
    for (auto& p : s.points) p.status = records::Status::ok;
  EXPECT_EQ(draw(plots(study), folder.path()), 1);
}

}  // namespace mpmvv::reports::plot_test
