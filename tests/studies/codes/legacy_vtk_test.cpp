#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <filesystem>

#include "studies/codes/readers.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::legacy_vtk_test {

using namespace codes;
using support::UsageError;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string head = "# vtk DataFile Version 3.0\nparticles\nASCII\nDATASET POLYDATA\n";
const std::string two_points = "POINTS 2 double\n0.5 0.25 0\n1.5 1.25 0\n";

ParticleTable read(const std::string& content) {
  return read_legacy_vtk({content, "end.vtk"});
}

std::vector<double> column(const ParticleTable& table, const std::string& name) {
  const TableColumn* found = table.find(name);
  return found ? found->values : std::vector<double>();
}

std::string message_of(const std::string& content, ParticleTable (*reader)(const Source&) = &read_legacy_vtk) {
  try {
    reader({content, "end.vtk"});
  } catch (const UsageError& e) {
    return e.what();
  }
  return "";
}

/// The bytes of numbers, the most significant one first.
template <class T>
std::string bytes(const std::vector<T>& numbers) {
  std::string all;
  for (const T number : numbers) {
    const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(number);
    all.append(raw.rbegin(), raw.rend());
  }
  return all;
}

TEST(LegacyVtk, TakesPointsAndArraysByTheirComponents) {
  const ParticleTable table = read(head + two_points +
                                   "VERTICES 2 4\n1 0\n1 1\nPOINT_DATA 2\n"
                                   "SCALARS mass double\nLOOKUP_TABLE default\n3 4\n"
                                   "SCALARS pair float 2\nlookup_table default\n1 2 3 4\n"
                                   "SCALARS id int 1\n7 8\n"
                                   "VECTORS velocity float\n1 2 3\n4 5 6\n"
                                   "TENSORS stress double\n1 2 3\n4 5 6\n7 8 9\n\n11 12 13\n14 15 16\n17 18 19\n"
                                   "TENSORS6 strain double\n1 2 3 4 5 6 1 2 3 4 5 6\n"
                                   "NORMALS n FLOAT\n0 0 1 0 0 1\n");
  EXPECT_THAT(column(table, "Points:0"), ElementsAre(0.5, 1.5));
  EXPECT_THAT(column(table, "Points:1"), ElementsAre(0.25, 1.25));
  EXPECT_THAT(column(table, "mass"), ElementsAre(3, 4));
  EXPECT_THAT(column(table, "pair:1"), ElementsAre(2, 4));
  EXPECT_THAT(column(table, "id"), ElementsAre(7, 8));
  EXPECT_THAT(column(table, "velocity:2"), ElementsAre(3, 6));
  EXPECT_THAT(column(table, "stress:5"), ElementsAre(6, 16));
  EXPECT_THAT(column(table, "strain:5"), ElementsAre(6, 6));
  EXPECT_THAT(column(table, "n:2"), ElementsAre(1, 1));
  EXPECT_EQ(table.columns.size(), 3U + 1 + 2 + 1 + 3 + 9 + 6 + 3);
  EXPECT_EQ(table.find("Points:1")->digits, 3);
  EXPECT_FALSE(table.time);
}

TEST(LegacyVtk, TakesFieldsOfPointsAndNoCellData) {
  const ParticleTable table =
      read(head + two_points +
           "CELL_DATA 1\nSCALARS mass double\nLOOKUP_TABLE default\n9\nFIELD f 1\nq 1 1 int\n3\n"
           "POINT_DATA 2\nFIELD FieldData 4\nparticle%20mass 1 2 double\n1 2\n"
           "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 1 2\n\n"
           "NULL_ARRAY\nv 3 2 double\n1 2 3\n4 nan -inf\nname 1 2 string\nsand\n\n"
           "GLOBAL_IDS gid vtkIdType\n5 6\n");
  EXPECT_TRUE(column(table, "mass").empty());
  EXPECT_TRUE(column(table, "q").empty());
  EXPECT_THAT(column(table, "particle mass"), ElementsAre(1, 2));
  EXPECT_TRUE(std::isnan(column(table, "v:1").at(1)));
  EXPECT_EQ(column(table, "v:2").at(1), -HUGE_VAL);
  EXPECT_THAT(column(table, "gid"), ElementsAre(5, 6));
}

