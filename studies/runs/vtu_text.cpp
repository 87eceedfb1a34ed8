#include "studies/runs/vtu_text.hpp"

#include <fmt/format.h>

namespace mpmvv::runs {

namespace {

void add_array(std::string& text, const char* name, int components, std::size_t particles,
               const VtuText::Component& component) {
  text += fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", name,
                      components);
  for (std::size_t p = 0; p < particles; ++p)
    for (int k = 0; k < components; ++k)
      text += fmt::format("{:.17g}{}", component(p, k), k + 1 < components ? ' ' : '\n');
  text += "</DataArray>\n";
}

void add_integer_array(std::string& text, const char* type, const char* name, std::size_t particles,
                       const std::function<std::int64_t(std::size_t)>& value) {
  text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\">\n", type, name);
  for (std::size_t p = 0; p < particles; ++p) text += fmt::format("{}\n", value(p));
  text += "</DataArray>\n";
}

/// Every particle is a VTK vertex.
std::string vertices(std::size_t particles) {
  std::string text = "<Cells>\n";
  add_integer_array(text, "Int64", "connectivity", particles, [](std::size_t p) { return p; });
  add_integer_array(text, "Int64", "offsets", particles, [](std::size_t p) { return p + 1; });
  add_integer_array(text, "UInt8", "types", particles, [](std::size_t) { return 1; });
  return text + "</Cells>\n";
}

}  // namespace

VtuText::VtuText(std::size_t particles, const Component& position) : particles_(particles) {
  add_array(points_, "position", 3, particles, position);
}

void VtuText::add(const char* name, int components, const Component& component) {
  add_array(data_, name, components, particles_, component);
}

void VtuText::add_integers(const char* name, const std::function<std::int64_t(std::size_t p)>& value) {
  add_integer_array(data_, "Int64", name, particles_, value);
}

std::string VtuText::text(std::optional<double> time) const {
  const std::string at = time ? fmt::format(
                                    "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" "
                                    "NumberOfTuples=\"1\" format=\"ascii\">\n{:.17g}\n</DataArray>\n</FieldData>\n",
                                    *time)
                              : "";
  const std::string header = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid>\n{1}<Piece NumberOfPoints=\"{0}\" NumberOfCells=\"{0}\">\n<Points>\n",
      particles_, at);
  return header + points_ + "</Points>\n" + vertices(particles_) + "<PointData>\n" + data_ +
         "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace mpmvv::runs
