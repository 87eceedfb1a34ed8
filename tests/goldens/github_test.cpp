#include "goldens/github.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mpmvv::goldens::github_test {

TEST(Github, MarksTheLinesOfGoldensThatDoNotPass) {
  const GateReport report{{{"s", "order of 'a' in l2", Verdict::pass, "2", "2.01", "", "goldens/s.toml:3"},
                           {"s", "limit of 'b'", Verdict::fail, "1", "2", "above", "goldens/s.toml:7"},
                           {"s", "error of 'd'", Verdict::fail, "1", "", "the run failed", "goldens/s.toml:8"},
                           {"s", "value 'c'", Verdict::inconclusive, "at most 1", "", "missing", "goldens/s.toml:9"}}};
  EXPECT_EQ(github_annotations(report),
            "::error file=goldens/s.toml,line=7,title=s%3A limit of 'b'::expected 1, measured 2 (above)\n"
            "::error file=goldens/s.toml,line=8,title=s%3A error of 'd'::expected 1, not measured (the run failed)\n"
            "::warning file=goldens/s.toml,line=9,title=s%3A value 'c'::expected at most 1 (missing)\n");
}

TEST(Github, GoldensOfStudiesThatWereNeverRunShareOneNotice) {
  const auto absent = [](const char* study) {
    return GateResult{study, "value 'c'", Verdict::inconclusive, "1", "", "missing", "goldens/s.toml:9", false, true};
  };
  const GateResult judged{"s", "value 'd'", Verdict::inconclusive, "1", "2", "old", "goldens/s.toml:3"};
  EXPECT_EQ(github_annotations({{absent("a"), judged, absent("b"), absent("b")}}),
            "::warning file=goldens/s.toml,line=3,title=s%3A value 'd'::expected 1, measured 2 (old)\n"
            "::notice title=goldens without a result::3 of 4: the store has nothing of their 2 studies\n");
  EXPECT_EQ(github_annotations({{absent("a")}}),
            "::notice title=goldens without a result::1 of 1: the store has nothing of their study\n");
}

TEST(Github, NoTextEndsTheCommand) {
  const GateReport report{{{"s", "a, b: c%", Verdict::fail, "1 ± 10 %", "2", "x\ny::z", "goldens/a,b.toml:1"}}};
  EXPECT_EQ(github_annotations(report),
            "::error file=goldens/a%2Cb.toml,line=1,title=s%3A a%2C b%3A c%25::expected 1 ± 10 %25, measured 2 "
            "(x\\ny::z)\n");
}

TEST(Github, NoNameBeginsACommandOfItsOwn) {
  const std::string bad = "\n::error file=x::\r\x1b[2J\x07\xE2\x80\xA8";
  const std::string lines = github_annotations({{{bad, bad, Verdict::fail, bad, bad, bad, bad + ":1"},
                                                 {bad, bad, Verdict::inconclusive, bad, bad, bad, bad + ":2"}}});
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2);
  EXPECT_EQ(lines.find_first_of("\r\x1b\x07"), std::string::npos);
  EXPECT_EQ(lines.find("\xE2\x80\xA8"), std::string::npos);
}

}  // namespace mpmvv::goldens::github_test
