#include "reports/study_call.hpp"

#include <gtest/gtest.h>

namespace mpmvv::reports::study_call_test {

TEST(StudyCall, TrialsHaveACommandOfTheirOwn) {
  EXPECT_EQ(study_command({}, "a.db", "b.db"), "");
  EXPECT_EQ(study_command({{"one"}, {"tried.toml", " --set ppc=2"}, {"two"}}, "a.db", "b.db"),
            "mpmvv study one two --db a.db && mpmvv study tried.toml --set ppc=2 --db b.db");
}

TEST(StudyCall, AShellTakesItsWords) {
  EXPECT_EQ(study_command({{"my studies/a.toml"}}, "it's.db", ""),
            R"(mpmvv study 'my studies/a.toml' --db 'it'\''s.db')");
}

}  // namespace mpmvv::reports::study_call_test
