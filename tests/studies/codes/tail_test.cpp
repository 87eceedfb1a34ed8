#include <gmock/gmock.h>

#include "studies/codes/run_command.hpp"

namespace mpmvv::codes::tail_test {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

const std::string blanks(150, ' ');

TEST(Tail, IsOnOneLineWithoutMarksAndBlanks) {
  EXPECT_EQ(tail_of("no such mesh\n"), "no such mesh");
  EXPECT_EQ(tail_of("load.c:3:10: error:  no\tfoo\n    3 |" + blanks + "foo;\n      |" + blanks + "^~~\n\n---\n"),
            "load.c:3:10: error: no foo 3 | foo;");
  for (const char* nothing : {"", "\n \n", "^~~~\n|\n"}) EXPECT_EQ(tail_of(nothing), "it printed nothing") << nothing;
}

/// What a compiler says of a mistake in a long line, and what the shell's make says after it.
TEST(Tail, BeginsAtAnErrorNearTheEnd) {
  std::string log = "began\n";
  for (int k = 0; k < 100; ++k) log += "warning of line " + std::to_string(k) + "\n";
  EXPECT_EQ(tail_of(log + "load.c:3: Error: foo\n 3 | foo\n   | ^~~\nmake: *** error 1\n"),
            "...load.c:3: Error: foo 3 | foo make: *** error 1");
  const std::string far(450, 'x');
  EXPECT_THAT(tail_of(log + "load.c:3: error: foo\n" + far),
              AllOf(StartsWith("...load.c:3: error: foo xxx"), EndsWith("xxx..."), SizeIs(406)));
}

TEST(Tail, IsTheEndWithoutAnError) {
  std::string log;
  for (int k = 0; k < 1000; ++k) log += "step " + std::to_string(k) + "\n";
  EXPECT_THAT(tail_of(log), AllOf(StartsWith("..."), EndsWith("step 998 step 999"), SizeIs(403)));
  EXPECT_THAT(tail_of("an error\n" + log), Not(HasSubstr("error"))) << "it is of long before";
}

TEST(Tail, CutsNoCharacter) {
  std::string text;
  while (text.size() < 1000) text += "μ";
  const std::string tail = tail_of("x" + text), from_error = tail_of("error" + text);
  EXPECT_EQ((tail.size() - 3) % 2, 0U);
  EXPECT_EQ(tail.substr(3, 2), "μ");
  EXPECT_THAT(from_error, EndsWith("μ..."));
}

}  // namespace mpmvv::codes::tail_test
