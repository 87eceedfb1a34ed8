#include "cli/table.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "cli/numbers.hpp"

namespace mpmvv::cli::table_test {

using Kind = Table::Kind;

TEST(Lines, AreCountedBrokenAndCutByCharacters) {
  EXPECT_EQ(columns_of("± 2"), 3U);
  EXPECT_EQ(padded("±", 3, Align::left), "±  ");
  EXPECT_EQ(padded("±", 3, Align::right), "  ±");
  EXPECT_EQ(wrapped("one two three", 7), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapped("unbreakable is", 4), (std::vector<std::string>{"unbreakable", "is"}));
  EXPECT_EQ(wrapped("", 4), std::vector<std::string>{""});
  EXPECT_EQ(cut("φ0 + α", 6), "φ0 + α");
  EXPECT_EQ(cut("φ0 + α h", 6), "φ0 + …");
  EXPECT_EQ(cut("φ0", 1), "…");
  EXPECT_EQ(cut("φ0", 0), "");
}

TEST(Numbers, HaveOneFormEach) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(number_text(0.123456), "0.1235");
  EXPECT_EQ(error_text(0.000123456), "1.235e-04");
  EXPECT_EQ(order_text(1.987), "1.99");
  EXPECT_EQ(half_width_text(0.234), "± 0.23");
  EXPECT_EQ(half_width_text(0), "-") << "nothing is known of it";
  for (const auto text : {&number_text, &error_text, &order_text, &half_width_text}) EXPECT_EQ(text(none), "-");
  EXPECT_EQ(count_text(1, "case") + ", " + count_text(2, "case"), "1 case, 2 cases");
  EXPECT_EQ(count_text(1, "study", "studies") + ", " + count_text(0, "study", "studies"), "1 study, 0 studies");
  EXPECT_EQ(duration_text(0), "0.0 s");
  EXPECT_EQ(duration_text(0.00214), "0.0021 s");
  EXPECT_EQ(duration_text(42.4), "42 s");
  EXPECT_EQ(duration_text(186), "3.1 min");
  EXPECT_EQ(duration_text(2460), "41 min");
  EXPECT_EQ(duration_text(9000), "2.5 h");
}

TEST(Table, AlignsNumbersRightUnderHeadsOfSeveralLines) {
  Table table({{"cells", Kind::number}, {"linear,\n4 PPC", Kind::number}, {"of"}});
  table.add({"8", "1.5e-03", "bar"});
  table.add({"128", "± 2", ""});
  EXPECT_EQ(table.text(100, false),
            "         linear,\n"
            "  cells    4 PPC  of\n"
            "      8  1.5e-03  bar\n"
            "    128      ± 2\n");
  EXPECT_EQ(table.width(), 21U);
}

TEST(Table, WrapsProseToTheWidthThatIsLeft) {
  Table table({{"study"}, {"what", Kind::prose}}, 0);
  table.add({"s-fig10", "a sentence of some words that a line of forty cannot hold"});
  EXPECT_EQ(table.text(40, false),
            "study    what\n"
            "s-fig10  a sentence of some words that a\n"
            "         line of forty cannot hold\n");
}

TEST(Table, ProseStandsBelowItsRowWhereThatLeavesLittle) {
  Table table({{"study"}, {"what", Kind::prose}});
  table.add({"a-name-of-some-length", "as short as can be, or longer than it should be"});
  EXPECT_EQ(table.text(40, false),
            "  study\n"
            "  a-name-of-some-length\n"
            "      as short as can be, or longer than\n"
            "      it should be\n");
}

TEST(Table, WithoutRoomForAllItsColumnsPutsTheFirstAbove) {
  Table table({{"order of"}, {"in"}, {"order", Kind::number}, {"asymptotic"}});
  for (const char* series : {"a name of some length", "another"})
    for (const char* norm : {"l1", "l2"}) table.add({series, norm, "1.98", "yes"});
  EXPECT_EQ(table.text(40, false),
            "  order of\n"
            "    in  order  asymptotic\n"
            "  a name of some length\n"
            "    l1   1.98  yes\n"
            "    l2   1.98  yes\n"
            "  another\n"
            "    l1   1.98  yes\n"
            "    l2   1.98  yes\n");
  EXPECT_EQ(table.text(21, false),
            "  order of, in\n"
            "    order  asymptotic\n"
            "  a name of some\n"
            "  length, l1\n"
            "     1.98  yes\n"
            "  a name of some\n"
            "  length, l2\n"
            "     1.98  yes\n"
            "  another, l1\n"
            "     1.98  yes\n"
            "  another, l2\n"
            "     1.98  yes\n");
}

TEST(Table, AHeadOfProseBelowMakesNoLineTooWide) {
  Table table({{"criterion"}, {"found"}, {"what is asked", Kind::prose}}, 0);
  table.add({"of a name of some length", "0.5 to 0.7", "not much"});
  EXPECT_EQ(table.text(40, false),
            "criterion                 found\n"
            "of a name of some length  0.5 to 0.7\n"
            "    not much\n");
}

TEST(Table, CutsALineToTheWidthThatIsLeft) {
  Table table({{"study"}, {"what", Kind::line}}, 0);
  table.add({"s-fig10", "a sentence of some words that a line of forty cannot hold"});
  EXPECT_EQ(table.text(40, false), "study    what\ns-fig10  a sentence of some words that …\n");
}

TEST(Table, ALineWithoutRoomStandsBelowItsRow) {
  Table table({{"claim"}, {"verdict", Kind::verdict}, {"statement", Kind::line}}, 0);
  table.add({"S-fig10", "confirmed", "a sentence of some words that a line of thirty cannot hold"});
  EXPECT_EQ(table.text(30, false),
            "claim    verdict\n"
            "S-fig10  confirmed\n"
            "    a sentence of some words …\n");
}

TEST(Table, ColoursVerdictsAlone) {
  Table table({{"verdict", Kind::verdict}, {"what"}}, 0);
  table.add({"holds", "fails"});
  table.add({"fails", "holds"});
  table.add({"shown", "pass"});
  EXPECT_EQ(table.text(80, true),
            "verdict  what\n"
            "\033[32mholds\033[0m    fails\n"
            "\033[31mfails\033[0m    holds\n"
            "shown    pass\n");
}

TEST(Table, ShowsNoControlSequenceOfACell) {
  Table table({{"name"}});
  table.add({"a\033[31m\nb"});
  EXPECT_EQ(table.text(80, false), "  name\n  a\\x1b[31m\\nb\n");
}

}  // namespace mpmvv::cli::table_test
