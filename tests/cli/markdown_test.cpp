#include "cli/markdown.hpp"

#include <gtest/gtest.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <regex>
#include <string>

namespace mpmvv::cli::markdown_test {

/// What a terminal shows of it, without the blanks at the ends of lines.
std::string on_a_terminal(const std::string& markdown) {
  constexpr unsigned longest = 10;  // seconds
  const winsize size{25, 80, 0, 0};
  int terminal = -1;
  std::fflush(stdout);  // or the child has what is left there, too
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
  if (child == 0) {
    alarm(longest);
    print_markdown(markdown);
    std::fflush(stdout);
    _exit(0);
  }
  std::string shown;
  std::array<char, 4096> buffer{};
  for (ssize_t n; (n = read(terminal, buffer.data(), buffer.size())) > 0;)
    shown.append(buffer.data(), static_cast<std::size_t>(n));
  close(terminal);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  return std::regex_replace(shown, std::regex(" *\r\n"), "\n");
}

TEST(Markdown, OfATableHasKeysMeaningsAndInBracketsTheRest) {
  EXPECT_EQ(on_a_terminal("| key | unit | meaning |\n|---|---|---|\n| `a` | s | time |\n| `b` | | number |\n"),
            "key  meaning\na    time (unit s)\nb    number\n");
}

TEST(Markdown, OfATableSaysThatAKeyIsRequiredInThatWord) {
  EXPECT_EQ(on_a_terminal("| key | takes | without it | meaning |\n|---|---|---|---|\n"
                          "| `a` | text | **required** | name |\n| `b` | text | none | source |\n"),
            "key  meaning\na    name (takes text; required)\nb    source (takes text; without it none)\n");
}

TEST(Markdown, OfARowThatIsNotClosedOrTooShortShowsWhatIsThere) {
  EXPECT_EQ(on_a_terminal("| key | meaning |\n|---|---|\n| a | time\n| b |\n| c\n"), "key  meaning\na    time\nb\nc\n");
}

TEST(Markdown, OfATableWithOneColumnIsThatColumn) {
  EXPECT_EQ(on_a_terminal("| key |\n|---|\n| a |\n"), "key\na\n");
}

}  // namespace mpmvv::cli::markdown_test
