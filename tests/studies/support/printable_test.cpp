#include "studies/support/printable.hpp"

#include <gtest/gtest.h>

namespace mpmvv::support::printable_test {

TEST(Printable, TextStaysAsItIs) {
  for (const char* text : {"", "a b", "order ± 0.1", "Größe", "面", "\xf0\x9f\x98\x80", "C:\\x", "::error::"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, WhatATerminalObeysIsShown) {
  using namespace std::string_literals;
  const std::pair<std::string, std::string> shown[] = {
      {"a\n::error::b", "a\\n::error::b"},
      {"\t\r", "\\t\\r"},
      {"\x1b[2J\a", "\\x1b[2J\\x07"},
      {"a\0b"s, "a\\x00b"},
      {"\x7f", "\\x7f"},
      {"\xc2\x9b", "\\xc2\\x9b"},                    // CSI in one character
      {"\xe2\x80\xae", "\\xe2\\x80\\xae"},           // writes from right to left
      {"\xd8\x9c", "\\xd8\\x9c"},                    // marks letters as Arabic
      {"\xe2\x80\xa8", "\\xe2\\x80\\xa8"},           // a separator of lines
      {"a\xff", "a\\xff"},                           // not UTF-8:
      {"\xc2", "\\xc2"},                             // cut off
      {"\xc2z", "\\xc2z"},                           // not continued
      {"\xc0\x8a", "\\xc0\\x8a"},                    // a newline, longer than need be
      {"\xed\xa0\x80", "\\xed\\xa0\\x80"},           // half a pair of UTF-16
      {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},  // beyond the last character
  };
  for (const auto& [text, line] : shown) EXPECT_EQ(printable(text), line);
}

}  // namespace mpmvv::support::printable_test
