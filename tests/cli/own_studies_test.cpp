#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"
#include "tests/walk.hpp"

/// Studies and goldens in a folder outside the tree, and those that come with the program.
namespace mpmvv::cli::own_studies_test {

using testing::HasSubstr;
using testing::Not;

class OwnStudies : public testing::Test {
 protected:
  /// A line for the shell in the user's folder, which finds the program by its name.
  Answer in_folder(const std::string& lines) const { return carry_out(folder_, lines); }

  std::map<std::string, std::string> verdicts() const {
    std::map<std::string, std::string> verdicts;
    const nlohmann::json answer = in_folder("mpmvv claims --json --db results.db").json();
    for (const auto& claim : answer["claims"]) verdicts[claim["id"]] = claim["verdict"];
    return verdicts;
  }

  const Folder folder_;
};

TEST_F(OwnStudies, TheFirstOneGoesFromAFileToAGateThatPassesInFiveCommands) {
  folder_.write("splines.toml", walk("splines.toml"));
  const auto follow = [&](const std::string& name) {
    const Answer answer = in_folder(walk(name));
    EXPECT_EQ(answer.code, 0) << name << ": " << answer.out << answer.err;
    return answer.out;
  };
  EXPECT_THAT(follow("study"), HasSubstr("10 cases run"));
  follow("report");
  follow("propose");
  EXPECT_EQ(in_folder(walk("gate")).code, 3) << "not reviewed yet";
  follow("review");
  EXPECT_THAT(follow("gate"), HasSubstr("4 pass, 0 fail, 0 inconclusive"));
  EXPECT_EQ(verdicts(),
            (std::map<std::string, std::string>{{"cubic-second", "confirmed"}, {"cubic-better", "refuted"}}));
  const std::string report = read_text(folder_ / "report/index.html");
  EXPECT_THAT(report, HasSubstr("cubic-better"));
  EXPECT_THAT(report, Not(HasSubstr("W-fig3"))) << "nothing of what comes with the program";
}

TEST_F(OwnStudies, AFolderOfThemIsRunAndGatedAlone) {
  std::filesystem::create_directories(folder_ / "mine");
  folder_.write("mine/one.toml", small_study);
  folder_.write("mine/two.toml", small_study);
  const Answer all = in_folder("mpmvv study --studies mine --db results.db");
  EXPECT_THAT(all.out, HasSubstr("8 cases run")) << all.err << "of two studies that are the same";
  EXPECT_THAT(in_folder("mpmvv study two --studies mine --db results.db").out, HasSubstr("0 cases run, 8 taken"));
  for (const char* study : {"one", "two"})
    in_folder(std::string("mpmvv propose --db results.db --goldens bands --out bands/") + study + ".toml --study " +
              study);
  const Answer gate =
      in_folder("sed -i '/^study/a reviewed = \"me\"' bands/*.toml; mpmvv gate --db results.db --goldens bands");
  EXPECT_EQ(gate.code, 0) << gate.out << gate.err;
}

/// The ids of the papers' claims come with the program, and what they say travels in the store.
TEST_F(OwnStudies, NameAClaimOfAPaper) {
  folder_.write("one.toml", small_study);
  ASSERT_EQ(in_folder("mpmvv study one.toml --db results.db").code, 0);
  const nlohmann::json answer = in_folder("mpmvv claims --json --db results.db").json(), &claims = answer["claims"];
  ASSERT_EQ(claims.size(), 1U);
  EXPECT_EQ(claims[0]["source"], "Steffen et al. 2008");
  EXPECT_THAT(claims[0]["statement"].get<std::string>(), HasSubstr("quadratic B-splines are O(h²)"));
}

TEST_F(OwnStudies, SayNothingElseOfAClaimOfTheStore) {
  const std::string claim = "[[claim]]\nid = \"S-fig10\"\nstatement = \"flat\"\n[fixed]";
  std::string other = small_study;
  other.replace(other.find("[fixed]"), 7, claim);
  folder_.write("other.toml", other);
  ASSERT_EQ(in_folder("mpmvv study s-fig10 --plan --db results.db").code, 0);
  folder_.write("first.toml", other.replace(other.find("flat"), 4, "steep"));
  ASSERT_EQ(in_folder("mpmvv study first.toml --db results.db").code, 0);
  const Answer answer = in_folder("mpmvv study other.toml --db results.db");
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("claim 'S-fig10' in other.toml:3 says something else than in study 'first'"));
}

TEST_F(OwnStudies, HaveNoGoldensUntilSomeAreProposed) {
  folder_.write("one.toml", small_study);
  ASSERT_EQ(in_folder("mpmvv study one.toml --db results.db").code, 0);
  const Answer gate = in_folder("mpmvv gate --db results.db");
  EXPECT_EQ(gate.code, 2);
  EXPECT_THAT(gate.err, HasSubstr("`mpmvv propose --db DB --study NAME --out goldens/NAME.toml` writes a first one"));
}

TEST_F(OwnStudies, AreAllThatAProgramKnowsThatStandsAlone) {
  std::filesystem::copy(program(), folder_ / "mpmvv-alone");
  folder_.write("one.toml", small_study);
  EXPECT_THAT(in_folder("./mpmvv-alone study one.toml --db results.db").err, HasSubstr("unknown claim 'S-fig10'"));
  folder_.write("one.toml", std::string(small_study) + "[[claim]]\nid = \"S-fig10\"\nstatement = \"flat\"\n");
  EXPECT_EQ(in_folder("./mpmvv-alone study one.toml --db results.db").code, 0);
  EXPECT_THAT(in_folder("./mpmvv-alone gate --db results.db").err, HasSubstr("no directory 'goldens'"));
}

