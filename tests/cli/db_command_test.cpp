#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "studies/store/provenance.hpp"
#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_store.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::db_command_test {

using testing::HasSubstr;
using testing::MatchesRegex;

TEST(DbCommand, ABadSourceLeavesNoTarget) {
  const Folder folder;
  const std::string target = folder / "target.db";
  const Answer merge = call(folder, "db merge --db " + target + " " + (folder / "absent.db"));
  EXPECT_EQ(merge.code, 2);
  EXPECT_THAT(merge.err, HasSubstr("no results store '" + (folder / "absent.db") + "'"));
  EXPECT_FALSE(std::filesystem::exists(target));
}

/// Overwrites bytes of a file in its middle.
void damage(const std::string& file) {
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekp(static_cast<std::streamoff>(std::filesystem::file_size(file) / 2));
  stream << std::string(8192, 'x');
}

TEST(DbCommand, AMergeThatFailsLeavesNoTarget) {
  const Folder folder;
  const std::string db = store_of(folder), target = folder / "target.db";
  damage(db);
  const Answer merge = call(folder, "db merge --db " + target + " " + db);
  EXPECT_EQ(merge.code, 2);
  EXPECT_THAT(merge.err, HasSubstr("is damaged"));
  EXPECT_FALSE(std::filesystem::exists(target));
}

/// No file grows beyond this in the programs that are called meanwhile.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) {
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &now);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    signal(SIGXFSZ, SIG_DFL);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
};

TEST(DbCommand, AnExportThatFailsLeavesWhatWasThere) {
  const Folder folder;
  const std::string db = store_of(folder);
  const std::string csv = folder.write("old.csv", "id,case");
  {
    const SmallFiles limit(1000);
    EXPECT_EQ(call(folder, "db export --db " + db + " --out " + csv).code, 2);
  }
  EXPECT_EQ(read_text(csv), "id,case");
  EXPECT_EQ(call(folder, "db export --db " + db + " --out " + csv).code, 0);
  EXPECT_THAT(read_text(csv), HasSubstr("case_text"));
}

TEST(DbCommand, ForgetsAStudyThatNoReportCanHave) {
  const Folder folder;
  const std::string db = store_of(folder);
  const Answer absent = call(folder, "db forget smal --db " + db);
  EXPECT_EQ(absent.code, 2);
  EXPECT_THAT(absent.err, HasSubstr("; did you mean 'small'? (known: small)"));
  EXPECT_EQ(call(folder, "db forget small --db " + db).code, 0);
  EXPECT_THAT(call(folder, "db info --db " + db).out, HasSubstr("records   8: 8 ok, 0 unstable, 0 failed\n"));
  EXPECT_THAT(call(folder, "study " + (folder / "small.toml") + " --db " + db).out, HasSubstr("0 cases run"));
}

TEST(DbCommand, PruneNamesTheVersionsThatItRemoves) {
  const Folder folder;
  const std::string db = store_of(folder);
  store::Provenance old = store::current_provenance();
  old.digest = "0123456789abcdef", old.commit = "c0ffee", old.dirty = false, old.time = "2024-05-06T07:08:09Z";
  records::StudyResult study;
  study.name = "id,case";
  store::Store(db, store::Store::Mode::write).keep_study(study, {}, old);
  const Answer prune = call(folder, "db prune --keep 1 --db " + db);
  EXPECT_EQ(prune.code, 0);
  EXPECT_THAT(prune.out,
              MatchesRegex("c0ffee [(]digest 0123456789ab[)], 2024-05-06T07:08:09Z\n1 version removed from " + db +
                           ": 1 study, 0 records; the file keeps its size\n"));
  EXPECT_THAT(call(folder, "db prune --keep 1 --db " + db).out, HasSubstr("0 versions removed"));
  EXPECT_THAT(call(folder, "db info --db " + db).out, HasSubstr("records   8: 8 ok"));
  EXPECT_EQ(call(folder, "db prune --keep 0 --db " + db).code, 2);
}

TEST(DbCommand, PrintsTheFileOfAStudyThatTheStoreKeeps) {
  const Folder folder;
  const std::string file = folder.write("small.toml", small_study), db = folder / "r.db";
  ASSERT_EQ(call(folder, "study " + file + " --set ppc=2 --db " + db).code, 0);
  const Answer study = call(folder, "db study small --db " + db);
  EXPECT_EQ(study.code, 0);
  EXPECT_EQ(study.out, small_study) << "without the line of the trial";
  store::Provenance later = store::current_provenance();
  later.digest = "0123456789abcdef", later.time = "2099-05-06T07:08:09Z";
  records::StudyResult other;
  other.name = "small", other.text = "title = \"later\"\n";
  store::Store(db, store::Store::Mode::write).keep_study(other, {}, later);
  EXPECT_EQ(call(folder, "db study small --db " + db).out, small_study) << "as this program kept it";
  other.name = "another";
  store::Store(db, store::Store::Mode::write).keep_study(other, {}, later);
  EXPECT_EQ(call(folder, "db study another --db " + db).out, other.text) << "as it was kept last";
  const Answer absent = call(folder, "db study smal --db " + db);
  EXPECT_EQ(absent.code, 2);
  EXPECT_THAT(absent.err, HasSubstr("; did you mean 'small'? (known: another, small)"));
}

TEST(DbCommand, InfoHasNumbersForPrograms) {
  const Folder folder;
  const std::string db = store_of(folder);
  const auto info = call(folder, "db info --json --db " + db).json();
  EXPECT_EQ(info["records"], 8);
  EXPECT_EQ(info["ok"], 8);
  EXPECT_EQ(info["studies"], 1);
  ASSERT_EQ(info["programs"].size(), 1U);
  EXPECT_EQ(info["programs"][0]["records"], 8);
  EXPECT_EQ(info["programs"][0]["digest"].get<std::string>().size(), 64U);
}

TEST(DbCommand, CheckSaysOfAStoreThatCannotBeOpenedWhatIsWrongAndNotToCheckIt) {
  const Folder folder;
  const std::string db = store_of(folder), check = "db check --db " + db;
  std::string bytes = read_text(db);
  for (std::size_t at; (at = bytes.find("claim_found")) != std::string::npos;) bytes[at] = 'C';
  folder.write("r.db", bytes);
  EXPECT_EQ(call(folder, check).err, "mpmvv: results store '" + db +
                                         "' is damaged: table 'claim_found' is missing (restore a copy, or start a new "
                                         "store)\n");
  std::filesystem::resize_file(db, 8192);
  EXPECT_EQ(call(folder, check).err,
            "mpmvv: results store '" + db +
                "' is damaged: its pages do not fit together, as where it was cut off (restore "
                "a copy, or start a new store)\n");
}

}  // namespace mpmvv::cli::db_command_test
