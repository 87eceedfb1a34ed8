#include "reports/report_place.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <map>
#include <thread>

#include "reports/report.hpp"
#include "studies/support/error.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports::report_place_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

void silent(const std::string&) {}

/// A report whose figures and page bear this label.
ReportInput input(const std::string& label) {
  ReportInput in;
  in.studies = {synthetic::limits(), synthetic::check()};
  in.studies[0].title = in.studies[1].title = "Studies of " + label;
  in.studies[0].figures.push_back(in.studies[1].figures[0]);
  in.studies[0].figures[0].name = "limits";
  in.studies[0].figures[0].xlabel = in.studies[1].figures[0].xlabel = label;
  return in;
}

std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder)] = content_without_date(entry.path());
  return files;
}

std::string refusal(const std::string& label, const fs::path& out) {
  try {
    write_report(input(label), out, silent);
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "no error";
}

TEST(ReportPlace, AFailedReportLeavesTheOldOneWhole) {
  const TempFolder folder;
  write_report(input("old"), folder / "out", silent);
  const auto before = files_of(folder / "out");
  pretend_gnuplot(folder / "bin", "echo broken >&2; exit 3");
  {
    const PathVariable path((folder / "bin").string() + ":/bin:/usr/bin");
    EXPECT_THAT(refusal("new", folder / "out"), HasSubstr("ended with code 3: broken"));
    EXPECT_EQ(files_of(folder / "out"), before);
    EXPECT_THAT(refusal("new", folder / "a/b/first"), HasSubstr("broken"));
    EXPECT_FALSE(fs::exists(folder / "a")) << "a first report that fails leaves nothing";
  }
}

TEST(ReportPlace, AFolderInTheWayIsNamedAndNothingIsChanged) {
  const TempFolder folder;
  write_report(input("old"), folder / "out", silent);
  fs::remove(folder / "out/figures/limits.pdf");
  fs::create_directories(folder / "out/figures/limits.pdf/mine");
  const auto before = files_of(folder / "out");
  EXPECT_THAT(refusal("new", folder / "out"), HasSubstr("figures/limits.pdf is a folder where the report has a file"));
  EXPECT_EQ(files_of(folder / "out"), before);
}

TEST(ReportPlace, AKilledReportLeavesTheOldOneWhole) {
  const TempFolder folder;
  write_report(input("old"), folder / "out", silent);
  const auto before = files_of(folder / "out");
  pretend_gnuplot(folder / "bin", "kill -9 $PPID");
  const pid_t child = fork();
  if (child == 0) {
    setenv("PATH", ((folder / "bin").string() + ":/bin:/usr/bin").c_str(), 1);
    refusal("new", folder / "out");
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  for (const auto& [file, text] : before) EXPECT_EQ(content_without_date(folder / "out" / file), text) << file;
  write_report(input("new"), folder / "out", silent);
  write_report(input("new"), folder / "fresh", silent);
  EXPECT_EQ(files_of(folder / "out"), files_of(folder / "fresh")) << "nothing of the killed one is left";
}

TEST(ReportPlace, WhatWasCutOffWhileItTookItsPlaceIsPutThere) {
  const TempFolder folder;
  write_report(input("old"), folder / "out", silent);
  write_report(input("new"), folder / "new", silent);
  const auto whole = files_of(folder / "new");
  fs::rename(folder / "new", folder / "out/.report-taking-its-place");
  fs::rename(folder / "out/.report-taking-its-place/figures/limits.svg", folder / "out/figures/limits.svg");
  const PathVariable path(folder.path().string());
  EXPECT_THAT(refusal("third", folder / "out"), HasSubstr("gnuplot is not on the PATH"));
  EXPECT_EQ(files_of(folder / "out"), whole);
}

TEST(ReportPlace, WhatIsNotTheReportsStaysAndALinkLeadsThere) {
  const TempFolder folder;
  fs::create_directories(folder / "real/figures/mine");
  fs::create_symlink("nowhere", folder / "real/figures/link");
  std::ofstream(folder / "real/notes.txt") << "mine";
  std::ofstream(folder / "real/figures/mine/notes.svg") << "mine";
  fs::create_directory_symlink(folder / "real", folder / "out");
  for (const char* label : {"old", "new"}) write_report(input(label), folder / "out", silent);
  EXPECT_TRUE(fs::is_symlink(folder / "out"));
  EXPECT_TRUE(fs::is_symlink(folder / "real/figures/link"));
  EXPECT_EQ(content(folder / "real/notes.txt"), "mine");
  EXPECT_EQ(content(folder / "real/figures/mine/notes.svg"), "mine");
  EXPECT_THAT(content(folder / "real/index.html"),
              AllOf(HasSubstr("Studies of new"), Not(HasSubstr("Studies of old"))));
}

TEST(ReportPlace, WhatAnEarlierReportWroteAloneGoesAwayAndNothingElse) {
  const TempFolder folder;
  ReportInput more = input("any"), fewer = input("any");
  fewer.studies.pop_back();
  more.claims = {{"S-fig4", "a sentence", "", "", claims::Claim::Verdict::open, "", {}, {}}};
  write_report(more, folder / "out", silent);
  ASSERT_TRUE(fs::exists(folder / "out/studies/weights.html"));
  std::ofstream(folder / "out/studies/mine.html") << "mine";
  std::ofstream(folder / "outside.html") << "mine";
  std::ofstream(folder / "out/.report-files", std::ios::app) << "../outside.html\n"
                                                             << (folder / "outside.html").string();
  write_report(fewer, folder / "out", silent);
  EXPECT_EQ(content(folder / "out/studies/mine.html"), "mine");
  EXPECT_TRUE(fs::exists(folder / "outside.html"));
  fs::remove(folder / "out/studies/mine.html");
  write_report(fewer, folder / "fresh", silent);
  EXPECT_EQ(files_of(folder / "out"), files_of(folder / "fresh"));
}

TEST(ReportPlace, APageOfAnotherHandIsNotOverwritten) {
  const TempFolder folder;
  for (const char* page : {"index.html", "style.css"}) {
    fs::create_directories(folder / "site");
    std::ofstream(folder / "site" / page) << "mine";
    EXPECT_THAT(refusal("new", folder / "site"), AllOf(HasSubstr(page), HasSubstr(" is of no report and would be")));
    EXPECT_EQ(files_of(folder / "site"), (std::map<std::string, std::string>{{page, "mine"}}));
    fs::remove_all(folder / "site");
  }
  write_report(input("old"), folder / "out", silent);
  fs::remove(folder / "out/.report-files");
  EXPECT_EQ(refusal("new", folder / "out"), "no error") << "a report from before there was a list";
}

TEST(ReportPlace, OfTwoReportsAtOnceTheLastOneStandsWhole) {
  const TempFolder folder;
  std::map<std::string, std::map<std::string, std::string>> alone;
  for (const char* label : {"one", "two"}) {
    write_report(input(label), folder / label, silent);
    alone[label] = files_of(folder / label);
  }
  {
    const std::jthread one([&] { EXPECT_EQ(refusal("one", folder / "out"), "no error"); });
    const std::jthread two([&] { EXPECT_EQ(refusal("two", folder / "out"), "no error"); });
  }
  EXPECT_THAT(files_of(folder / "out"), testing::AnyOf(alone["one"], alone["two"]));
}

}  // namespace mpmvv::reports::report_place_test
