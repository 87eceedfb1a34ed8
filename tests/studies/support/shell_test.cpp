#include "studies/support/shell.hpp"

#include <gtest/gtest.h>

namespace mpmvv::support::shell_test {

TEST(ShellWord, IsQuotedWhereAShellWouldTakeItApart) {
  for (const char* plain : {"results.db", "a/b-c_d", "xmin=free,xmax=wall", "-1.5e+3"})
    EXPECT_EQ(shell_word(plain), plain);
  EXPECT_EQ(shell_word("my file"), "'my file'");
  EXPECT_EQ(shell_word("{a,b}"), "'{a,b}'");
  EXPECT_EQ(shell_word("it's"), R"('it'\''s')");
  EXPECT_EQ(shell_word(""), "''");
}

TEST(ShellQuoted, IsQuotedWhateverItIs) {
  EXPECT_EQ(shell_quoted("plain"), "'plain'");
  EXPECT_EQ(shell_quoted("$HOME 'and' more"), R"('$HOME '\''and'\'' more')");
}

}  // namespace mpmvv::support::shell_test
