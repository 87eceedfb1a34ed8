#include "studies/support/toml_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "studies/support/error.hpp"
#include "tests/own_folder.hpp"

namespace mpmvv::support::toml_file_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TomlTable parse(const std::string& text) {
  return TomlTable::parse(text, "bar.toml");
}

template <class Action>
std::string message(Action action) {
  try {
    action();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no UsageError";
}

TEST(TomlFile, ReadsEveryType) {
  const TomlTable t =
      parse("name = \"bar\"\nppc = 4\ncfl = 0.2\nquick = true\ncells = [8, 16.5]\nclaims = [\"a\", \"b\"]\n");
  EXPECT_EQ(t.text("name"), "bar");
  EXPECT_EQ(t.number("ppc"), 4);
  EXPECT_EQ(t.number("cfl"), 0.2);
  EXPECT_TRUE(t.flag("quick", false));
  EXPECT_THAT(t.numbers("cells"), ElementsAre(8, 16.5));
  EXPECT_THAT(t.texts("claims"), ElementsAre("a", "b"));
}

TEST(TomlFile, AbsentKeysGiveTheDefaultOrAnErrorWithTheLineOfTheTable) {
  const TomlTable t = parse("\n[fit]\nfrom = 1\n");
  EXPECT_EQ(t.text("name", "none"), "none");
  EXPECT_EQ(t.number("ppc", 4), 4);
  EXPECT_TRUE(t.flag("quick", true));
  EXPECT_THAT(t.texts("claims"), IsEmpty());
  EXPECT_THAT(t.tables("series"), IsEmpty());
  EXPECT_FALSE(t.table("sweep").has_value());
  const TomlTable fit = t.table("fit").value();
  EXPECT_EQ(message([&] { fit.number("to"); }), "'to' is missing in bar.toml:2 (a finite number)");
  EXPECT_THAT(message([&] { t.numbers("cells"); }), HasSubstr("'cells' is missing in bar.toml:1"));
}

TEST(TomlFile, WrongTypesAreNamedWithTheirLine) {
  const TomlTable t = parse("a = \"x\"\nb = 1\nc = [1, \"x\"]\n[d]\n");
  EXPECT_EQ(message([&] { t.number("a"); }), "'a' is of type string in bar.toml:1 (a finite number)");
  EXPECT_EQ(message([&] { t.number("a", 1); }), "'a' is of type string in bar.toml:1 (a finite number)");
  EXPECT_THAT(message([&] { t.text("b"); }), HasSubstr("'b' is of type integer in bar.toml:2"));
  EXPECT_THAT(message([&] { t.flag("b", false); }), HasSubstr("(true or false)"));
  EXPECT_THAT(message([&] { t.numbers("c"); }), HasSubstr("'c' is of type string in bar.toml:3"));
  EXPECT_THAT(message([&] { t.texts("c"); }), HasSubstr("'c' is of type integer in bar.toml:3"));
  EXPECT_THAT(message([&] { t.table("b"); }), HasSubstr("(a table)"));
  EXPECT_THAT(message([&] { t.tables("c"); }), HasSubstr("bar.toml:3 (an array of tables)"));
  EXPECT_THAT(message([&] { t.tables("d"); }), HasSubstr("'d' is of type table in bar.toml:4"));
}

TEST(TomlFile, NumbersThatAreNotFiniteAreErrors) {
  const TomlTable t = parse("a = nan\nb = -inf\nc = [1, inf]\n");
  EXPECT_EQ(message([&] { t.number("a"); }), "'a' is nan in bar.toml:1 (a finite number)");
  EXPECT_EQ(message([&] { t.number("b", 0); }), "'b' is -inf in bar.toml:2 (a finite number)");
  EXPECT_THAT(message([&] { t.numbers("c"); }), HasSubstr("'c' is inf in bar.toml:3"));
  EXPECT_THAT(message([&] { t.scalar_text("a"); }), HasSubstr("'a' is nan"));
}

/// Beyond 2^53 not every integer is a double.
TEST(TomlFile, AnIntegerIsTheNearestNumber) {
  const TomlTable t = parse("a = -9007199254740993\nb = [10000000000000001, 9223372036854775807]\n");
  EXPECT_EQ(t.number("a"), -9007199254740992.0);
  EXPECT_EQ(t.number("a", 1), -9007199254740992.0);
  EXPECT_THAT(t.numbers("b"), ElementsAre(1e16, 9223372036854775808.0));
  EXPECT_EQ(t.scalar_text("a"), "-9007199254740993");
}

TEST(TomlFile, UnknownKeyIsNamedWithItsLineAndTheKnownOnes) {
  const TomlTable t = parse("basis = \"linear\"\n\nbase = 1\nanother = 2\n");
  EXPECT_EQ(message([&] {
              t.allow_only({"basis", "cells"});
            }),
            "unknown key 'base' in bar.toml:3 (known: basis, cells)");
  EXPECT_NO_THROW(t.allow_only({"basis", "base", "another"}));
}

TEST(TomlFile, KeysAndTablesKeepTheOrderAndLinesOfTheFile) {
  const TomlTable t = parse("z = 1\na = 2\n[[series]]\nname = \"second\"\n[[series]]\nname = \"first\"\n");
  EXPECT_THAT(t.keys(), ElementsAre("z", "a", "series"));
  const std::vector<TomlTable> series = t.tables("series");
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].text("name"), "second");
  EXPECT_EQ(series[1].where(), "bar.toml:5");
  EXPECT_EQ(series[1].where("name"), "bar.toml:6");
  EXPECT_EQ(series[1].where("absent"), "bar.toml:5");
}

