#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::study_refusal_test {

using testing::AllOf;
using testing::HasSubstr;

struct BadFile {
  const char* from;  ///< text of the small study to replace
  const char* to;
  const char* message;
};

void PrintTo(const BadFile& bad, std::ostream* out) {
  *out << bad.message;
}

class BadStudy : public testing::TestWithParam<BadFile> {};

TEST_P(BadStudy, NamesFileAndLineAndWritesNothing) {
  const Folder folder;
  std::string text = small_study;
  text.replace(text.find(GetParam().from), std::string(GetParam().from).size(), GetParam().to);
  const std::string file = folder.write("bad.toml", text), db = folder / "r.db";
  const Answer answer = call(folder, "study " + file + " --db " + db);
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
  EXPECT_THAT(answer.err, HasSubstr("bad.toml:"));
  EXPECT_THAT(answer.err, HasSubstr(GetParam().message));
  EXPECT_FALSE(std::filesystem::exists(db));
}

INSTANTIATE_TEST_SUITE_P(
    , BadStudy,
    testing::Values(
        BadFile{"ppc = 4", "pcp = 4", "unknown key 'pcp'"},
        BadFile{"\"bspline2\"\n[sweep]", "\"bspline7\"\n[sweep]", "unknown basis 'bspline7'"},
        BadFile{"[8, 16, 32, 64]\n[[fit", "[]\n[[fit", "empty sweep"},
        BadFile{"[8, 16, 32, 64]\n[[fit", "[8, 16, 32, 64, -16]\n[[fit", "cells = -16"},
        BadFile{"[8, 16, 32, 64]\n[[fit", "[8, nan]\n[[fit", "nan"}, BadFile{"ppc = 4", "ppc = 0", "ppc = 0"},
        BadFile{"cfl = 0.3", "cfl = \"fast\"", "cfl = 'fast'"},
        BadFile{"name = \"bspline2\"", "name = \"linear\"", "series 'linear' twice"},
        BadFile{"norm = \"l2\"\nwindow = [8, 64]\n[[figure", "norm = \"l3\"\nwindow = [8, 64]\n[[figure",
                "unknown norm 'l3'"},
        BadFile{"window = [8, 64]\n[[figure", "window = [64, 8]\n[[figure", "window"},
        BadFile{"measure = \"order\"", "measure = \"ordre\"", "unknown measure 'ordre'"},
        BadFile{"claim = \"S-fig10\"", "claim = \"S-fig99\"", "unknown claim"},
        BadFile{"at_least = 1.5", "", "asks nothing"},
        BadFile{"at_least = 1.5", "at_least = 3\nat_most = 1", "nothing can be both"},
        BadFile{"claims = [\"S-fig10\"]", "claims = [\"S-fig10\", \"S-foo\"]", "unknown claim 'S-foo'"},
        BadFile{"[fixed]", "[[claim]]\nid = \"M 1\"\nstatement = \"s\"\n[fixed]", "id 'M 1' of a claim"},
        BadFile{"window = [8, 64]\n[[figure", "window = [100, 200]\n[[figure", "holds 0 swept values"},
        BadFile{"norm = \"l2\"\nwindow = [8, 64]\n[[figure", "norm = \"linf_all_steps\"\nwindow = [8, 64]\n[[figure",
                "without every_step"},
        BadFile{"[sweep]\n", "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\nscan_ratio = 1.0000001\n[sweep]\n",
                "scan_ratio"},
        BadFile{"[[fit]]", "[replicates]\ncells = [1, 2]\n[[fit]]", "beside a limit or a sweep of another"},
        BadFile{"[[fit]]", "[replicates]\n[[fit]]", "beside a limit or a sweep of another"},
        BadFile{"[[fit]]", "[replicates]\nblowup_error = [1, 2]\n[[fit]]", "unknown key of replicates 'blowup_error'"},
        BadFile{"[[fit]]", "[replicates]\nshuffle = [1, 2, 1]\n[[fit]]",
                "two replicates of series 'linear' are the same run in "},
        BadFile{"cfl = 0.3\n", "cfl = 0.3\nshuffle = 1\n[replicates]\nshuffle = [1, 2]\n", "beside its replicates in "},
        BadFile{"cells = [8, 16, 32, 64]", "steps = [4, 8, 16, 8.0]", "a value twice"},
        BadFile{"cfl = 0.3\n", "cells = 8\n[replicates]\nshuffle = [1, 2]\n", "beside the sweep over it in "},
        BadFile{"basis = \"linear\"", "basis = \"linear\"\ncells = 8", "beside the sweep over it in "},
        BadFile{"[sweep]\ncells = [8, 16, 32, 64]", "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1",
                "beside the search of its limit in "},
        BadFile{"[sweep]\ncells = [8, 16, 32, 64]",
                "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\nseries = [\"bspline2\"]", "is neither swept nor searched"},
        BadFile{"[sweep]\n", "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\n[sweep]\n",
                "has no cells for series 'linear' (one `cells` in [fixed] or in the series; those of [sweep]"},
        BadFile{"[sweep]\n", "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\nseries = [\"cubic\"]\n[sweep]\n",
                "unknown series 'cubic'"},
        BadFile{"basis = \"linear\"\n[[series]]\nname = \"bspline2\"\n",
                "basis = \"linear\"\ncells = 8\n[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\nseries = [\"linear\"]\n"
                "[[series]]\nname = \"bspline2\"\ncells = 8\n",
                "beside the sweep over it in "},
        BadFile{"measure = \"order\"\nseries = [\"bspline2\"]\nnorm = \"l2\"\nwindow = [8, 64]",
                "measure = \"limit\"\nseries = [\"bspline2\"]", "which the study does not search"},
        BadFile{"measure = \"order\"", "measure = \"shown\"", "'series' in "},
        BadFile{"window = [8, 64]\n[[figure", "window = [8, 64]\nfloor_window = [128, 512]\n[[figure",
                "holds 0 swept values"},
        BadFile{"[[fit]]", "[replicates]\nshuffle = [1]\n[[fit]]", "fewer than two replicates"},
        BadFile{"[[fit]]", "[[extrapolate]]\nnorm = \"l2\"\nwindow = [8, 32]\n[[fit]]", "holds 3 swept values"},
        BadFile{"ppc = 4", "ppc = 4\nrepeat = 1", "repeat = 1"},
        BadFile{"caption", "quantity = \"l3\"\ncaption", "unknown quantity 'l3'"},
        BadFile{"caption", "quantity = \"nodal_l2\"\ncaption", "without nodal_error"},
        BadFile{"caption", "quantity = \"y\"\ncaption", "y for the curves of a check"},
        BadFile{"caption", "kind = \"pie\"\ncaption", "unknown figure kind 'pie'"},
        BadFile{"caption", "kind = \"work-precision\"\ncaption", "`repeat` in every series"},
        BadFile{"caption", "kind = \"particles\"\ncaption", "without particle_errors = true in series 'linear'"},
        BadFile{"[[fit]]",
                "[[figure]]\nname = \"p\"\nkind = \"particles\"\ncaption = \"c\"\nxlabel = \"x\"\nylabel = "
                "\"y\"\n[replicates]\nshuffle = [1, 2]\n[[fit]]",
                "beside replicates in "},
        BadFile{"measure = \"order\"", "measure = \"cost-ratio\"\nover = \"linear\"", "`repeat` in every series"},
        BadFile{"title = \"Small\"", "title = 'Small", "bad.toml"}));

