#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "cli/lines.hpp"
#include "studies/store/store.hpp"
#include "studies/store/trial.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_store.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::claims_test {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

/// The small study with claims of its own: one that holds, in words longer than a line, and one that does not.
std::string stated_study() {
  std::string text = small_study;
  text.replace(
      text.find("claims = [\"S-fig10\"]\n"), 21,
      "[[claim]]\nid = \"second\"\nstatement = \"quadratic B-splines are of second order on the bar, in words "
      "enough to fill more than the hundred columns of a line\"\nsource = \"Someone 2020\"\nwhere = \"Fig. 1\"\n"
      "[[claim]]\nid = \"linear\"\nstatement = \"the linear basis is exact\"\n");
  text.replace(text.find("\"S-fig10\""), 9, "\"second\"");
  return text +
         "[[criterion]]\nclaim = \"linear\"\nstatement = \"no error is left\"\nmeasure = \"error\"\nseries = "
         "[\"linear\"]\n"
         "norm = \"l2\"\nwindow = [32, 64]\nat_most = 1e-9\nreason = \"its gradients jump\"\n";
}

class Claims : public testing::Test {
 protected:
  Answer claims(const std::string& arguments = "") { return call(folder_, "claims " + arguments + " --db " + db_); }

  Folder folder_;
  std::string db_ = store_of(folder_, stated_study());
};

TEST_F(Claims, HaveALineEach) {
  const Answer answer = claims();
  EXPECT_THAT(answer.out, MatchesRegex("claim +verdict +hold +statement\n"
                                       "second +confirmed +1 of 1 +quadratic B-splines are of [^\n]*of a line\n"
                                       "linear +refuted +0 of 1 +the linear basis is exact\n"));
  const std::string shown = on_terminal(folder_, 100, "claims --db " + db_);
  EXPECT_THAT(shown, HasSubstr("…\n"));
  std::istringstream lines(shown);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(columns_of(line), 100U) << line;
}

TEST_F(Claims, HaveAPageEach) {
  const Answer page = claims("linear");
  EXPECT_THAT(page.out, StartsWith("linear: refuted\n    the linear basis is exact\n"));
  EXPECT_THAT(page.out, ContainsRegex("study +verdict +asked +found +criterion\n"
                                      "  small +fails +at most 1e-09 +[0-9.]+, [0-9.]+ +no error is left\n"));
  EXPECT_THAT(page.out, AllOf(HasSubstr("why it fails: no error is left\n    its gradients jump\n"),
                              HasSubstr("repeat: mpmvv study small.toml --db "),
                              HasSubstr("small.toml is what `mpmvv db study small --db " + db_ + "` prints\n"),
                              Not(HasSubstr("l2 of"))));
  EXPECT_THAT(claims("linear --verbose").out, HasSubstr("    l2 of 'linear' at cells = 32 = 0.000631\n"));
  const Answer without = claims("--verbose");
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("--verbose without a claim (it is of pages: `mpmvv claims ID --verbose`)"));
  const Answer both = claims("linear second");
  EXPECT_LT(both.out.find("linear: refuted"), both.out.find("second: confirmed"));
  EXPECT_THAT(both.out, HasSubstr("    Someone 2020, Fig. 1\n"));
}

/// The page of a claim with one criterion, as a study left it in a store.
std::string page_of(const records::ClaimPart& part) {
  const Folder folder;
  records::StudyResult study;
  study.name = "s", study.claims = {part.claim}, study.parts = {part};
  store::Store(folder / "r.db", store::Store::Mode::create_or_write).keep_study(study, {}, store::current_provenance());
  return call(folder, "claims --verbose " + part.claim + " --db " + (folder / "r.db")).out;
}

TEST(ClaimsPage, OfNumbersThatLookTheSameHasNoRange) {
  records::ClaimPart part{"C", "near one", records::PartVerdict::holds, "", "", "value", 0.5};
  part.found = {{"a", 1.0000001}, {"b", 1.0000002}, {"c", 1.0000003}};
  EXPECT_THAT(page_of(part), ContainsRegex("at least 0.5 +1 +near one\n"));
}

