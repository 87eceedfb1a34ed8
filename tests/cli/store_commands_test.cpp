#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "studies/store/provenance.hpp"
#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_store.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::store_commands_test {

using testing::HasSubstr;
using testing::MatchesRegex;

TEST(GateCommand, DoesNotPassWhatIsNotAsItWasWritten) {
  const Folder folder;
  const std::string db = store_of(folder);
  std::filesystem::create_directories(folder / "goldens");
  folder.write("goldens/small.toml",
               "study = \"small\"\nreviewed = \"by hand\"\n[[order]]\nseries = \"bspline2\"\nnorm = \"l2\"\n"
               "expected = 2\nlower = -8\nupper = 8\nwhy = \"any\"\n");
  const std::string gate = "gate --db " + db + " --goldens " + (folder / "goldens");
  ASSERT_EQ(call(folder, gate).code, 0);
  std::string bytes = read_text(db);
  const std::size_t norm = bytes.find("linear", bytes.find("Small"));
  ASSERT_NE(norm, std::string::npos);
  bytes[norm] = 'L';
  folder.write("r.db", bytes);
  const Answer gated = call(folder, gate);
  EXPECT_EQ(gated.code, 2);
  EXPECT_THAT(gated.err, HasSubstr("`mpmvv db check` lists all that is not (restore a copy, or start a new store)"));
  EXPECT_EQ(call(folder, "db check --db " + db).code, 1);
}

TEST(GateCommand, ExitCodesOfTheContract) {
  const Folder folder;
  const std::string db = store_of(folder);
  std::filesystem::create_directories(folder / "goldens");
  const std::string gate = "gate --db " + db + " --goldens " + (folder / "goldens") + " ";
  const Answer empty = call(folder, gate);
  EXPECT_EQ(empty.code, 2) << "a gate without goldens must not pass";
  EXPECT_THAT(empty.err, HasSubstr("`mpmvv propose --db DB --study NAME --out"));
  const auto golden = [&](const char* series, double expected, const char* mark = "reviewed = \"now\"\n") {
    folder.write("goldens/small.toml", std::string(mark) + "study = \"small\"\n[[order]]\nseries = \"" +
                                           std::string(series) + "\"\nnorm = \"l2\"\nexpected = " +
                                           std::to_string(expected) + "\nlower = " + std::to_string(expected - 0.15) +
                                           "\nupper = " + std::to_string(expected + 0.15) + "\n");
  };
  const auto claims = call(folder, "claims --db " + db + " --json").json()["claims"];
  const auto found = std::find_if(claims.begin(), claims.end(), [](const auto& c) { return c["id"] == "S-fig10"; });
  const std::string evidence = (*found)["evidence"];
  const double order = std::stod(evidence.substr(evidence.find(" = ") + 3));
  golden("bspline2", order);
  EXPECT_EQ(call(folder, gate + "--junit " + (folder / "gate.xml")).code, 0);
  EXPECT_THAT(read_text(folder / "gate.xml"), HasSubstr("<testsuites"));
  golden("bspline2", order + 1);
  EXPECT_EQ(call(folder, gate).code, 1);
  golden("bspline9", order);
  EXPECT_EQ(call(folder, gate).code, 3);
  golden("bspline2", order, "");
  EXPECT_EQ(call(folder, gate).code, 3) << "nobody has reviewed it";
}

TEST(GateCommand, ATrialPassesOnlyWhereItIsAskedFor) {
  const Folder folder;
  std::string text = small_study;
  text.pop_back();  // no newline at its end
  const std::string file = folder.write("small.toml", text), db = folder / "r.db";
  std::filesystem::create_directories(folder / "goldens");
  folder.write("goldens/small.toml",
               "reviewed = \"now\"\nstudy = \"small\"\n[[status]]\nseries = \"linear\"\nat = 8\nexpected = \"ok\"\n");
  const std::string gate = "gate --db " + db + " --goldens " + (folder / "goldens") + " ";
  ASSERT_EQ(call(folder, "study --set-where-taken shuffle=3 " + file + " --db " + db).code, 0);
  const Answer trial = call(folder, gate);
  EXPECT_EQ(trial.code, 3);
  EXPECT_THAT(trial.out, HasSubstr("(made with --set: shuffle = 3 in 2 of 2 series)"));
  EXPECT_EQ(call(folder, gate + "--as-set").code, 0);
  ASSERT_EQ(call(folder, "study " + file + " --db " + db).code, 0);
  EXPECT_EQ(call(folder, gate).code, 0) << "the study as it stands";
}

TEST(GateCommand, SaysWhichStudyFileIsNotWhatWasRun) {
  const Folder folder;
  for (const char* name : {"studies", "goldens"}) std::filesystem::create_directories(folder / name);
  folder.write("studies/small.toml", small_study);
  folder.write("goldens/small.toml",
               "reviewed = \"now\"\nstudy = \"small\"\n[[status]]\nseries = \"linear\"\nat = 8\nexpected = \"ok\"\n");
  ASSERT_EQ(carry_out(folder, "mpmvv study studies/small.toml --db r.db").code, 0);
  EXPECT_EQ(carry_out(folder, "mpmvv gate --db r.db").err, "");
  folder.write("studies/small.toml", small_study + std::string("# another day\n"));
  const Answer gated = carry_out(folder, "mpmvv gate --db r.db");
  EXPECT_EQ(gated.code, 0);
  EXPECT_THAT(gated.err, HasSubstr("small: studies/small.toml is not what was run"));
  folder.write("small.toml", small_study);
  EXPECT_EQ(carry_out(folder, "mpmvv gate --db r.db").err, "") << "another of its name is not what was run";
  folder.write("small.toml", small_study + std::string("# another day\n"));
  EXPECT_THAT(carry_out(folder, "mpmvv gate --db r.db").err, HasSubstr("small: small.toml is not what was run"));
  std::filesystem::remove(folder / "studies/small.toml");
  for (const char* other : {"title = \"Another\"\n", "[package]\n", "no TOML"}) {
    folder.write("small.toml", other);
    EXPECT_EQ(carry_out(folder, "mpmvv gate --db r.db").err, "") << other;
  }
}

