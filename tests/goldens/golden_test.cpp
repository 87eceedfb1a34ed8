#include "goldens/golden.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "studies/support/error.hpp"
#include "tests/own_folder.hpp"

namespace mpmvv::goldens::golden_test {

using testing::AllOf;
using testing::HasSubstr;

/// One table under `study`, which takes the first line; the table starts on line 2.
std::vector<Golden> parse(const std::string& table) {
  return parse_goldens("study = \"s\"\n" + table, "s.toml");
}

template <class Action>
std::string message(Action action) {
  try {
    action();
  } catch (const support::UsageError& error) {
    return error.what();
  }
  return "no UsageError";
}

std::string rejection(const std::string& table) {
  return message([&] { parse(table); });
}

std::string order(const std::string& numbers) {
  return "[[order]]\nseries = \"linear\"\nnorm = \"l2\"\n" + numbers + "\n";
}

TEST(Golden, ReadsEveryKind) {
  const auto goldens = parse(
      "reviewed = \"2026-11-21: agrees with Fig. 10\"\n"
      "[[order]]\nseries = \"linear\"\nnorm = \"l2\"\nexpected = 2\nlower = 1.85\nupper = 2.15\n"
      "[[error]]\nseries = \"linear\"\nnorm = \"linf\"\nat = 512\nexpected = 1e-5\nband = 0.1\n"
      "[[limit]]\nseries = \"linear\"\nexpected = 0.8\nband = 0.05\n"
      "[[value]]\nname = \"partition\"\nat_most = 1e-14\n"
      "[[status]]\nseries = \"linear\"\nat = 64\nexpected = \"unstable\"\n");
  ASSERT_EQ(goldens.size(), 5U);
  const auto& fit = std::get<OrderGolden>(goldens[0].expectation);
  EXPECT_EQ(fit.lower, 1.85);
  EXPECT_EQ(fit.upper, 2.15);
  const auto& error = std::get<ErrorGolden>(goldens[1].expectation);
  EXPECT_EQ(error.at, 512);
  EXPECT_EQ(error.expected, 1e-5);
  EXPECT_EQ(std::get<LimitGolden>(goldens[2].expectation).expected, 0.8);
  EXPECT_EQ(std::get<ValueGolden>(goldens[3].expectation).upper, 1e-14);
  EXPECT_EQ(std::get<StatusGolden>(goldens[4].expectation).expected, records::Status::unstable);
  EXPECT_EQ(goldens[1].study, "s");
  EXPECT_EQ(goldens[1].where, "s.toml:9");
  EXPECT_EQ(subject(goldens[1]), "error of 'linear' in linf at 512");
  EXPECT_EQ(expected_text(goldens[0]), "2 in [1.85, 2.15]");
  EXPECT_EQ(expected_text(goldens[2]), "0.8 ± 5 %");
  EXPECT_EQ(expected_text(goldens[3]), "at most 1e-14");
}

TEST(Golden, ExpectedValueIsAnIntervalOnEitherSide) {
  const auto value =
      std::get<ValueGolden>(parse("[[value]]\nname = \"slope\"\nexpected = -2.0\nband = 0.1\n")[0].expectation);
  EXPECT_DOUBLE_EQ(value.lower, -2.2);
  EXPECT_DOUBLE_EQ(value.upper, -1.8);
}

TEST(Golden, OrdersMayBeNegative) {
  EXPECT_EQ(parse(order("expected = -0.5\nlower = -0.6\nupper = -0.4")).size(), 1U);
}

TEST(Golden, AWiderBandNeedsAReason) {
  EXPECT_EQ(rejection(order("expected = 2\nlower = 1.8\nupper = 2.1")),
            "a band of 0.2 without 'why' in s.toml:2 (orders within 0.15, unless why = \"...\" justifies a wider one)");
  EXPECT_THAT(rejection(order("expected = 2\nlower = 1.9\nupper = 2.2")), HasSubstr("without 'why'"));
  EXPECT_THAT(rejection("[[error]]\nseries = \"a\"\nnorm = \"l2\"\nat = 8\nexpected = 1\nband = 0.11\n"),
              HasSubstr("errors within 10 %"));
  EXPECT_THAT(rejection("[[limit]]\nseries = \"a\"\nexpected = 1\nband = 0.06\n"), HasSubstr("limits within 5 %"));
  EXPECT_THAT(rejection("[[value]]\nname = \"a\"\nexpected = 1\nband = 0.2\n"), HasSubstr("check values within 10 %"));
  EXPECT_THAT(rejection(order("expected = 2\nlower = 1.8\nupper = 2.1\nwhy = \" \"")), HasSubstr("'why' is blank"));
  EXPECT_EQ(parse(order("expected = 2\nlower = 1.8\nupper = 2.1\nwhy = \"the plateau bends the fit\"")).size(), 1U);
}

TEST(Golden, UnknownKeysAndWordsAreErrors) {
  EXPECT_THAT(rejection("[[orders]]\nseries = \"a\"\n"), HasSubstr("unknown key 'orders' in s.toml:2"));
  EXPECT_THAT(rejection(order("expected = 2\nlower = 1.9\nupper = 2.1\ntolerance = 1")),
              HasSubstr("unknown key 'tolerance' in s.toml:8"));
  EXPECT_THAT(rejection("[[error]]\nseries = \"a\"\nnorm = \"l3\"\nat = 8\nexpected = 1\nband = 0.1\n"),
              AllOf(HasSubstr("unknown norm 'l3' in s.toml:4"), HasSubstr("l1, l2, linf")));
  EXPECT_THAT(rejection("[[status]]\nseries = \"a\"\nat = 8\nexpected = \"failed\"\n"),
              HasSubstr("unknown status 'failed' in s.toml:5 (known: ok, unstable)"));
}

TEST(Golden, NumbersThatMakeNoSenseAreErrors) {
  EXPECT_THAT(rejection(order("expected = nan\nlower = 1.9\nupper = 2.1")), HasSubstr("'expected' is nan in s.toml:5"));
  EXPECT_THAT(rejection(order("expected = 2\nlower = 2.05\nupper = 2.1")), HasSubstr("lower <= expected <= upper"));
  EXPECT_THAT(rejection(order("expected = 2.2\nlower = 1.9\nupper = 2.1")), HasSubstr("lower <= expected <= upper"));
  EXPECT_THAT(rejection(order("expected = 2\nlower = 2\nupper = 2")), HasSubstr("lower < upper"));
  const std::string error = "[[error]]\nseries = \"a\"\nnorm = \"l2\"\n";
  EXPECT_THAT(rejection(error + "at = 8\nexpected = -1\nband = 0.1\n"), HasSubstr("'expected' is -1 in s.toml:6"));
  EXPECT_THAT(rejection(error + "at = 8\nexpected = 0\nband = 0.1\n"), HasSubstr("'expected' is 0 in s.toml:6"));
  EXPECT_THAT(rejection(error + "at = -8\nexpected = 1\nband = 0.1\n"), HasSubstr("'at' is -8 in s.toml:5"));
  EXPECT_THAT(rejection(error + "at = 8\nexpected = 1\nband = 0\n"), HasSubstr("'band' is 0 in s.toml:7"));
  EXPECT_THAT(rejection(error + "at = 8\nexpected = 1\n"), HasSubstr("'band' is missing in s.toml:2"));
  EXPECT_THAT(rejection("[[limit]]\nseries = \"a\"\nexpected = -0.8\nband = 0.05\n"), HasSubstr("'expected' is -0.8"));
  EXPECT_THAT(rejection("[[limit]]\nseries = \"\"\nexpected = 0.8\nband = 0.05\n"), HasSubstr("'series' is blank"));
}

/// What every number of every kind of golden may not be.
TEST(Golden, NoNumberIsTakenUnchecked) {
  const std::string band = "expected = 2\nlower = 1.9\nupper = 2.1\n",
                    error = "[[error]]\nseries = \"a\"\nnorm = \"l2\"\n";
  const std::string limit = "[[limit]]\nseries = \"a\"\n", value = "[[value]]\nname = \"a\"\n";
  const auto expect_refused = [](const std::string& head, const std::string& key, const std::vector<std::string>& bad) {
    for (const std::string& text : bad) {
      const std::string said = rejection(head + key + " = " + text + "\n");
      EXPECT_THAT(said, AllOf(HasSubstr("in s.toml:"), HasSubstr("("))) << head << key << " = " << text;
    }
  };
  const std::vector<std::string> positive{"-1", "0", "1e300", "nan", "inf", "\"1\""},
      any{"-1e300", "1e300", "nan", "inf"};
  expect_refused(order(band), "points", {"-1", "0", "2", "3.9", "1e300", "nan", "inf", "9999999"});
  expect_refused(order(band), "interval", positive);
  expect_refused(order(band), "interval", {"1.01"});
  expect_refused(order(band), "window",
                 {"[16]", "[64, 16]", "[16, 16]", "[-16, 64]", "[0, 64]", "[16, 1e300]", "[1, nan]"});
  expect_refused(order(band), "finest",
                 {"[64]", "[64, 0]", "[64, -1]", "[64, 1e300]", "[-64, 1]", "[1e300, 1]", "[64, inf]"});
  expect_refused(order(band + "window = [16, 64]"), "finest", {"[128, 1e-9]", "[8, 1e-9]"});
  expect_refused(order("lower = -1e300\nupper = 1e300\nwhy = \"w\""), "expected", any);
  expect_refused(order("expected = 2\nupper = 3\nwhy = \"w\""), "lower", any);
  expect_refused(order("expected = 2\nlower = 1\nwhy = \"w\""), "upper", any);
  expect_refused(error + "expected = 1\nband = 0.1\n", "at", positive);
  expect_refused(error + "at = 8\nband = 0.1\n", "expected", positive);
  expect_refused(error + "at = 8\nexpected = 1\nwhy = \"w\"\n", "band", positive);
  expect_refused(error + "at = 8\nexpected = 1\nwhy = \"w\"\n", "band", {"1", "1.5"});
  expect_refused(limit + "band = 0.05\n", "expected", positive);
  expect_refused(limit + "expected = 1\nwhy = \"w\"\n", "band", positive);
  expect_refused(limit + "expected = 1\nwhy = \"w\"\n", "band", {"1"});
  expect_refused(value, "at_most", any);
  expect_refused(value, "at_least", any);
  expect_refused(value + "band = 0.1\n", "expected", any);
  expect_refused(value + "expected = 1\nwhy = \"w\"\n", "band", positive);
  expect_refused("[[status]]\nseries = \"a\"\nexpected = \"ok\"\n", "at", positive);
}

TEST(Golden, NumbersAtTheEdgeAreTaken) {
  const auto golden = std::get<OrderGolden>(
      parse(order("expected = 2\nlower = 1.9\nupper = 2.1\nwindow = [16, 64]\npoints = 3\ninterval = 1\n"
                  "finest = [64, 1e-4]\nasymptotic = true"))[0]
          .expectation);
  EXPECT_THAT(golden.window, testing::ElementsAre(16, 64));
  EXPECT_THAT(golden.finest, testing::ElementsAre(64, 1e-4));
  EXPECT_EQ(golden.points, 3);
  EXPECT_EQ(golden.interval, 1);
  EXPECT_TRUE(golden.asymptotic);
  const std::string wide = "expected = 0\nlower = -2\nupper = 0.5\nwhy = \"w\"\n";
  EXPECT_EQ(parse(order(wide + "interval = 2.5")).size(), 1U) << "as wide as its band";
  EXPECT_THAT(rejection(order(wide + "interval = 2.6")), HasSubstr("'interval' is 2.6 in s.toml:9 (at most 2.5"));
}

TEST(Golden, IsReviewedWhereItsFileSaysSo) {
  const std::string value = "[[value]]\nname = \"a\"\nat_most = 1\n";
  EXPECT_FALSE(parse(value)[0].reviewed);
  EXPECT_TRUE(parse("reviewed = \"2026-11-21: by whom\"\n" + value)[0].reviewed);
  EXPECT_THAT(rejection("reviewed = \" \"\n" + value), HasSubstr("'reviewed' is blank in s.toml:2"));
}

/// The word of a reviewer stands in every file of the tree.
TEST(Golden, ThoseOfTheTreeAreReviewed) {
  for (const Golden& golden : read_goldens(MPMVV_SOURCE_DIR "/goldens")) EXPECT_TRUE(golden.reviewed) << golden.where;
}

TEST(Golden, AValueHasExactlyOneKindOfBound) {
  const std::string value = "[[value]]\nname = \"a\"\n";
  const char* rule = "(at_most, or at_least, or expected with band)";
  EXPECT_THAT(rejection(value), HasSubstr(rule));
  EXPECT_THAT(rejection(value + "at_most = 1\nat_least = 0\n"), HasSubstr(rule));
  EXPECT_THAT(rejection(value + "at_most = 1\nexpected = 1\nband = 0.1\n"), HasSubstr(rule));
  EXPECT_THAT(rejection(value + "at_most = 1\nband = 0.1\n"), HasSubstr("'band' without 'expected' in s.toml:5"));
  EXPECT_THAT(rejection(value + "expected = 1\n"), HasSubstr("'band' is missing"));
  EXPECT_THAT(rejection(value + "expected = 0\nband = 0.1\n"), HasSubstr("'expected' is 0"));
}

TEST(Golden, TwoGoldensForOneThingAreAnError) {
  EXPECT_THAT(rejection("[[status]]\nseries = \"a\"\nat = 64\nexpected = \"ok\"\n"
                        "[[status]]\nseries = \"a\"\nat = 64.0\nexpected = \"unstable\"\n"),
              AllOf(HasSubstr("a second golden for the status of 'a' at 64 of study 's' in s.toml:6"),
                    HasSubstr("the first is in s.toml:2")));
  EXPECT_EQ(parse("[[status]]\nseries = \"a\"\nat = 64\nexpected = \"ok\"\n"
                  "[[status]]\nseries = \"a\"\nat = 128\nexpected = \"ok\"\n")
                .size(),
            2U);
}

TEST(Golden, AFileThatExpectsNothingIsAnError) {
  EXPECT_THAT(rejection(""), HasSubstr("no expectation in s.toml:1"));
  EXPECT_THAT(message([] { parse_goldens("", "s.toml"); }), HasSubstr("'study' is missing in s.toml"));
  EXPECT_THAT(message([] { parse_goldens("study = \"\"\n", "s.toml"); }), HasSubstr("'study' is blank in s.toml:1"));
}

class GoldenDirectory : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(directory); }
  void write(const std::string& file, const std::string& study) const {
    std::ofstream(directory / file) << "study = \"" << study << "\"\n[[value]]\nname = \"a\"\nat_most = 1\n";
  }
  const std::filesystem::path directory = own_folder("golden-test");
};