TEST(ClaimsPage, PartsEvidenceOutsideOfNamesAlone) {
  const records::ClaimPart part{"C", "asked", records::PartVerdict::holds,
                                "l2 of 'a; b' = 1; l2 of 'Euler's; c' = 2; the case's cost = 3", ""};
  EXPECT_THAT(page_of(part),
              HasSubstr("\n    l2 of 'a; b' = 1\n    l2 of 'Euler's; c' = 2\n    the case's cost = 3\n"));
}

TEST(ClaimsOfTheProgram, SayWithoutWhichOfItsStudiesTheyAreJudged) {
  const Folder folder;
  const std::string db = store_of(folder);  // names the claim of a study that comes with the program, s-fig10
  EXPECT_THAT(call(folder, "claims --db " + db).out,
              AllOf(StartsWith("claim    verdict    hold    studies  statement\n"),
                    ContainsRegex("\nS-fig10 +confirmed +1 of 1 +1 of 2 "),
                    HasSubstr("\nstudies: those in the store, of all that judge the claim")));
  EXPECT_THAT(call(folder, "claims S-fig10 --db " + db).out, HasSubstr("judged without s-fig10: not in the store\n"));
  const auto json = call(folder, "claims --json --db " + db).json();
  EXPECT_EQ(json["claims"][0]["studies"], nlohmann::json({"small"}));
  EXPECT_EQ(json["claims"][0]["not_run"], nlohmann::json({"s-fig10"}));
}

/// A file that cannot be read, and a study that only shows figures for the claim, are nothing that it lacks.
TEST(ClaimsOfTheProgram, LackOnlyStudiesThatJudgeThem) {
  const Folder folder;
  const std::string db = store_of(folder), drawn = small_study;
  for (const char* made : {"bin", "share/mpmvv/studies"}) std::filesystem::create_directories(folder / made);
  std::filesystem::copy_file(program(), folder / "bin/mpmvv");
  folder.write("share/mpmvv/studies/quick.txt", "");
  folder.write("share/mpmvv/studies/broken.toml", "[[criterion]]\nclaim = ");
  folder.write("share/mpmvv/studies/drawn.toml", drawn.substr(0, drawn.find("[[criterion]]")));
  folder.write("share/mpmvv/studies/longer.toml", small_study);
  const Answer answer = shell("'" + (folder / "bin/mpmvv") + "' claims --json --db '" + db + "' 2>&1");
  ASSERT_EQ(answer.code, 0) << answer.out;
  EXPECT_EQ(answer.json()["claims"][0]["not_run"], nlohmann::json({"longer"}));
}

TEST_F(Claims, AreRepeatedFromAStoreOfAnyName) {
  const std::string other = folder_ / "my results.db";
  std::filesystem::copy_file(db_, other);
  const std::string page = call(folder_, "claims linear --db '" + other + "'").out;
  const std::string in_one_line = std::regex_replace(page, std::regex("\n +"), " ");
  EXPECT_THAT(in_one_line, AllOf(HasSubstr("repeat: mpmvv study small.toml --db '" + other + "'"),
                                 HasSubstr("`mpmvv db study small --db '" + other + "'` prints")));
}

TEST_F(Claims, AreRepeatedWithTheTrialsValuesAsTheyAre) {
  {
    store::Store store(db_, store::Store::Mode::write);
    records::StudyResult study = store.studies(store::current_provenance().digest).front();
    study.text = store::with_trial(study.text, "variant = it's a 'b' in 1 of 1 series");
    store.keep_study(study, {}, store::current_provenance());
  }
  EXPECT_THAT(claims("linear").out, HasSubstr(R"(--set variant='it'\''s a '\''b'\''')"));
}

TEST_F(Claims, SayWhyTheyAreInconclusive) {
  std::string text = stated_study();
  text.replace(text.find("at_least = 1.5"), 14, "at_least = 1.9");
  const std::string db = folder_ / "open.db";
  const Answer study = call(folder_, "study " + folder_.write("open.toml", text) + " --db " + db);
  const Answer page = call(folder_, "claims second --db " + db);
  for (const std::string& out : {study.out, page.out})
    EXPECT_THAT(out,
                AllOf(ContainsRegex("inconclusive +at least 1.9 +1.969 ± 0.12 +second order\n"),
                      HasSubstr("  why it is inconclusive: second order\n    An interval reaches across a bound: order "
                                "of 'bspline2' in l2 over cells 8 to 64 =")));
}