/// A night on which a study was not run, as its file has another name or its code was not there.
TEST(GateCommand, DoesNotPassWhatIsOlderThanAsked) {
  const Folder folder;
  std::filesystem::create_directories(folder / "goldens");
  store_of(folder);
  folder.write("goldens/small.toml",
               "reviewed = \"now\"\nstudy = \"small\"\n[[status]]\nseries = \"linear\"\nat = 8\nexpected = \"ok\"\n");
  EXPECT_EQ(carry_out(folder, "mpmvv gate --db r.db --max-age 12").code, 0);
  {
    store::Store store(folder / "r.db", store::Store::Mode::write);
    store::Provenance earlier = store::current_provenance();
    const auto study = store.studies(earlier.digest).at(0);
    earlier.time = "2001-01-01T00:00:00Z";
    store.keep_study(study, {{}, {}}, earlier);
  }
  EXPECT_EQ(carry_out(folder, "mpmvv gate --db r.db").code, 0);
  const Answer old = carry_out(folder, "mpmvv gate --db r.db --max-age 12");
  EXPECT_EQ(old.code, 3);
  EXPECT_THAT(old.out, HasSubstr("last run 2001-01-01T00:00:00Z, more than 12 h ago"));
  ASSERT_EQ(carry_out(folder, "mpmvv report --db r.db --max-age 12 --out report").code, 0);
  EXPECT_THAT(read_text(folder / "report/gate.html"), HasSubstr("last run 2001-01-01T00:00:00Z, more than 12 h ago"));
  {
    store::Store store(folder / "r.db", store::Store::Mode::write);
    store::Provenance later = store::current_provenance();
    later.time = "2999-01-01T00:00:00Z";
    store.keep_study(store.studies(later.digest).at(0), {{}, {}}, later);
  }
  const Answer future = carry_out(folder, "mpmvv gate --db r.db --max-age 12");
  EXPECT_EQ(future.code, 3);
  EXPECT_THAT(future.out, HasSubstr("last run 2999-01-01T00:00:00Z, in the future: a clock was wrong"));
  ASSERT_EQ(carry_out(folder, "mpmvv study small.toml --db r.db").code, 0) << "nothing is run, and it is looked at";
  EXPECT_EQ(carry_out(folder, "mpmvv gate --db r.db --max-age 12").code, 0);
}

TEST(ClaimsCommand, ATrialSaysNothingOfItsClaims) {
  const Folder folder;
  const std::string db = store_of(folder);
  const std::string study = "study " + (folder / "small.toml") + " --db " + db, claim = "claims S-fig10 --db " + db;
  EXPECT_THAT(call(folder, claim).out, HasSubstr("S-fig10: confirmed"));
  EXPECT_THAT(call(folder, study + " --set shuffle=3").err, HasSubstr("small: takes the place of the study in "));
  const std::string page = call(folder, claim).out;
  EXPECT_THAT(page, HasSubstr("S-fig10: open"));
  EXPECT_THAT(page,
              HasSubstr("why it is inconclusive: second order\n    made with --set: shuffle = 3 in 2 of 2 series"));
  EXPECT_THAT(page, testing::Not(HasSubstr("why it fails")));
  EXPECT_THAT(call(folder, claim + " --json").out, HasSubstr("made with --set: shuffle = 3 in 2 of 2 series"));
  EXPECT_EQ(call(folder, study).err, "");
  EXPECT_THAT(call(folder, claim).out, HasSubstr("S-fig10: confirmed"));
}

TEST(ProposeCommand, MakesTheFolderOfItsFileAndNeedsNoGoldens) {
  const Folder folder;
  const std::string db = folder / "r.db", file = folder / "new/goldens/s.toml";
  records::StudyResult study;
  study.name = "s";
  study.values = {{"gap", 1, "a gap"}};
  store::Provenance clean = store::current_provenance();
  clean.dirty = false;
  store::Store(db, store::Store::Mode::create_or_write).keep_study(study, {}, clean);
  std::filesystem::create_directories(folder / "none");
  const std::string propose = "propose --db " + db + " --study s --goldens " + (folder / "none") + " --out ";
  const Answer made = call(folder, propose + file);
  EXPECT_EQ(made.code, 0) << made.err;
  const std::string gate = "gate --db " + db + " --goldens " + (folder / "new/goldens");
  EXPECT_EQ(call(folder, gate).code, 3) << "not reviewed yet";
  const std::string text = read_text(file);
  folder.write("new/goldens/s.toml", "reviewed = \"now\"\n" + text);
  EXPECT_EQ(call(folder, gate).code, 0);
  EXPECT_EQ(call(folder, propose + file).code, 2) << "it is there";
  const Answer no_folder = call(folder, propose + db + "/s.toml");
  EXPECT_EQ(no_folder.code, 2);
  EXPECT_THAT(no_folder.err, HasSubstr("cannot make the folder " + db));
}

TEST(Program, NamesItsVersionWhenAsked) {
  const Folder folder;
  EXPECT_THAT(call(folder, "--version").out, MatchesRegex("mpmvv .*\ndigest [0-9a-f]+\n.*\n"));
}

}  // namespace mpmvv::cli::store_commands_test