TEST_F(GoldenDirectory, ReadsItsTomlFilesByName) {
  write("b.toml", "second");
  write("a.toml", "first");
  write("notes.txt", "ignored");
  const auto goldens = read_goldens(directory);
  ASSERT_EQ(goldens.size(), 2U);
  EXPECT_EQ(goldens[0].study, "first");
  EXPECT_EQ(goldens[1].where, (directory / "b.toml").string() + ":2");
}

TEST_F(GoldenDirectory, DuplicatesAcrossFilesAreErrors) {
  write("a.toml", "same");
  write("b.toml", "same");
  EXPECT_THAT(message([&] { read_goldens(directory); }), AllOf(HasSubstr("b.toml:2"), HasSubstr("a.toml:2")));
}

TEST_F(GoldenDirectory, NothingToReadIsAnError) {
  EXPECT_THAT(message([&] { read_goldens(directory); }), AllOf(HasSubstr("no golden in"), HasSubstr("mpmvv propose")));
  EXPECT_THAT(message([&] { read_goldens(directory / "absent"); }),
              AllOf(HasSubstr("no directory"), HasSubstr("mpmvv propose")));
  EXPECT_THAT(message([&] { require_directory(directory / "absent"); }), HasSubstr("no directory"));
  EXPECT_THAT(message([] { require_directory("my bands"); }), HasSubstr("--out 'my bands/NAME.toml'`"));
  EXPECT_NO_THROW(require_directory(directory));
  EXPECT_FALSE(has_goldens(directory));
  EXPECT_FALSE(has_goldens(directory / "absent"));
  write("a.toml", "first");
  EXPECT_TRUE(has_goldens(directory));
}

}  // namespace mpmvv::goldens::golden_test
