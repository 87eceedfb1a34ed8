#include "studies/support/kept_output.hpp"

#include <gtest/gtest.h>

namespace mpmvv::support::kept_output_test {

TEST(KeptOutput, IsAllOfALittle) {
  KeptOutput output(10);
  for (const char* text : {"abc", "", "defghij", "klmnopqrst"}) output.append(text);
  EXPECT_EQ(output.text(), "abcdefghijklmnopqrst");
}

TEST(KeptOutput, IsBothEndsOfALot) {
  KeptOutput output(4);
  for (int k = 0; k < 1000; ++k) output.append("0123456789");
  EXPECT_EQ(output.text(), "0123\n[9992 bytes left out]\n6789");
  EXPECT_EQ(output.text(), "0123\n[9992 bytes left out]\n6789");
}

}  // namespace mpmvv::support::kept_output_test