TEST(LegacyVtk, TakesTimeAndStepOfTheFieldElseTheTimeOfTheTitle) {
  const std::string field = "FIELD FieldData 3\nMeshName 1 1 string\nbody 1\nCYCLE 1 1 int\n32\n";
  const ParticleTable table = read(head + field + "TIME 1 1 double\n0.008\n" + two_points);
  EXPECT_EQ(table.time, 0.008);
  EXPECT_EQ(table.step, 32);
  EXPECT_EQ(read(head + two_points + field + "TimeValue 1 1 double\n0.5\n").time, 0.5) << "behind the points";
  for (const char* title : {"time = 0.25", "MPM, Time: 0.25 s", "t=0.25", "square at t=0.25, step 3",
                            "t = 7, time = 0.25", "t=0.25 h=0.1"}) {
    std::string text = head;
    text.replace(text.find("particles"), 9, title);
    EXPECT_EQ(read(text + two_points).time, 0.25) << title;
    EXPECT_EQ(read(text + "FIELD FieldData 1\nTIME 1 1 double\n0.5\n" + two_points).time, 0.5) << title;
  }
  std::string text = head;
  text.replace(text.find("particles"), 9, "time = 8 ms");
  EXPECT_THAT(message_of(text + two_points), HasSubstr("'time = 8 ms' in end.vtk:2 (in s, or the number alone"));
}

TEST(LegacyVtk, ReadsBinaryWithTheMostSignificantByteFirst) {
  std::string text = head;
  text.replace(text.find("ASCII"), 5, "BINARY");
  const ParticleTable table =
      read(text + "FIELD FieldData 2\nname 1 1 string\n\xC4sand\nTIME 1 1 double\n" + bytes<double>({0.008}) + "\n" +
           "POINTS 2 double\n" + bytes<double>({0.5, 0.25, 0, 1.5, 1.25, 0}) + "\nVERTICES 2 4\n" +
           bytes<std::int32_t>({1, 0, 1, 1}) + "\nPOINT_DATA 2\nSCALARS m float\nLOOKUP_TABLE default\n" +
           bytes<float>({0.25F, 10.0F}) +  // 10.0F ends in the bytes of blanks, and no line end follows
           "VECTORS v float\n" + bytes<float>({1, 2, 3, 4, 5, NAN}) + "\nSCALARS id long 1\n" +
           bytes<std::int64_t>({-7, 8}) + "\nFIELD FieldData 1\nphase 1 2 unsigned_char\n\x01\xFF\n");
  EXPECT_EQ(table.time, 0.008);
  EXPECT_THAT(column(table, "Points:0"), ElementsAre(0.5, 1.5));
  EXPECT_THAT(column(table, "m"), ElementsAre(0.25, 10));
  EXPECT_THAT(column(table, "v:1"), ElementsAre(2, 5));
  EXPECT_TRUE(std::isnan(column(table, "v:2").at(1)));
  EXPECT_THAT(column(table, "id"), ElementsAre(-7, 8));
  EXPECT_THAT(column(table, "phase"), ElementsAre(1, 255));
  EXPECT_EQ(table.find("Points:0")->bits, 53);
  EXPECT_EQ(table.find("m")->bits, 24);
  EXPECT_EQ(table.find("id")->bits, 0);
}

/// Since version 5 cells have two arrays of 8 bytes a number.
TEST(LegacyVtk, SkipsCellsOfEitherVersion) {
  const std::string data = "POINT_DATA 2\nSCALARS m double\nLOOKUP_TABLE default\n";
  const std::string grid =
      "# vtk DataFile Version 5.1\nparticles\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 2 double\n" +
      bytes<double>({0.5, 0.25, 0, 1.5, 1.25, 0}) + "\n";
  const std::string types = "CELL_TYPES 2\n" + bytes<std::int32_t>({1, 1}) + "\n";
  const std::string mass = bytes<double>({3, 4});
  EXPECT_THAT(column(read(grid + "CELLS 2 4\n" + bytes<std::int32_t>({1, 0, 1, 1}) + "\n" + types + data + mass), "m"),
              ElementsAre(3, 4));
  EXPECT_THAT(column(read(grid + "CELLS 3 2\nOFFSETS vtktypeint64\n" + bytes<std::int64_t>({0, 1, 2}) +
                          "\nCONNECTIVITY vtktypeint64\n" + bytes<std::int64_t>({0, 1}) + "\n" + types + data + mass),
                     "m"),
              ElementsAre(3, 4));
  EXPECT_THAT(column(read(head + two_points + "VERTICES 2 99\n1 0\n1 1\n" + data + "3 4\n"), "m"), ElementsAre(3, 4))
      << "in text a wrong size does no harm";
}

