#include <gtest/gtest.h>

#include <random>

#include "studies/codes/readers.hpp"
#include "studies/support/error.hpp"
#include "tests/studies/codes/written_run.hpp"

namespace mpmvv::damaged_files_test {

using namespace written_run;

/// A file of each format, and of each kind that it has.
std::vector<std::pair<std::string, std::string>> sound_files() {
  State s;
  for (std::int64_t p = 1; p <= 5; ++p) {
    s.id.push_back(p);
    const double a = 0.1 * static_cast<double>(p);
    s.X.push_back({a, a, 0}), s.x.push_back({a, 2 * a, 0}), s.v.push_back({a, 3 * a, 0});
    s.m.push_back(a), s.F.push_back({}), s.stress.push_back({});
  }
  const auto f = fields(s, true, true);
  return {{"csv", csv(f, 5)},
          {"ply", ply(f, 5, Bytes::text)},
          {"ply", ply(f, 5, Bytes::little)},
          {"ply", ply(f, 5, Bytes::big)},
          {"dump", dump(f, 5, 3)},
          {"vtu", vtu(f, 5, Vtk::text)},
          {"vtu", vtu(f, 5, Vtk::base64)},
          {"vtu", vtu(f, 5, Vtk::raw)},
          {"vtu", vtu(f, 5, Vtk::zlib)},
          {"vtu", vtu(f, 5, Vtk::base64_appended)},
          {"vtu", vtu(f, 5, Vtk::zlib_appended)},
          {"vtk", legacy_vtk(f, 5, Bytes::text)},
          {"vtk", legacy_vtk(f, 5, Bytes::big)},
          {"nairn", nairn(s)}};
}

/// What is said of a file that is refused; empty where it is read.
std::string complaint(codes::ParticleTable (*read)(const codes::Source&), const std::string& content) {
  try {
    read({content, "file"});
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "";
}

/// Reads it, or has a one-line UsageError; anything else ends the test.
bool is_read(const std::string& format, const std::string& content) {
  const codes::Format& reader = *std::find_if(codes::formats().begin(), codes::formats().end(),
                                              [&](const codes::Format& f) { return f.word == format; });
  try {
    const codes::ParticleTable table = reader.read({content, "file"});
    for (const codes::TableColumn& column : table.columns) EXPECT_LE(column.values.size(), content.size());
    codes::snapshot_of(table, {}, "file");
    return true;
  } catch (const support::UsageError& e) {
    EXPECT_NE(std::string(e.what()), "");
    return false;
  }
}

TEST(DamagedFiles, SoundOnesAreRead) {
  for (const auto& [format, content] : sound_files()) EXPECT_TRUE(is_read(format, content)) << format;
}

TEST(DamagedFiles, EveryTruncation) {
  for (const auto& [format, content] : sound_files())
    for (std::size_t size = 0; size < content.size(); ++size) is_read(format, content.substr(0, size));
}

TEST(DamagedFiles, BytesAndNumbersChanged) {
  std::mt19937 random(1);
  for (const auto& [format, content] : sound_files())
    for (int round = 0; round < 300; ++round) {
      std::string damaged = content;
      for (int k = 0; k < 1 + round % 4; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
      is_read(format, damaged);
    }
}

TEST(DamagedFiles, CountsBeyondTheirTypeAreRefused) {
  const std::string huge = "99999999999999999999999";
  EXPECT_EQ(complaint(codes::read_ply, "ply\nformat ascii 1.0\nelement vertex " + huge +
                                           "\nproperty double x\n"
                                           "end_header\n1\n"),
            "'element vertex " + huge + "' in file:3 (element vertex, and how many)");
  EXPECT_EQ(
      complaint(codes::read_dump, "ITEM: TIMESTEP\n" + huge + "\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id x\n1 2\n"),
      "'" + huge + "' in file:2 (the number of a step)");
}

/// Arrays may share their bytes: memory for all of them may be far more than the file has.
TEST(DamagedFiles, ArraysBehindOneOfOtherPointsAreNotRead) {
  EXPECT_EQ(complaint(codes::read_vtu,
                      "<VTKFile><UnstructuredGrid><Piece NumberOfPoints=\"1\"><Points><DataArray type=\"Float64\" "
                      "NumberOfComponents=\"3\">1 2 3</DataArray></Points><PointData><DataArray type=\"Float64\" "
                      "Name=\"m\">1 2</DataArray><DataArray type=\"Float64\" Name=\"u\">one</DataArray></PointData>"
                      "</Piece></UnstructuredGrid></VTKFile>"),
            "2 numbers in 'm' of 1 points in file (a VTK file in XML: .vtu or .vtp)");
}

/// Headers that promise more than the file has, and numbers beyond any type.
TEST(DamagedFiles, HugePromises) {
  for (const char* huge : {"4000000000000000000", "99999999999999999999999", "-1"}) {
    EXPECT_FALSE(is_read("ply", fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
                                            "property double x\nend_header\n12345678",
                                            huge)));
    EXPECT_FALSE(
        is_read("dump", fmt::format("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{}\nITEM: ATOMS id x\n1 2\n", huge)));
    EXPECT_FALSE(is_read(
        "vtu", fmt::format("<VTKFile><UnstructuredGrid><Piece NumberOfPoints=\"{}\"><Points><DataArray "
                           "type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">1 2 3</DataArray></Points>"
                           "</Piece></UnstructuredGrid></VTKFile>",
                           huge)));
  }
  // One block of 4 GB in 4 bytes of zlib.
  EXPECT_FALSE(
      is_read("vtu",
              "<VTKFile compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid><Piece NumberOfPoints=\"1\"><Points>"
              "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"binary\">AQAAAP///3////9/BAAAAAECAwQ="
              "</DataArray></Points></Piece></UnstructuredGrid></VTKFile>"));
}

TEST(DamagedFiles, HugePromisesOfALegacyFile) {
  for (const char* huge : {"4000000000000000000", "99999999999999999999999", "-1"})
    for (const char* kind : {"ASCII", "BINARY"}) {
      const std::string head = fmt::format("# vtk DataFile Version 3.0\n\n{}\nDATASET POLYDATA\n", kind);
      const std::string point = "POINTS 1 char\n" + (*kind == 'A' ? std::string("1 2 3\n") : std::string("123"));
      EXPECT_TRUE(is_read("vtk", head + point));
      EXPECT_FALSE(is_read("vtk", head + fmt::format("POINTS {} double\n1 2 3\n", huge)));
      for (const char* more :
           {"FIELD f {} \n", "FIELD f 1\na 1 {} double\n1\n", "FIELD f 1\na {} 1 double\n1\n",
            "FIELD f 1\na 1 {} string\n1\n", "POINT_DATA 1\nSCALARS m double {}\nLOOKUP_TABLE default\n1\n",
            "CELL_DATA {}\nSCALARS m double\n1\n", "POINT_DATA {}\n"})
        EXPECT_FALSE(is_read("vtk", head + point + fmt::format(fmt::runtime(more), huge))) << kind << more << huge;
    }
}

TEST(DamagedFiles, OtherFilesAltogether) {
  for (const codes::Format& format : codes::formats())
    for (const std::string& content : {std::string(), std::string("\0\0\0\0", 4), std::string("ply\n"),
                                       std::string(1000, '<'), std::string("\x89PNG\r\n\x1a\n")})
      EXPECT_FALSE(is_read(format.word, content)) << format.word;
}

}  // namespace mpmvv::damaged_files_test
