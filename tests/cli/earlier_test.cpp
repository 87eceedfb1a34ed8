#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"

namespace mpmvv::cli::earlier_test {

using testing::HasSubstr;
using testing::Not;

/// A check that measures one number and judges a claim by it.
records::StudyResult check(const std::string& name, records::PartVerdict verdict) {
  records::StudyResult study;
  study.name = name, study.kind = records::StudyKind::check;
  study.claims = {"T-a"};
  study.values = {{"gap", 1, ""}};
  study.parts = {{"T-a", "the gap of " + name + " is small", verdict, "", ""}};
  return study;
}

/// A store with studies `first` and `second` of an earlier version, of which this one has run `second` alone.
class EarlierVersion : public testing::Test {
 protected:
  EarlierVersion() {
    std::filesystem::create_directories(folder_ / "goldens");
    store::Store store(db_, store::Store::Mode::create_or_write);
    store::Provenance now = store::current_provenance(), then = now;
    then.digest = "00ff", then.commit = "c0ffee0123456789", then.time = "2001-01-01T00:00:00Z";
    now.digest = own_digest();
    for (records::StudyResult study : {check("first", holds), check("second", fails)}) {
      study.claims.push_back("X-mutants");
      store.keep_study(study, {}, then);
      if (study.name == "second") store.keep_study(study, {}, now);
      folder_.write("goldens/" + study.name + ".toml",
                    "study = \"" + study.name + "\"\nreviewed = \"x\"\n[[value]]\nname = \"gap\"\nat_most = 2\n");
    }
  }

  std::string own_digest() const {
    const std::string version = call(folder_, "--version").out;
    const std::size_t begin = version.find("\ndigest ") + 8;
    return version.substr(begin, version.find('\n', begin) - begin);
  }

  std::string front_page() const {
    const Answer answer =
        call(folder_, "report --db " + db_ + " --goldens " + (folder_ / "goldens") + " --out " + (folder_ / "report"));
    EXPECT_EQ(answer.code, 0) << answer.err;
    return read_text(folder_ / "report/index.html");
  }

  static constexpr auto holds = records::PartVerdict::holds, fails = records::PartVerdict::fails;
  const Folder folder_;
  const std::string db_ = folder_ / "r.db";
};

TEST_F(EarlierVersion, IsHeldAgainstThisOneWhereBothHaveAStudy) {
  const Answer compared = call(folder_, "compare 00ff --all --db " + db_);
  EXPECT_THAT(compared.out, HasSubstr("value 'gap': 1 -> 1"));
  EXPECT_THAT(compared.out, Not(HasSubstr("claim T-a"))) << "it was partly, by both studies";
  EXPECT_THAT(compared.out, HasSubstr("only in the first: study first\n"));
  const std::string page = front_page();
  EXPECT_THAT(page, HasSubstr("c0ffee012345"));
  EXPECT_THAT(page, Not(HasSubstr("-1 pass"))) << "the golden of the first";
  EXPECT_THAT(page, Not(HasSubstr(", was"))) << "neither T-a, nor X-mutants, of which nothing is known any more";
}

}  // namespace mpmvv::cli::earlier_test