TEST(StudyCommand, ACheckHasNoSettings) {
  const Folder folder;
  const std::string check = folder.write("jump.toml", "title = \"Jump\"\nclaims = []\ncheck = \"jump-errors\"\n"),
                    small = folder.write("small.toml", small_study);
  const std::string db = folder / "r.db";
  for (const char* option : {"--set", "--set-where-taken"}) {
    const auto study = [&](const std::string& files, const std::string& setting) {
      return call(folder, "study " + files + " " + option + " " + setting + " --db " + db);
    };
    EXPECT_THAT(study(check, "nonsense=1").err, HasSubstr(std::string("unknown key 'nonsense' in ") + option));
    const Answer alone = study(check, "shuffle=3");
    EXPECT_EQ(alone.code, 2);
    EXPECT_EQ(alone.err,
              std::string("mpmvv: no series takes shuffle = 3 (a check has no settings for ") + option + ")\n");
    EXPECT_FALSE(std::filesystem::exists(db));
    const Answer mixed = study(check + " " + small + " --plan", "shuffle=3");
    EXPECT_EQ(mixed.code, 0);
    EXPECT_THAT(mixed.err, AllOf(HasSubstr("jump: shuffle = 3 changes nothing in a check"),
                                 HasSubstr("small: shuffle = 3 in 2 of 2 series")));
  }
}

TEST(StudyCommand, RefusesStoresThatAreNone) {
  const Folder folder;
  const std::string file = folder.write("small.toml", small_study);
  const std::string foreign =
      folder.write("foreign.db", "this is no database, but long enough to look like a file of its own");
  const Answer answer = call(folder, "study " + file + " --db " + foreign);
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
  EXPECT_THAT(answer.err, HasSubstr("foreign.db' is not a results store: no SQLite file"));
  EXPECT_EQ(read_text(foreign), "this is no database, but long enough to look like a file of its own");
  const auto refusal = [&](const std::string& arguments) {
    const Answer refused = call(folder, arguments);
    EXPECT_EQ(refused.code, 2) << arguments;
    return refused.err;
  };
  EXPECT_THAT(refusal("gate --db " + (folder / "absent.db")), HasSubstr("no results store '"));
  EXPECT_THAT(refusal("study " + file + " --db " + (folder / "no/such/folder.db")), HasSubstr("no folder '"));
}

TEST(StudyCommand, RefusesTwoStudiesOfOneName) {
  const Folder folder;
  for (const char* sub : {"a", "b"}) {
    std::filesystem::create_directories(folder / sub);
    folder.write(std::string(sub) + "/small.toml", small_study);
  }
  const Answer answer = call(folder, "study a/small.toml b/small.toml --db r.db", "cd '" + (folder / "") + "' && ");
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(answer.err, "mpmvv: two study files named 'small' (stems must differ)\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "r.db"));
}

TEST(BadStudyName, IsRefusedAtTheEntry) {
  const Folder folder;
  const std::string db = folder / "r.db";
  for (const std::string& stem : std::vector<std::string>{"a b", "a#b", "-a", "é", "a;b", std::string(101, 'a')}) {
    const Answer answer = call(folder, "study '" + folder.write(stem + ".toml", small_study) + "' --db " + db);
    EXPECT_EQ(answer.code, 2) << stem;
    EXPECT_THAT(answer.err, HasSubstr("cannot name a study"));
  }
  EXPECT_FALSE(std::filesystem::exists(db));
}

}  // namespace mpmvv::cli::study_refusal_test
