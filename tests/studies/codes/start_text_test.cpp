#include "studies/codes/start_text.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/studies/codes/csv_parts.hpp"

namespace mpmvv::codes::start_text_test {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double pi = std::numbers::pi;

StartState two_particles(int dimension) {
  StartState state;
  state.dimension = dimension;
  state.id = {1, 2};
  state.X = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  state.x = {{1.1, 1.2, 1.3}, {1.4, 1.5, pi}};
  state.v = {{2.1, 2.2, 2.3}, {2.4, 2.5, 2.6}};
  state.m = {3.1, 3.2};
  state.V = {4.1, 4.2};
  state.F = {{1, 2, 3, 4, 5, 6, 7, 8, 9}, {-1, -2, -3, -4, -5, -6, -7, -8, 1 / pi}};
  return state;
}

TEST(StartText, HasTheColumnsOfTheDimension) {
  const auto line = lines_of(csv_text(two_particles(1)));
  ASSERT_EQ(line.size(), 3U);
  EXPECT_EQ(line[0], "id,X,x,v_x,m,V,F_xx");
  EXPECT_THAT(numbers(line[1]), ElementsAre(1, 0.1, 1.1, 2.1, 3.1, 4.1, 1));
  const auto plane = lines_of(csv_text(two_particles(2)));
  EXPECT_EQ(plane[0], "id,X,Y,x,y,v_x,v_y,m,V,F_xx,F_xy,F_yx,F_yy");
  EXPECT_THAT(numbers(plane[1]), ElementsAre(1, 0.1, 0.2, 1.1, 1.2, 2.1, 2.2, 3.1, 4.1, 1, 2, 4, 5));
}

TEST(StartText, KeepsEveryDigit) {
  const auto line = lines_of(csv_text(two_particles(3)));
  EXPECT_EQ(line[0], "id,X,Y,Z,x,y,z,v_x,v_y,v_z,m,V,F_xx,F_xy,F_xz,F_yx,F_yy,F_yz,F_zx,F_zy,F_zz");
  const auto second = numbers(line[2]);
  ASSERT_EQ(second.size(), 21U);
  EXPECT_EQ(second[6], pi);
  EXPECT_EQ(second[20], 1 / pi);
}

TEST(StartText, GivesParaViewNumberedParticlesWithTheirFields) {
  const std::string text = vtu_text(two_particles(3));
  EXPECT_THAT(text, HasSubstr("<Piece NumberOfPoints=\"2\" NumberOfCells=\"2\">"));
  EXPECT_THAT(text, HasSubstr("<DataArray type=\"Int64\" Name=\"id\" format=\"ascii\">\n1\n2\n</DataArray>"));
  EXPECT_THAT(text, HasSubstr("Name=\"reference_volume\" NumberOfComponents=\"1\" format=\"ascii\">\n"
                              "4.0999999999999996\n4.2000000000000002\n"));
  EXPECT_THAT(text, HasSubstr("1.3999999999999999 1.5 3.1415926535897931\n"));
}

}  // namespace mpmvv::codes::start_text_test
