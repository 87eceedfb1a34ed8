#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/mutation/code_tokens.hpp"
#include "tests/mutation/operators.hpp"

namespace mpmvv::mutation::code_test {

TEST(Edits, LinesAreWholeWithoutTheirIndentation) {
  const std::string text = "first\n  second line\n  third\n";
  EXPECT_EQ(line_of(text, text.find("line")), 2);
  EXPECT_EQ(lines_at(text, text.find("line"), 4), "second line");
  EXPECT_EQ(lines_at(text, text.find("line"), 9), "second line\n  third");
  EXPECT_EQ(lines_at(text, 0, 1), "first");
}

std::vector<std::string> texts_of(const std::string& code) {
  std::vector<std::string> texts;
  for (const Token& token : tokens_of(code)) texts.emplace_back(token.text);
  return texts;
}

TEST(CodeTokens, CommentsStringsAndDirectivesAreLeftOut) {
  EXPECT_THAT(
      texts_of("#define A 1 + 2\n"
               "a = \"b \\\" + c\" + 'd';  // + e\n"
               "/* f + */ g(R\"x(h + )\" )x\", 1e-3);\n"
               "[[gnu::noinline]] i->j >= 10'000;"),
      testing::ElementsAre("a", "=", "+", ";", "g", "(", ",", "1e-3", ")", ";", "i", "->", "j", ">=", "10'000", ";"));
}

TEST(CodeTokens, TemplateBracketsAreToldFromComparisons) {
  const std::string code = "std::vector<std::array<int, 2 + 1>> a = b < c && d > e ? f<3>(1) : 4 >> 5;";
  std::string inside;
  for (const Token& token : tokens_of(code))
    if (token.in_brackets) inside += token.text;
  EXPECT_EQ(inside, "<std::array<int,2+1>><3>");
}

/// "before becomes after" for every mutation of a code.
std::vector<std::string> changes(const std::string& code) {
  std::vector<std::string> all;
  for (const Edit& edit : mutations_of("a.cpp", code)) all.push_back(edit.before + " becomes " + edit.after);
  return all;
}

TEST(Mutations, OperatorsOperandsAndNumbersChange) {
  EXPECT_THAT(changes("a = b + c;"), testing::ElementsAre("+ becomes -"));
  EXPECT_THAT(changes("a = -b * c;"), testing::ElementsAre("- becomes ", "* becomes /"));
  EXPECT_THAT(changes("a += b; c *= d;"), testing::ElementsAre("+= becomes -=", "*= becomes /="));
  EXPECT_THAT(changes("return a < b;"), testing::ElementsAre("< becomes <=", "< becomes >"));
  EXPECT_THAT(changes("if (a == b) c(d != e);"), testing::ElementsAre("== becomes !=", "!= becomes =="));
  EXPECT_THAT(changes("a = 0.5; b = 0.25; c = 2;"),
              testing::ElementsAre("0.5 becomes 1", "0.25 becomes (2 * 0.25)", "2 becomes 3"));
  EXPECT_THAT(changes("x[d] = F(c, d);"), testing::ElementsAre("d becomes 0", "c, d becomes d, c"));
  EXPECT_THAT(changes("f(i, x[j]);"), testing::ElementsAre("j becomes i"));
  EXPECT_THAT(changes("f(true);"), testing::ElementsAre("true becomes false"));
}

TEST(Mutations, WhatIsNoOperationStays) {
  for (const char* code :
       {"double* a; const Vec<D>& b = *c;", "std::array<double, 3> a;", "virtual void f() const = 0;", "a->b();",
        "out << a << b;", "// a + 1", "#include <a+1>", "s = \"a + 1\";", "static_assert(a == 2);", "case 3:", "++i;"})
    EXPECT_THAT(changes(code), testing::IsEmpty()) << code;
}

std::vector<Edit> numbered(int count) {
  std::vector<Edit> edits;
  for (int k = 0; k < count; ++k) edits.push_back({"a.cpp", static_cast<std::size_t>(k), "", ""});
  return edits;
}

TEST(Mutations, TheSeedAloneDecidesTheDraw) {
  std::vector<std::size_t> places;
  for (const Edit& edit : shuffled(numbered(10), 1)) places.push_back(edit.at);
  EXPECT_THAT(places, testing::UnorderedElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9));
  std::vector<std::size_t> again, other;
  for (const Edit& edit : shuffled(numbered(10), 1)) again.push_back(edit.at);
  for (const Edit& edit : shuffled(numbered(10), 2)) other.push_back(edit.at);
  EXPECT_EQ(places, again);
  EXPECT_NE(places, other);
}

}  // namespace mpmvv::mutation::code_test
