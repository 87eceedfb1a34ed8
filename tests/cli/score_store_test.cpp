#include <gmock/gmock.h>

#include "tests/cli/program.hpp"
#include "tests/studies/codes/mover.hpp"

/// What a code has written somewhere else, put into the store of a study.
namespace mpmvv::cli::score_store_test {

using codes::Mover;
using testing::HasSubstr;

class ScoredIntoAStore : public testing::Test {
 protected:
  ScoredIntoAStore() {
    std::ofstream(mover_.top() / "s.toml") << Mover::study;
    EXPECT_EQ(in_folder("case" + theirs_ + "> case.json").code, 0);
    EXPECT_EQ(in_folder("run" + theirs_ + "--keep kept").code, 0);
  }

  Answer in_folder(const std::string& arguments) const {
    return call(folder_, arguments, "cd '" + mover_.top().string() + "' && ");
  }

  const Mover mover_;
  const Folder folder_;
  const std::string problem_ = " --problem translation --cells 4 --ppc 2 --cfl 0.5 ",
                    theirs_ = " --code mover" + problem_;
};

TEST_F(ScoredIntoAStore, AStudyTakesItInPlaceOfARun) {
  const Answer scored = in_folder("score case.json kept/particles.csv --db r.db");
  EXPECT_EQ(scored.code, 0) << scored.err;
  EXPECT_THAT(scored.err, HasSubstr("kept in r.db"));
  EXPECT_THAT(in_folder("study s.toml --db r.db").out, HasSubstr("2 cases run, 1 taken from r.db, 0 failed"));
  EXPECT_EQ(in_folder("db check --db r.db").code, 0);
}

TEST_F(ScoredIntoAStore, WhatIsThereStays) {
  in_folder("score case.json kept/particles.csv --db r.db");
  const Answer again = in_folder("score case.json kept/particles.csv --db r.db");
  EXPECT_EQ(again.code, 2);
  EXPECT_THAT(again.err, HasSubstr("r.db holds this case already"));
  EXPECT_EQ(again.out, "");
  EXPECT_EQ(in_folder("score case.json kept/particles.csv --db r.db --json").out, "");
}

/// A file of another time says nothing of the code.
TEST_F(ScoredIntoAStore, WhatIsNoOutputOfTheCaseIsNotKept) {
  std::ofstream(mover_.top() / "short.csv") << "id,x,y\n1,0,0\n";
  const Answer scored = in_folder("score case.json short.csv --db r.db");
  EXPECT_EQ(scored.code, 1);
  EXPECT_THAT(scored.err, HasSubstr("not kept in r.db"));
  EXPECT_FALSE(std::filesystem::exists(mover_.top() / "r.db"));
}

/// By the adapter's rule of the step and tolerance of the time.
TEST_F(ScoredIntoAStore, ItIsJudgedAsInARun) {
  mover_.script(
      "t=$(awk -v t=\"$1\" 'BEGIN { printf \"%.17g\", 1.01 * t }')\n"
      "printf '# time = %s\\n# step = 7, dt = 0.7\\nid,x,y\\n' $t > particles.csv\n"
      "awk -v t=$t '{ printf \"%d,%.17g,%.17g\\n\", $1, $2 + t * $4, $3 + t * $5 }' input.txt >> particles.csv");
  const auto both = [this](const std::string& step) {
    mover_.adapter(Mover::text + step);
    in_folder("case" + theirs_ + "> case.json");
    std::filesystem::remove_all(mover_.top() / "again");
    return std::pair{in_folder("run" + theirs_ + "--json --keep again"),
                     in_folder("score case.json again/particles.csv --json")};
  };
  const auto [run, scored] = both("[step]\nrule = \"own\"\ntime_tolerance = 0.05\n");
  for (const char* key : {"status", "steps", "cfl", "error", "particles"})
    EXPECT_EQ(scored.json()[key], run.json()[key]) << key;
  EXPECT_EQ(scored.json()["status"], "ok");
  EXPECT_EQ(scored.json()["steps"], 7);
  const auto [refused_run, refused] = both("[step]\nrule = \"own\"\n");
  EXPECT_EQ(refused_run.code, 1);
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.out, HasSubstr("(time_tolerance of the adapter: 1e-09)"));
}

TEST_F(ScoredIntoAStore, ACaseOfOurOwnSolverIsRefused) {
  in_folder("case" + problem_ + "> own.json");
  const Answer scored = in_folder("score own.json kept/particles.csv --db r.db");
  EXPECT_EQ(scored.code, 2);
  EXPECT_THAT(scored.err, HasSubstr("own.json, which names no version of another code"));
  EXPECT_EQ(scored.out, "");
}

}  // namespace mpmvv::cli::score_store_test
