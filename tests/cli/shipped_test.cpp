#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

/// Folders of goldens that a user names.
namespace mpmvv::cli::shipped_test {

using testing::HasSubstr;

/// A folder with a store of one study, a study file, and a folder of goldens without one.
class NamedGoldens : public testing::Test {
 protected:
  void SetUp() override {
    records::StudyResult study;
    study.name = "s";
    study.values = {{"gap", 1, "a gap"}};
    store::Store(folder_ / "r.db", store::Store::Mode::create_or_write)
        .keep_study(study, {}, store::current_provenance());
    folder_.write("splines.toml", small_study);
    std::filesystem::create_directories(folder_ / "empty");
  }

  Answer say(const std::string& arguments) const { return call(folder_, arguments, "cd '" + (folder_ / "") + "' && "); }

  void expect_refused(const std::string& arguments, const std::string& why) const {
    const Answer answer = say(arguments);
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_THAT(answer.err, HasSubstr(why)) << arguments;
  }

  const Folder folder_;
  const std::string report_ = "report --db r.db --out report",
                    submit_ = "submit splines.toml --engine slurm --shards 1 --db all.db --dry-run",
                    propose_ = "propose --db r.db --study s";
};

TEST_F(NamedGoldens, AreRefusedWhereTheyAreNotThere) {
  for (const std::string& command :
       {report_, submit_, propose_, propose_ + " --out other/s.toml", std::string("gate --db r.db")})
    expect_refused(command + " --goldens goldnes", "no directory 'goldnes' (one with goldens, *.toml; `mpmvv propose");
  for (const std::string& command : {report_, submit_})
    expect_refused(command + " --goldens empty", "no golden in 'empty' (at least one *.toml; `mpmvv propose");
  for (const char* output : {"report", "all.shards", "other"}) EXPECT_FALSE(std::filesystem::exists(folder_ / output));
}

TEST_F(NamedGoldens, BeginWithTheFirstThatIsProposed) {
  EXPECT_EQ(say(propose_ + " --goldens ./bands/ --out bands/s.toml").code, 0);
  EXPECT_EQ(say(propose_ + " --goldens empty --out empty/s.toml").code, 0);
  EXPECT_EQ(say("gate --db r.db --goldens bands").code, 3) << "not reviewed yet";
}

TEST_F(NamedGoldens, AreNoFileOfTheUsualName) {
  folder_.write("goldens", "");
  for (const std::string& command : {report_, submit_, propose_}) expect_refused(command, "no directory 'goldens'");
}

}  // namespace mpmvv::cli::shipped_test
