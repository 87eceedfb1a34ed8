#include "studies/support/suggestion.hpp"

#include <gtest/gtest.h>

#include "studies/support/words.hpp"

namespace mpmvv::support::suggestion_test {

TEST(EditDistance, CountsLettersAddedRemovedReplacedAndSwapped) {
  EXPECT_EQ(edit_distance("bspline2", "bspline2"), 0U);
  EXPECT_EQ(edit_distance("bsplin2", "bspline2"), 1U);
  EXPECT_EQ(edit_distance("bspline22", "bspline2"), 1U);
  EXPECT_EQ(edit_distance("bspline4", "bspline2"), 1U);
  EXPECT_EQ(edit_distance("bsplnie2", "bspline2"), 1U);
  EXPECT_EQ(edit_distance("BSpline2", "bspline2"), 0U);
  EXPECT_EQ(edit_distance("", "usl"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(NearestWord, IsNoneWhereNothingIsNear) {
  EXPECT_EQ(nearest_word("integratr", {"basis", "integrator"}), "integrator");
  EXPECT_EQ(nearest_word("beam", {"bar", "ring"}), std::nullopt);
  EXPECT_EQ(nearest_word("x", {}), std::nullopt);
  EXPECT_EQ(nearest_word("", {"a"}), std::nullopt);
}

TEST(WithSuggestion, NamesTheWordThatWasMeant) {
  EXPECT_EQ(with_suggestion("unknown basis 'bsplin2' in s.toml:7 (known: linear, bspline2, ugimp)"),
            "unknown basis 'bsplin2' in s.toml:7; did you mean 'bspline2'? (known: linear, bspline2, ugimp)");
  EXPECT_EQ(with_suggestion("unknown key 'cels' in s.toml:2 (known: cells)"),
            "unknown key 'cels' in s.toml:2; did you mean 'cells'? (known: cells)");
}

TEST(WithSuggestion, TakesAnItemWithACommaAsAWhole) {
  const std::string known = listed({"mine, quadratic", "yours", "mine, linear"});
  EXPECT_EQ(with_suggestion("unknown series 'mine' in s.toml:7 (known: " + known + ")"),
            "unknown series 'mine' in s.toml:7 (known: 'mine, quadratic', yours, 'mine, linear')");
  EXPECT_EQ(with_suggestion("unknown series 'mine, lnear' in s.toml:7 (known: " + known + ")"),
            "unknown series 'mine, lnear' in s.toml:7; did you mean 'mine, linear'? "
            "(known: 'mine, quadratic', yours, 'mine, linear')");
}

TEST(WithSuggestion, GivesTheNearestWordsOfALongList) {
  std::vector<std::string> known;
  for (int k = 10; k < 40; ++k) known.push_back("problem-" + std::to_string(k));
  const auto message = [&](const std::string& kind) {
    return with_suggestion("unknown " + kind + " 'problem-3x' in s.toml:7 (known: " + listed(known) + ")");
  };
  const std::string nearest =
      "(known: problem-30, problem-31, problem-32, problem-33, problem-34, problem-35, "
      "problem-36, problem-37 and 22 more";
  EXPECT_EQ(message("problem"), "unknown problem 'problem-3x' in s.toml:7; did you mean 'problem-30'? " + nearest +
                                    "; `mpmvv list problems` prints all)");
  EXPECT_EQ(message("figure"), "unknown figure 'problem-3x' in s.toml:7; did you mean 'problem-30'? " + nearest + ")");
}

TEST(WithSuggestion, LeavesOtherMessages) {
  for (const char* message :
       {"unknown problem 'beam' in --problem (known: bar, ring)", "cannot read 'a' (known: b)", "unknown", "",
        "unknown key 'cels'", "unknown time (known: 'a', b)", "unknown key 'cels' in a (known: cells) or so"})
    EXPECT_EQ(with_suggestion(message), message);
}

}  // namespace mpmvv::support::suggestion_test