TEST_F(OwnStudies, AreProposedByAProgramWithChanges) {
  store::Provenance dirty = store::current_provenance();
  dirty.dirty = true;
  records::StudyResult own;
  own.name = "s-jump", own.text = "of one's own", own.values = {{"gap", 1, "a gap"}};
  store::Store(folder_ / "results.db", store::Store::Mode::create_or_write).keep_study(own, {}, dirty);
  const std::string propose = "mpmvv propose --db results.db --study s-jump";
  EXPECT_THAT(in_folder(propose).out, HasSubstr(" with changes that are not committed, digest "));
  own.text = read_text(std::string(MPMVV_SOURCE_DIR) + "/studies/s-jump.toml");
  store::Store(folder_ / "results.db", store::Store::Mode::write).keep_study(own, {}, dirty);
  EXPECT_THAT(in_folder(propose).err, HasSubstr("come from a dirty tree")) << "that study comes with the program";
}

TEST_F(OwnStudies, ThoseOfTheProgramAreThereByName) {
  const Answer study = in_folder("mpmvv study s-jump --db results.db");
  EXPECT_EQ(study.code, 0) << study.err;
  const Answer gate = in_folder("mpmvv gate --only s-jump --db results.db");
  EXPECT_EQ(gate.code, 0) << gate.out << gate.err;
  EXPECT_THAT(in_folder("mpmvv study s-jumpe --db results.db").err,
              HasSubstr("no study 's-jumpe' (did you mean 's-jump'? a study file, or a name of `mpmvv list studies`)"));
  folder_.write("s-jumpe.toml", small_study);
  EXPECT_THAT(in_folder("mpmvv study s-jumpe --db results.db").err, HasSubstr("(did you mean 's-jumpe.toml'? "));
  EXPECT_THAT(in_folder("mpmvv study s-jump.tom --db results.db").err, HasSubstr("no study 's-jump.tom'"));
}

TEST_F(OwnStudies, AreNoFoldersOfTheirNames) {
  for (const char* folder : {"s-jump", "s-jumpe", "s-jumpe.toml"})
    std::filesystem::create_directories(folder_ / folder);
  const Answer study = in_folder("mpmvv study s-jump --db results.db");
  EXPECT_EQ(study.code, 0) << study.err;
  EXPECT_THAT(in_folder("mpmvv study s-jumpe --db results.db").err, HasSubstr("(did you mean 's-jump'? "));
  folder_.write("s-jumpe/one.toml", "");
  for (const char* name : {"s-jumpe", "s-jumpe/"})
    EXPECT_THAT(in_folder(std::string("mpmvv study --db results.db ") + name).err,
                HasSubstr(std::string("'") + name + "' is a folder (its studies: --studies " + name + ")"));
}

TEST_F(OwnStudies, AreCostedBeforeTheCasesOfTheProgram) {
  const std::string theirs = read_text(std::string(MPMVV_SOURCE_DIR) + "/studies/cost.txt");
  const auto first = theirs.find("\n--problem") + 1;
  const std::string mine = "--problem bar --basis linear --integrator cd --cells 8 --ppc 1 --cfl 0.2 --steps 4";
  std::filesystem::permissions(folder_.write("other", "#!/bin/sh\n[ $1 = --version ] && echo mpmvv c0ffee\n"),
                               std::filesystem::perms::owner_all);
  EXPECT_THAT(in_folder("mpmvv cost other").err,
              HasSubstr(", '" + theirs.substr(first, theirs.find('\n', first) - first)));
  std::filesystem::create_directories(folder_ / "studies");
  folder_.write("studies/cost.txt", mine);
  EXPECT_THAT(in_folder("mpmvv cost other").err,
              HasSubstr("does not carry out the case in studies/cost.txt:1, '" + mine));
}

TEST_F(OwnStudies, AreListedWithTheirTitlesAndClaims) {
  folder_.write("one.toml", small_study);
  const nlohmann::json own = in_folder("mpmvv list studies --studies . --json").json(), &studies = own["studies"];
  ASSERT_EQ(studies.size(), 1U);
  EXPECT_EQ(studies[0], (nlohmann::json{{"name", "one"}, {"title", "Small"}, {"claims", {"S-fig10"}}}));
  EXPECT_THAT(in_folder("mpmvv list studies").out, HasSubstr("Bar: convergence with linear and quadratic basis"));
  EXPECT_THAT(in_folder("mpmvv list studies --studies absent").err, HasSubstr("cannot read --studies absent: No"));
  EXPECT_THAT(in_folder("mpmvv list bases --studies .").err, HasSubstr("--studies without studies"));
}

TEST_F(OwnStudies, AreToBeNamedAndThere) {
  EXPECT_THAT(in_folder("mpmvv study --db results.db").err, HasSubstr("no study named (study files, names of"));
  EXPECT_THAT(in_folder("mpmvv study --studies . --db results.db").err, HasSubstr("no study file in --studies ."));
  EXPECT_THAT(in_folder("mpmvv list studies --studies .").err, HasSubstr("no study file in --studies ."));
  const std::string long_name(300, 'x');
  folder_.write("file", "");
  for (const auto& [folder, why] : {std::pair<std::string, std::string>{"absent", "No such file or directory"},
                                    {"file", "Not a directory"},
                                    {long_name, "File name too long"}})
    for (const std::string command : {"study --db results.db", "list studies"})
      EXPECT_EQ(in_folder("mpmvv " + command + " --studies " + folder).err,
                "mpmvv: cannot read --studies " + folder + ": " + why + " (a folder with *.toml)\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "results.db"));
}

}  // namespace mpmvv::cli::own_studies_test
