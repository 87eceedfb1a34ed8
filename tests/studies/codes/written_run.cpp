#include "tests/studies/codes/written_run.hpp"

#include <zlib.h>

#include <bit>

namespace mpmvv::written_run {

std::vector<Field> fields(const State& s, bool has_id, bool has_X) {
  std::vector<Field> all;
  if (has_id) all.emplace_back("id", [&s](std::size_t p) { return static_cast<double>(s.id[p]); });
  const auto add_points = [&all](const std::array<const char*, 2>& names, const std::vector<Point>& points) {
    for (std::size_t d = 0; d < 2; ++d)
      all.emplace_back(names[d], [&points, d](std::size_t p) { return points[p][d]; });
  };
  if (has_X) add_points({"x0", "y0"}, s.X);
  add_points({"x", "y"}, s.x);
  add_points({"vx", "vy"}, s.v);
  all.emplace_back("mass", [&s](std::size_t p) { return s.m[p]; });
  const std::pair<const char*, std::size_t> components[] = {{"s11", 0}, {"s22", 4}, {"s12", 1}};
  for (const auto& [name, k] : components)
    all.emplace_back(name, [&s, at = k](std::size_t p) { return s.stress[p][at]; });
  return all;
}

std::string csv(const std::vector<Field>& fields, std::size_t particles, int digits) {
  std::string text;
  for (const Field& field : fields) text += field.first + (&field == &fields.back() ? "\n" : ",");
  for (std::size_t p = 0; p < particles; ++p)
    for (const Field& field : fields)
      text += fmt::format("{:.{}g}{}", field.second(p), digits, &field == &fields.back() ? "\n" : ",");
  return text;
}

std::string dump(const std::vector<Field>& fields, std::size_t particles, std::int64_t step, int digits) {
  std::string text = fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS sm sm sm\n0 1\n0 1\n-0.5 0.5\nITEM: ATOMS ",
      step, particles);
  for (const Field& field : fields) text += field.first + " ";
  text += "\n";
  for (std::size_t p = 0; p < particles; ++p) {
    for (const Field& field : fields) text += fmt::format("{:.{}g} ", field.second(p), digits);
    text += "\n";
  }
  return text;
}

namespace {

std::string bytes_of(double value, bool is_big) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (is_big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string word(std::uint32_t value) {
  std::string bytes;
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> 8 * k & 0xff);
  return bytes;
}

std::string base64(const std::string& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += at + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

/// A header and blocks of 100 bytes, the last one with what is left.
std::pair<std::string, std::string> compressed(const std::string& bytes) {
  constexpr std::size_t block = 100;
  const std::size_t blocks = (bytes.size() + block - 1) / block;
  std::string header =
      word(static_cast<std::uint32_t>(blocks)) + word(block) + word(static_cast<std::uint32_t>(bytes.size() % block));
  std::string all;
  for (std::size_t k = 0; k < blocks; ++k) {
    const std::string plain = bytes.substr(k * block, block);
    std::string packed(compressBound(plain.size()), '\0');
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(plain.data()),
             plain.size());
    header += word(static_cast<std::uint32_t>(size));
    all += packed.substr(0, size);
  }
  return {header, all};
}

/// An array with its header. zlib_appended has no base64.
std::string packed(const std::string& bytes, Vtk kind) {
  if (kind == Vtk::zlib || kind == Vtk::zlib_appended) {
    const auto [header, blocks] = compressed(bytes);
    return kind == Vtk::zlib ? base64(header) + base64(blocks) : header + blocks;
  }
  const std::string headed = word(static_cast<std::uint32_t>(bytes.size())) + bytes;
  return kind == Vtk::raw ? headed : base64(headed);
}

}  // namespace

std::string ply(const std::vector<Field>& fields, std::size_t particles, Bytes bytes) {
  const char* format = bytes == Bytes::text  ? "ascii"
                       : bytes == Bytes::big ? "binary_big_endian"
                                             : "binary_little_endian";
  std::string text = fmt::format("ply\nformat {} 1.0\ncomment made by a test\nelement vertex {}\n", format, particles);
  for (const Field& field : fields) text += "property double " + field.first + "\n";
  text += "element face 0\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t p = 0; p < particles; ++p) {
    for (const Field& field : fields)
      text += bytes == Bytes::text ? fmt::format("{:.17g} ", field.second(p))
                                   : bytes_of(field.second(p), bytes == Bytes::big);
    if (bytes == Bytes::text) text += "\n";
  }
  return text;
}

