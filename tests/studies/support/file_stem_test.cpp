#include <gtest/gtest.h>

#include "studies/support/file.hpp"

namespace mpmvv::support::file_stem_test {

TEST(FileStem, StaysInItsFolder) {
  for (const std::string& good : {std::string("s-fig10"), std::string("usl+_2.a"), std::string(100, 'a')})
    EXPECT_TRUE(is_file_stem(good)) << good;
  for (const char* bad : {"", ".hidden", "..", "a/b", "a b", "-d", "a'b", "é"}) EXPECT_FALSE(is_file_stem(bad)) << bad;
  EXPECT_FALSE(is_file_stem(std::string(101, 'a')));
}

}  // namespace mpmvv::support::file_stem_test
