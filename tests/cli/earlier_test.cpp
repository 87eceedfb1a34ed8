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

/// A check that holds, and the series of another code whose criterion fails.
records::StudyResult with_another_code(const std::string& name) {
  records::StudyResult study = check(name, records::PartVerdict::holds);
  study.claims = {"T-b"}, study.parts[0].claim = "T-b";
  study.series.resize(1);
  study.series[0].name = "theirs", study.series[0].code = records::OtherCode{"my-code", "1.3", "", "reference", "aa"};
  study.parts.push_back({"T-b", "theirs is small", records::PartVerdict::fails, "l2 of 'theirs' = 1", ""});
  study.parts.back().found = {{"l2 of 'theirs'", 1}};
  return study;
}

/// A store with studies `first`, `second` and `third` of an earlier version, of which this one has not run `first` yet.
class EarlierVersion : public testing::Test {
 protected:
  EarlierVersion() {
    std::filesystem::create_directories(folder_ / "goldens");
    store::Store store(db_, store::Store::Mode::create_or_write);
    store::Provenance now = store::current_provenance(), then = now;
    then.digest = "00ff", then.commit = "c0ffee0123456789", then.time = "2001-01-01T00:00:00Z";
    now.digest = own_digest(folder_);
    for (const records::StudyResult& study : {check("first", holds), check("second", fails)}) {
      store.keep_study(study, {}, then);
      if (study.name == "second") store.keep_study(study, {}, now);
      store.keep_study(with_another_code("third"), {}, study.name == "second" ? now : then);
      folder_.write("goldens/" + study.name + ".toml",
                    "study = \"" + study.name + "\"\nreviewed = \"x\"\n[[value]]\nname = \"gap\"\nat_most = 2\n");
    }
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
  EXPECT_THAT(compared.out, HasSubstr("only in the first: claim T-a by first, second\n")) << "it was partly, by both";
  EXPECT_THAT(compared.out, HasSubstr("only in the second: claim T-a by second\n"));
  EXPECT_THAT(compared.out, HasSubstr("only in the first: study first\n"));
  const std::string page = front_page();
  EXPECT_THAT(page, HasSubstr("c0ffee012345"));
  EXPECT_THAT(page, Not(HasSubstr("-1 pass"))) << "the golden of the first";
  EXPECT_THAT(page, Not(HasSubstr(", was"))) << "both studies judged T-a";
}

}  // namespace mpmvv::cli::earlier_test
