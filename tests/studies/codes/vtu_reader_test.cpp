#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ctime>

#include "studies/codes/readers.hpp"

namespace mpmvv::codes::vtu_reader_test {

/// A point and 200 arrays that all are the first bytes of 20 MB: a header and the numbers 1, 2 and 3.
TEST(VtuReader, ReadsOfAppendedDataWhatAnArrayHas) {
  const std::string array =
      R"(<DataArray type="Int8" Name="a{}" NumberOfComponents="3" format="appended" offset="0"/>)";
  std::string arrays;
  for (int k = 0; k < 200; ++k) arrays += fmt::format(fmt::runtime(array), k);
  std::string behind;
  behind.resize(20'000'000, 'A');
  for (const bool is_base64 : {true, false}) {
    const std::string content = fmt::format(
        R"(<VTKFile><PolyData><Piece NumberOfPoints="1"><Points>{}</Points><PointData>{}</PointData></Piece>)"
        R"(</PolyData><AppendedData encoding="{}">_{}{}</AppendedData></VTKFile>)",
        fmt::format(fmt::runtime(array), ""), arrays, is_base64 ? "base64" : "raw",
        is_base64 ? "AwAAAAECAw==" : std::string("\3\0\0\0\1\2\3", 7), behind);
    const std::clock_t begin = std::clock();
    const ParticleTable table = read_vtu({content, "file"});
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 1) << is_base64;
    ASSERT_EQ(table.columns.size(), 603U);
    EXPECT_EQ(table.columns.back().values.at(0), 3);
  }
}

}  // namespace mpmvv::codes::vtu_reader_test