TEST_F(Claims, ANumberThatIsFoundEverywhereStandsOnce) {
  std::string text = stated_study() +
                     "[[criterion]]\nclaim = \"linear\"\nstatement = \"as its twin\"\nmeasure = \"error-ratio\"\n"
                     "series = [\"linear\"]\nover = \"twin\"\nnorm = \"l2\"\nwindow = [8, 64]\nat_most = 2\n";
  text.insert(text.find("[sweep]"), "[[series]]\nname = \"twin\"\nbasis = \"linear\"\n");
  const Answer study = call(folder_, "study " + folder_.write("twins.toml", text) + " --db " + folder_ / "i.db");
  EXPECT_THAT(study.out, ContainsRegex("holds +at most 2 +1 +as its twin\n")) << study.err;
}

TEST_F(Claims, AndGroundsFitATerminalOf80Columns) {
  const std::string study = "study small.toml --verbose --db " + db_,
                    page = "claims linear second --verbose --db " + db_;
  for (const std::string& arguments : {study, page, "db info --db " + db_}) {
    std::istringstream lines(on_terminal(folder_, 80, arguments));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(columns_of(line), 80U) << arguments << ": " << line;
  }
}

TEST_F(Claims, AndTheStoreFitANarrowTerminal) {
  for (const std::string command : {"claims", "db info"}) {
    std::istringstream lines(on_terminal(folder_, 40, command + " --db " + db_));
    for (std::string line; std::getline(lines, line);) {
      const bool is_word = line.find(' ', line.find_first_not_of(' ')) == std::string::npos;  // as a digest is
      EXPECT_TRUE(columns_of(line) <= 40 || is_word || line.starts_with("file ")) << line;
    }
  }
}

TEST_F(Claims, AreFoundByTheirIdsAlone) {
  const Answer unknown = claims("secnod");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("unknown claim 'secnod': no study of this program in " + db_ +
                                     " names it; did you mean 'second'? (known: second, linear)"));
  const auto json = claims("linear --json").json()["claims"];
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0]["criteria"][0]["at_most"], 1e-9);
  EXPECT_EQ(json[0]["criteria"][0]["found"][0]["value"].is_number(), true);
  EXPECT_THAT(json[0]["criteria"][0]["evidence"].get<std::string>(), HasSubstr("asked: at most 1e-09"));
}

TEST_F(Claims, NeedAResultAsJsonToo) {
  ASSERT_EQ(call(folder_, "db forget small --db " + db_).code, 0);
  for (const char* arguments : {"", "--json", "linear --json"}) {
    const Answer answer = claims(arguments);
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_EQ(answer.err, "mpmvv: " + db_ + " holds no study of this program (run `mpmvv study` first)\n");
    EXPECT_EQ(answer.out, "");
  }
}

/// With a series that blows up at a time step of its own.
TEST_F(Claims, AsJsonSayEachNumberAsTheTableDoes) {
  std::string text = stated_study();
  text.replace(text.find("cfl = 0.3\n"), 10, "");
  for (const char* basis : {"basis = \"linear\"\n", "basis = \"bspline2\"\n"})
    text.insert(text.find(basis), "cfl = 0.3\n");
  for (const char* name : {"wild", "twin"})
    text.insert(text.find("[sweep]"),
                std::string("[[series]]\nname = \"") + name + "\"\nbasis = \"linear\"\ncfl = 5\n");
  text +=
      "[[criterion]]\nclaim = \"linear\"\nstatement = \"none is wild\"\nmeasure = \"error\"\nseries = [\"wild\"]\n"
      "norm = \"l2\"\nwindow = [64, 64]\nat_most = 1\n"
      "[[criterion]]\nclaim = \"linear\"\nstatement = \"as its twin\"\nmeasure = \"error-ratio\"\n"
      "series = [\"wild\"]\nover = \"twin\"\nnorm = \"l2\"\nwindow = [64, 64]\nat_most = 2\n";
  const std::string db = folder_ / "json.db";
  const Answer study = call(folder_, "study " + folder_.write("json.toml", text) + " --db " + db);
  ASSERT_EQ(study.code, 0) << study.err;
  const auto found = [&](const std::string& claim, std::size_t criterion) {
    const auto page = call(folder_, "claims " + claim + " --json --db " + db).json()["claims"][0];
    return page["criteria"][criterion]["found"][0];
  };
  const auto order = found("second", 0), error = found("linear", 0), wild = found("linear", 1),
             both_wild = found("linear", 2);
  EXPECT_EQ(order["text"], "1.969 ± 0.12");
  EXPECT_NEAR(order["half_width"].get<double>(), 0.119062, 1e-6) << "with all digits";
  EXPECT_FALSE(order.contains("infinite"));
  EXPECT_EQ(error["text"], "0.000631");
  EXPECT_FALSE(error.contains("half_width"));
  EXPECT_TRUE(wild["value"].is_null());
  EXPECT_EQ(wild["infinite"], 1);
  EXPECT_EQ(wild["text"], "inf");
  EXPECT_FALSE(wild.contains("remark"));
  EXPECT_EQ(both_wild["text"], "1 (both unstable)");
  EXPECT_EQ(both_wild["remark"], "both unstable");
}

