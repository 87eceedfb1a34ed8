#include "studies/codes/columns.hpp"

#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/codes/readers.hpp"
#include "studies/support/error.hpp"
#include "tests/studies/codes/written_run.hpp"

namespace mpmvv::columns_test {

using namespace codes;
using testing::AllOf;
using testing::HasSubstr;

/// Of a particle at (1, 2, 3): columns with these names, and 10, 11, ... in them.
ParticleTable table(const std::vector<std::string>& names) {
  ParticleTable all;
  for (const char* axis : {"x", "y", "z"}) all.columns.push_back({.name = axis, .values = {1.0}});
  for (const std::string& name : names)
    all.columns.push_back({.name = name, .values = {static_cast<double>(7 + all.columns.size())}});
  return all;
}

/// An array of so many components.
ParticleTable array(const std::string& name, int components) {
  std::vector<std::string> names;
  for (int k = 0; k < components; ++k) names.push_back(fmt::format("{}:{}", name, k));
  return table(names);
}

Snapshot read(const ParticleTable& all, std::size_t dimensions, const std::string& names = "") {
  Columns columns{.dimensions = dimensions};
  if (!names.empty()) columns.names = parse_columns(names, "--columns");
  return snapshot_of(all, columns, "end.vtu");
}

std::string message_of(const ParticleTable& all, std::size_t dimensions, const std::string& names = "") {
  try {
    read(all, dimensions, names);
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "";
}

TEST(Columns, OfNineComponentsStandRowByRow) {
  EXPECT_EQ(read(array("stress", 9), 3).stress.front(), (Tensor{10, 11, 12, 13, 14, 15, 16, 17, 18}));
  EXPECT_EQ(read(array("stress", 9), 2).stress.front(), (Tensor{10, 11, 0, 13, 14, 0, 0, 0, 0}));
}

TEST(Columns, OfSixComponentsAreInVtksOrder) {
  EXPECT_EQ(read(array("stress", 6), 3).stress.front(), (Tensor{10, 13, 15, 13, 11, 14, 15, 14, 12}));
  EXPECT_EQ(read(array("sig", 6), 2, "s=sig").stress.front(), (Tensor{10, 13, 0, 13, 11, 0, 0, 0, 0}));
  EXPECT_EQ(read(array("stress", 6), 1).stress.front(), (Tensor{10, 0, 0, 0, 0, 0, 0, 0, 0}));
}

/// Four may be rows of two, or xx, yy, zz and xy.
TEST(Columns, OfOtherNumbersOfComponentsAreRefused) {
  for (const int components : {2, 3, 4, 5, 7, 8})
    EXPECT_THAT(message_of(array("stress", components), 2),
                AllOf(HasSubstr(fmt::format("array 'stress' of {} components in end.vtu (9, row by row, or 6 as VTK "
                                            "orders them: xx, yy, zz, xy, yz, xz; else s_xx=stress:0,...",
                                            components))))
        << components;
  EXPECT_EQ(read(array("stress", 4), 2, "s_xx=stress:0,s_yy=stress:1,s_xy=stress:3").stress.front(),
            (Tensor{10, 13, 0, 13, 11, 0, 0, 0, 0}));
  EXPECT_EQ(read(array("velocity", 2), 2).v.front(), (Point{10, 11, 0})) << "of vectors any number";
}

TEST(Columns, OfAVtkFileOfSixComponents) {
  const auto file = written_run::write(
      "six.vtu",
      "<VTKFile><UnstructuredGrid><Piece NumberOfPoints=\"1\"><Points><DataArray type=\"Float64\" "
      "NumberOfComponents=\"3\" format=\"ascii\">1 2 0</DataArray></Points><PointData><DataArray type=\"Float64\" "
      "Name=\"stress\" NumberOfComponents=\"6\" format=\"ascii\">1 2 3 4 5 6</DataArray></PointData></Piece>"
      "</UnstructuredGrid></VTKFile>");
  const Snapshot s = read_snapshot(file, {.dimensions = 2});
  std::filesystem::remove(file);
  EXPECT_EQ(s.stress.front(), (Tensor{1, 4, 0, 4, 2, 0, 0, 0, 0}));
}

TEST(Columns, MayHaveTheNamesThatParaViewGivesThem) {
  EXPECT_EQ(read(table({"stress_XX", "stress_YY", "stress_ZZ", "stress_XY", "stress_YZ", "stress_XZ"}), 3).stress,
            (std::vector<Tensor>{{10, 13, 15, 13, 11, 14, 15, 14, 12}}));
  EXPECT_EQ(read(table({"velocity_X", "velocity_Y", "velocity_Z"}), 2).v.front(), (Point{10, 11, 0}));
  ParticleTable with_size = array("velocity", 3);
  with_size.columns.push_back({.name = "velocity:Magnitude", .values = {1.0}});
  EXPECT_EQ(read(with_size, 2).v.front(), (Point{10, 11, 0}));
}

TEST(Columns, OfAStressServeBothSides) {
  const ParticleTable all = table({"sig11", "sig22", "sig12"});
  const Tensor symmetric{10, 12, 0, 12, 11, 0, 0, 0, 0};
  EXPECT_EQ(read(all, 2, "s_xx=sig11,s_yy=sig22,s_xy=sig12").stress.front(), symmetric);
  EXPECT_EQ(read(all, 2, "s_xx=sig11,s_yy=sig22,s_yx=sig12").stress.front(), symmetric);
  EXPECT_EQ(read(table({"s_xx", "s_yy", "s_yx"}), 2).stress.front(), symmetric);
  EXPECT_EQ(read(table({"a", "b", "c", "d"}), 2, "s_xx=a,s_yy=b,s_xy=c,s_yx=d").stress.front(),
            (Tensor{10, 12, 0, 13, 11, 0, 0, 0, 0}))
      << "where both are named";
}

/// No measure needs them.
TEST(Columns, OfVolumeAndDeformationAreNotRead) {
  EXPECT_EQ(message_of(table({"V", "F_xx", "F_yy"}), 2), "");
  EXPECT_EQ(message_of(array("deformation_gradient", 4), 2), "");
  EXPECT_EQ(message_of(table({"vol", "F11"}), 2, "V=vol,F_xx=F11,F=F"), "") << "though they may be named";
  EXPECT_THAT(message_of(table({"F11"}), 2, "F_aa=F11"), HasSubstr("unknown quantity 'F_aa' in --columns"));
}

/// Units of different size: none can take the place of another.
TEST(Columns, AreConvertedByTheUnitsOfTheirDimension) {
  ParticleTable all = table({"u:0", "v_x", "m", "s_xx"});
  all.time = 8;
  const Snapshot s = snapshot_of(all, {.length = 0.5, .time = 0.25, .mass = 4, .dimensions = 1}, "end.csv");
  EXPECT_EQ(s.x.front()[0], 0.5);
  EXPECT_EQ(s.u.front()[0], 5);
  EXPECT_EQ(s.v.front()[0], 22) << "11 of 0.5 m in 0.25 s";
  EXPECT_EQ(s.mass.front(), 48);
  EXPECT_EQ(s.stress.front()[0], 13 * 4 / (0.5 * 0.25 * 0.25));
  EXPECT_EQ(s.time, 2);
  all.is_time_in_seconds = true;
  EXPECT_EQ(snapshot_of(all, {.time = 0.25, .dimensions = 1}, "end.csv").time, 8);
}

TEST(Columns, OfMassAreDividedByTheThicknessOfAPlaneBody) {
  for (const std::size_t dimensions : {1, 2, 3}) {
    const Columns columns{.mass = 1e3, .thickness = 0.5, .dimensions = dimensions};
    EXPECT_EQ(snapshot_of(table({"m"}), columns, "end.csv").mass.front(), dimensions == 2 ? 2e4 : 1e4) << dimensions;
  }
}

/// Each by its own digits, whatever other columns show.
TEST(Columns, SayHowFarDisplacementsMayBeFromPositions) {
  const auto rounding = [](const std::string& text) {
    const auto file = written_run::write("rounded.csv", text);
    const double all = read_snapshot(file, {.length = 1e-3, .dimensions = 1}).rounding_of_all;
    std::filesystem::remove(file);
    return all;
  };
  EXPECT_NEAR(rounding("X,x,u_x,m\n0.12,0.34,0.123456789,0.33333333333333331\n"), 1e-3 * (0.01 * std::sqrt(2.0) + 1e-9),
              1e-15);
  EXPECT_EQ(rounding("X,x\n0.12,0.34\n"), 0);
}

}  // namespace mpmvv::columns_test