std::string vtu(const std::vector<Field>& fields, std::size_t particles, Vtk kind) {
  std::string appended, arrays;
  const auto array = [&](const std::string& name, int components,
                         const std::function<double(std::size_t, int)>& value) {
    std::string text, bytes;
    for (std::size_t p = 0; p < particles; ++p)
      for (int k = 0; k < components; ++k)
        text += fmt::format("{:.17g} ", value(p, k)), bytes += bytes_of(value(p, k), false);
    const std::string head =
        fmt::format(R"(<DataArray type="Float64" Name="{}" NumberOfComponents="{}" format=)", name, components);
    if (kind >= Vtk::raw) {
      const std::size_t offset = appended.size();
      appended += packed(bytes, kind);
      return fmt::format("{}\"appended\" offset=\"{}\"/>\n", head, offset);
    }
    if (kind == Vtk::text) return fmt::format("{}\"ascii\">{}</DataArray>\n", head, text);
    return fmt::format("{}\"binary\">{}</DataArray>\n", head, packed(bytes, kind));
  };
  const auto find = [&](const std::string& name) {
    return std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.first == name; })->second;
  };
  const std::string points = array("Points", 3, [x = find("x"), y = find("y")](std::size_t p, int k) {
    return k == 0 ? x(p) : k == 1 ? y(p) : 0.0;
  });
  for (const Field& field : fields)
    if (field.first != "x" && field.first != "y")
      arrays += array(field.first, 1, [&](std::size_t p, int) { return field.second(p); });
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"{}>\n"
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"0\">\n<Points>\n{}</Points>\n<PointData>\n"
      "{}</PointData>\n</Piece>\n</UnstructuredGrid>\n{}</VTKFile>\n",
      kind == Vtk::zlib || kind == Vtk::zlib_appended ? " compressor=\"vtkZLibDataCompressor\"" : "", particles, points,
      arrays,
      kind < Vtk::raw ? ""
                      : fmt::format("<AppendedData encoding=\"{}\">\n_{}\n</AppendedData>\n",
                                    kind == Vtk::base64_appended ? "base64" : "raw", appended));
}

std::string legacy_vtk(const std::vector<Field>& fields, std::size_t particles, Bytes bytes) {
  const bool is_text = bytes == Bytes::text;
  const auto number = [&](double value) { return is_text ? fmt::format("{:.17g} ", value) : bytes_of(value, true); };
  std::string text = fmt::format("# vtk DataFile Version 3.0\nparticles\n{}\nDATASET POLYDATA\nPOINTS {} double\n",
                                 is_text ? "ASCII" : "BINARY", particles);
  const auto value = [&](const std::string& name, std::size_t p) {
    return std::ranges::find(fields, name, &Field::first)->second(p);
  };
  for (std::size_t p = 0; p < particles; ++p) text += number(value("x", p)) + number(value("y", p)) + number(0);
  text += fmt::format("\nPOINT_DATA {}\n", particles);
  for (const Field& field : fields) {
    if (field.first == "x" || field.first == "y") continue;
    text += "SCALARS " + field.first + " double\nLOOKUP_TABLE default\n";
    for (std::size_t p = 0; p < particles; ++p) text += number(field.second(p));
    text += "\n";
  }
  return text;
}

/// With velocities and stresses, in mm, g and s, at a time of 4 ms.
std::string nairn(const State& s) {
  std::string header = "ver6";
  header += static_cast<char>(24);
  header += "iYYY" + std::string(20, 'N');
  header += static_cast<char>(5);
  header += "iYNNN21";
  const float time = 4;
  header.append(reinterpret_cast<const char*>(&time), sizeof time);
  header.resize(64, '\0');
  std::string records;
  for (std::size_t p = 0; p < s.size(); ++p) {
    records += word(1) + bytes_of(1e3 * s.m[p], false) + word(1);
    const Point &x = s.x[p], &X = s.X[p], &v = s.v[p];
    const Tensor& stress = s.stress[p];
    for (const double value : {0.0, 1.0, 1e3 * x[0], 1e3 * x[1], 1e3 * X[0], 1e3 * X[1], 1e3 * v[0], 1e3 * v[1],
                               stress[0], stress[4], 0.0, stress[1]})
      records += bytes_of(value, false);
  }
  return header + records;
}

}  // namespace mpmvv::written_run