/// One of two ratios of costs is that to a series which never gets there.
TEST_F(Claims, ARemarkStandsBesideTheNumberThatItIsOn) {
  records::StudyResult study;
  study.name = "remarked", study.claims = {"R"};
  const double unknown = support::not_measured;
  records::ClaimPart costs{"R", "cheaper", records::PartVerdict::inconclusive, "", ""};
  costs.measure = "cost-ratio", costs.at_most = 1;
  costs.found = {{"cost at l2 1e-02", 0.5}, {"cost at l2 1e-03", unknown, unknown, unknown, "neither ever reaches it"}};
  records::ClaimPart limit{"R", "stable", records::PartVerdict::holds, "", ""};
  limit.measure = "limit", limit.at_least = 1;
  limit.found = {{"cfl limit of 'a' between 1.28 and 1.333", 1.3065, 1.28, 1.333, "not monotone"}};
  study.parts = {costs, limit};
  const store::Provenance p{own_digest(folder_),   "c0ffee", false, "GNU 12.2.0", "-O3", "Release", "CPU",
                            "2026-01-01T00:00:00Z"};
  store::Store(db_, store::Store::Mode::create_or_write).keep_study(study, {}, p);
  EXPECT_THAT(claims("R").out,
              AllOf(ContainsRegex("at most 1 +0.5 +cheaper .cost at l2 1e-03: neither ever reaches it.\n"),
                    ContainsRegex("at least 1 +1.306 .1.28 to 1.33. +stable .not monotone.\n")));
}

TEST_F(Claims, OfTheProgramAreKnownToStudiesAnywhere) {
  std::string text = small_study;
  text.replace(text.find("[\"S-fig10\"]"), 11, "[\"S-fig10\", \"S-fg11\"]");
  const Answer study = call(folder_, "study " + folder_.write("other.toml", text) + " --db " + db_);
  EXPECT_EQ(study.code, 2);
  EXPECT_THAT(study.err, AllOf(HasSubstr("unknown claim 'S-fg11' in "),
                               HasSubstr("; did you mean 'S-fig11'? (known: S-fig11, "), HasSubstr(" more)\n")));
}

TEST_F(Claims, HaveColoursOnATerminalThatWantsSome) {
  const std::string listing = "'" + program() + "' claims --db '" + db_ + "'";
  const auto on_a_terminal = [&](const std::string& variables) {
    return shell("env -u NO_COLOR " + variables + " SHELL=/bin/sh script -qec \"" + listing + "\" /dev/null").out;
  };
  const std::string green = "\033[32mconfirmed\033[0m", red = "\033[31mrefuted\033[0m";
  EXPECT_THAT(on_a_terminal("TERM=xterm"), AllOf(HasSubstr(green), HasSubstr(red)));
  EXPECT_THAT(on_a_terminal("TERM=xterm NO_COLOR="), HasSubstr(green)) << "empty is not set";
  for (const char* plain : {"TERM=xterm NO_COLOR=1", "TERM=dumb"})
    EXPECT_THAT(on_a_terminal(plain), AllOf(HasSubstr("confirmed"), Not(HasSubstr("\033")))) << plain;
  EXPECT_THAT(claims().out, Not(HasSubstr("\033")));
}

}  // namespace mpmvv::cli::claims_test