TEST(LegacyVtk, IsReadByTheEndingOfItsName) {
  const auto file = std::filesystem::temp_directory_path() / fmt::format("mpmvv-{}-legacy.vtk", ::getpid());
  support::write_if_changed(file, head + "POINTS 1 float\n0.5 0.25 0\nPOINT_DATA 1\nVECTORS velocity float\n1 2 0\n");
  const Snapshot s = read_snapshot(file, {.dimensions = 2});
  std::filesystem::remove(file);
  EXPECT_THAT(s.x, ElementsAre(Point{0.5, 0.25, 0}));
  EXPECT_THAT(s.v, ElementsAre(Point{1, 2, 0}));
}

TEST(LegacyVtk, SaysWhatItCannotRead) {
  EXPECT_THAT(message_of("<?xml version=\"1.0\"?>\n<VTKFile>"),
              HasSubstr("XML in end.vtk (a legacy VTK file; format vtu"));
  EXPECT_THAT(message_of(head, &read_vtu), HasSubstr("a legacy VTK file in end.vtk (VTK's XML; format vtk is the"));
  EXPECT_THAT(message_of("x,y\n1,2\n"),
              HasSubstr("'x,y' in end.vtk (a legacy VTK file, whose first line is # vtk Data"));
  EXPECT_THAT(message_of("# vtk DataFile Version 3.0\ntitle\nDATASET POLYDATA\n"),
              HasSubstr("'DATASET' in end.vtk:3 (ASCII or BINARY"));
  EXPECT_THAT(message_of("# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET STRUCTURED_POINTS\n"),
              HasSubstr("'DATASET STRUCTURED_POINTS' in end.vtk:4 (particles are points of"));
  EXPECT_THAT(message_of(head), HasSubstr("no points in end.vtk"));
  EXPECT_THAT(message_of(head + two_points + two_points), HasSubstr("'POINTS' in end.vtk:8 (once)"));
  const std::string data = head + two_points + "POINT_DATA 2\nSCALARS m double\nLOOKUP_TABLE default\n";
  EXPECT_THAT(message_of(data + "1\n"), HasSubstr("the file ends in end.vtk:11 (2 numbers of 'm')"));
  EXPECT_THAT(message_of(data + "1\nb\n"), HasSubstr("'b' in end.vtk:12 (2 numbers of 'm')"));
  EXPECT_THAT(message_of(data + "1\n2 3\n"), HasSubstr("'3' in end.vtk:12 (a section, such as POINTS"));
  EXPECT_THAT(message_of(head + two_points + "POINT_DATA 3\n"), HasSubstr("'POINT_DATA 3' in end.vtk:8 (of 2 points)"));
  EXPECT_THAT(message_of(head + two_points + "VECTORS v float\n"), HasSubstr("(behind POINT_DATA or CELL_DATA)"));
  EXPECT_THAT(message_of(head + "POINTS 2 real\n1 2 3 4 5 6\n"),
              HasSubstr("'real' in end.vtk:5 (the type of 'Points'"));
  EXPECT_THAT(message_of(head + "POINTS 2\n1 2 3 4 5 6\n"),
              HasSubstr("'POINTS' in end.vtk:5 (at least 2 words behind"));
  EXPECT_THAT(message_of(head + two_points + "POINT_DATA 2\nFIELD f 1\nm 1 3 float\n1 2 3\n"),
              HasSubstr("'m 3' in end.vtk:10 (of 2 points)"));
}

}  // namespace mpmvv::legacy_vtk_test
