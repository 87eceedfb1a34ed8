#include "solver/array.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>

#include "solver/simd/padded.hpp"

namespace mpmvv::solver::array_test {

constexpr std::size_t page = HugePages<double>::page;

template <class T>
bool begins_at_multiple_of(std::size_t alignment, const Array<T>& array) {
  return reinterpret_cast<std::uintptr_t>(array.data()) % alignment == 0;
}

/// What the system says of the memory at an address: "VmFlags: rd wr ...".
std::string flags_of(const void* address) {
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream smaps("/proc/self/smaps");
  bool holds = false;
  for (std::string line; std::getline(smaps, line);) {
    std::istringstream words(line);
    std::uintptr_t begin = 0, end = 0;
    char dash = 0;
    if (words >> std::hex >> begin >> dash >> end && dash == '-') holds = begin <= wanted && wanted < end;
    if (holds && line.starts_with("VmFlags:")) return line;
  }
  return "";
}

TEST(ArrayMemory, BeginsOnAHugePageWhereItFillsOne) {
  EXPECT_TRUE(begins_at_multiple_of(page, Array<double>(page / sizeof(double))));
  EXPECT_TRUE(begins_at_multiple_of(page, Array<std::uint32_t>(page)));
}

TEST(ArrayMemory, AsksForHugePagesWhereItFillsSome) {
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage/enabled")) GTEST_SKIP() << "a system without any";
  const Array<double> large(20 * page / sizeof(double));
  EXPECT_THAT(flags_of(large.data() + 10 * page / sizeof(double)), testing::HasSubstr(" hg "));
}

TEST(ArrayMemory, IsAlignedAsItsValuesAre) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{3}, page / sizeof(Padded<4>) - 1})
    EXPECT_TRUE(begins_at_multiple_of(alignof(Padded<4>), Array<Padded<4>>(count))) << count;
}

TEST(ArrayMemory, KeepsValuesWhenItGrowsAndShrinks) {
  const std::size_t few = 1000, many = 3 * page / sizeof(double) + 7;
  Array<double> array(few);
  std::iota(array.begin(), array.end(), 0.0);
  array.resize(many, -1);
  for (std::size_t k = 0; k < many; ++k) ASSERT_EQ(array[k], k < few ? static_cast<double>(k) : -1) << k;
  array.resize(few);
  array.shrink_to_fit();
  for (std::size_t k = 0; k < few; ++k) ASSERT_EQ(array[k], static_cast<double>(k)) << k;
}

}  // namespace mpmvv::solver::array_test
