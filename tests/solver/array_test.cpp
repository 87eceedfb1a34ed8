#include "solver/array.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

#include "solver/simd/padded.hpp"

namespace mpmvv::solver::array_test {

constexpr std::size_t page = HugePages<double>::page;

template <class T>
std::uintptr_t past(const Array<T>& array, std::size_t alignment) {
  return reinterpret_cast<std::uintptr_t>(array.data()) % alignment;
}

TEST(ArrayMemory, BeginsOnAHugePageWhereItFillsOne) {
  EXPECT_EQ(past(Array<double>(page / sizeof(double)), page), 0U);
  EXPECT_EQ(past(Array<std::uint32_t>(page), page), 0U);
}

TEST(ArrayMemory, IsAlignedAsItsValuesAre) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{3}, page / sizeof(Padded<4>) - 1})
    EXPECT_EQ(past(Array<Padded<4>>(count), alignof(Padded<4>)), 0U) << count;
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
