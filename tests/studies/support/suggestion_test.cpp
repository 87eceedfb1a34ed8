#include "studies/support/suggestion.hpp"

#include <gtest/gtest.h>

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
            "unknown basis 'bsplin2' in s.toml:7 (known: linear, bspline2, ugimp; did you mean 'bspline2'?)");
  EXPECT_EQ(with_suggestion("unknown key 'cels' in s.toml:2 (known: cells)"),
            "unknown key 'cels' in s.toml:2 (known: cells; did you mean 'cells'?)");
}

TEST(WithSuggestion, LeavesOtherMessages) {
  for (const char* message :
       {"unknown problem 'beam' in --problem (known: bar, ring)", "cannot read 'a' (known: b)", "unknown", "",
        "unknown key 'cels'", "unknown time (known: 'a', b)", "unknown key 'cels' in a (known: cells) or so"})
    EXPECT_EQ(with_suggestion(message), message);
}

}  // namespace mpmvv::support::suggestion_test