TEST(TomlFile, InnerTablesOutliveTheDocument) {
  const TomlTable inner = parse("[fit]\nnorm = \"l2\"\n").table("fit").value();
  EXPECT_EQ(inner.text("norm"), "l2");
}

TEST(TomlFile, ScalarTextIsWhatAUserWouldType) {
  const TomlTable t = parse("a = 0.2\nb = 64\nc = \"cd\"\nd = true\ne = 1e-5\nf = [1]\n");
  EXPECT_EQ(t.scalar_text("a"), "0.2");
  EXPECT_EQ(t.scalar_text("b"), "64");
  EXPECT_EQ(t.scalar_text("c"), "cd");
  EXPECT_EQ(t.scalar_text("d"), "true");
  EXPECT_EQ(t.scalar_text("e"), "1e-05");
  EXPECT_THAT(message([&] { t.scalar_text("f"); }), HasSubstr("'f' is of type array in bar.toml:6"));
}

TEST(TomlFile, SyntaxErrorsAreOneLineWithFileAndLine) {
  for (const char* text : {"a = 1\nb = \n", "a = 1\na = 2\n", "\n[x\n", "\na = \"\xff\"\n", "\na = 1 b = 2\n"}) {
    const std::string wrong = message([&] { parse(text); });
    EXPECT_THAT(wrong, HasSubstr("invalid TOML in bar.toml:2 (")) << text;
    EXPECT_THAT(wrong, Not(HasSubstr("\n")));
  }
  EXPECT_THAT(message([] { parse("problem = bar\n"); }), HasSubstr("; a text stands in quotes)"));
  EXPECT_THAT(message([] { parse("title = \"abc\nb = 1\n"); }), HasSubstr("; is a closing quote missing?)"));
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

/// Each level of tables and arrays takes a piece of the stack.
TEST(TomlFile, WhatIsTooDeepIsAnErrorWithItsLine) {
  constexpr int much = 100'000;
  for (const std::string& text :
       {repeated("a.", much) + "a = 1", "[" + repeated("a.", much) + "a]", "[[" + repeated("a . ", much) + "a]]",
        repeated("\"=,\\\"]\".", much) + "a = 1", repeated("'#'.", much) + "a = 1",
        "a = { b = { " + repeated("c.", much) + "d = 1 } }", "a = " + repeated("[", much) + repeated("]", much),
        "a = " + repeated("{ a = ", much) + "1" + repeated(" }", much),
        "a = " + repeated("[\n", 1000) + repeated("]", 1000), "b = ']]]]'\na = " + repeated("[", 100),
        "x = { a = \"\"\"a\"\"\"\", " + repeated("b.", much) + "c = 1 }",
        "x = { a = '''a''''', " + repeated("b.", much) + "c = 1 }"})
    EXPECT_THAT(message([&] { parse("x = 1\n" + text); }),
                AllOf(HasSubstr("too deep in one another in bar.toml:"), Not(HasSubstr("bar.toml:1 "))))
        << text.substr(0, 20);
}

TEST(TomlFile, WhatIsOnlyLongIsRead) {
  const std::string dots = repeated("a.", 1000);
  const TomlTable t = parse("s = \"" + dots + "\"\nl = '" + dots + "'\nm = \"\"\"\n" + dots + "\n" +
                            repeated("[", 1000) + "\"\"\"  # " + dots + "\nn = [" + repeated("0.5, ", 1000) +
                            "]\np = [" + repeated("[1.5], ", 1000) + "]\n" + repeated("k.", 20) + "k = 1\n");
  EXPECT_EQ(t.text("s"), dots);
  EXPECT_EQ(t.text("l"), dots);
  EXPECT_EQ(t.numbers("n").size(), 1000U);
}

class TomlFileOnDisk : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(directory); }
  const std::filesystem::path directory = own_folder("toml-file-test");
};

TEST_F(TomlFileOnDisk, ReadsAFileAndNamesItInMessages) {
  const std::filesystem::path file = directory / "bar.toml";
  std::ofstream(file) << "a = 1\nb = \"x\"\n";
  const TomlTable t = TomlTable::read(file);
  EXPECT_EQ(t.number("a"), 1);
  EXPECT_THAT(message([&] { t.number("b"); }), HasSubstr(file.string() + ":2"));
}

TEST_F(TomlFileOnDisk, AbsentFilesAndDirectoriesAreErrors) {
  EXPECT_THAT(message([&] { TomlTable::read(directory / "absent.toml"); }),
              AllOf(HasSubstr("absent.toml"), HasSubstr("No such file")));
  EXPECT_THAT(message([&] { TomlTable::read(directory); }), HasSubstr("a directory"));
}

TEST_F(TomlFileOnDisk, AnEmptyFileIsAnEmptyTable) {
  const std::ofstream empty(directory / "empty.toml");
  EXPECT_THAT(TomlTable::read(directory / "empty.toml").keys(), IsEmpty());
}

}  // namespace mpmvv::support::toml_file_test
