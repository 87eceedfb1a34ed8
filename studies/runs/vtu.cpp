#include "studies/runs/vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::runs {

namespace {

/// One data array; `component(p, k)` is component k of particle p.
template <class Component>
void add_array(std::string& text, const char* name, int components, std::size_t particles, const Component& component) {
  text += fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", name,
                      components);
  for (std::size_t p = 0; p < particles; ++p)
    for (int k = 0; k < components; ++k)
      text += fmt::format("{:.17g}{}", component(p, k), k + 1 < components ? ' ' : '\n');
  text += "</DataArray>\n";
}

/// Every particle is a cell of its own, a VTK vertex.
void add_vertices(std::string& text, std::size_t particles) {
  const auto add = [&](const char* type, const char* name, const auto& value) {
    text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\">\n", type, name);
    for (std::size_t p = 0; p < particles; ++p) text += fmt::format("{}\n", value(p));
    text += "</DataArray>\n";
  };
  text += "<Cells>\n";
  add("Int64", "connectivity", [](std::size_t p) { return p; });
  add("Int64", "offsets", [](std::size_t p) { return p + 1; });
  add("UInt8", "types", [](std::size_t) { return 1; });
  text += "</Cells>\n";
}

/// Whether it is named as one of a series' files: particles.pvd or particles-0000.vtu, with four digits or more.
bool is_of_series(std::string_view name) {
  constexpr std::string_view before = "particles-", after = ".vtu";
  if (name == "particles.pvd") return true;
  if (!name.starts_with(before) || !name.ends_with(after) || name.size() < before.size() + 4 + after.size())
    return false;
  name.remove_prefix(before.size());
  name.remove_suffix(after.size());
  return std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

VtuSeries::VtuSeries(std::filesystem::path dir) : dir_(std::move(dir)) {
  std::error_code error;
  std::filesystem::create_directories(dir_, error);
  if (error)
    throw support::UsageError(
        fmt::format("cannot make {} in --vtu: {} (a directory that may be written)", dir_.string(), error.message()));
}

void VtuSeries::remove_earlier() const {
  std::vector<std::filesystem::path> earlier;
  for (const auto& entry : std::filesystem::directory_iterator(dir_))
    if (!entry.is_directory() && is_of_series(entry.path().filename().string())) earlier.push_back(entry.path());
  for (const auto& file : earlier) std::filesystem::remove(file);
}

template <int D>
void VtuSeries::write(const solver::Mpm<D>& mpm, const std::vector<solver::Vec<D>>& X) {
  if (count_ == 0) remove_earlier();
  const auto& particles = mpm.particles();
  const std::size_t n = particles.size();
  const auto padded = [](const auto& v, int k) { return k < D ? v[k] : 0.0; };
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{0}\" NumberOfCells=\"{0}\">\n<Points>\n",
      n);
  add_array(text, "position", 3, n, [&](std::size_t p, int k) { return padded(particles.x[p], k); });
  text += "</Points>\n";
  add_vertices(text, n);
  text += "<PointData>\n";
  add_array(text, "displacement", 3, n,
            [&](std::size_t p, int k) { return padded(solver::Vec<D>(particles.x[p] - X[particles.id[p]]), k); });
  add_array(text, "velocity", 3, n, [&](std::size_t p, int k) { return padded(particles.v[p], k); });
  add_array(text, "deformation_gradient", 9, n, [&](std::size_t p, int k) {
    const int i = k / 3, j = k % 3;
    return i < D && j < D ? particles.F[p](i, j) : i == j ? 1.0 : 0.0;
  });
  add_array(text, "mass", 1, n, [&](std::size_t p, int) { return particles.m[p]; });
  text += "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

  const std::string name = fmt::format("particles-{:04}.vtu", count_++);
  support::write_if_changed(dir_ / name, text);
  entries_ += fmt::format("<DataSet timestep=\"{:.17g}\" file=\"{}\"/>\n", mpm.time(), name);
  support::write_if_changed(dir_ / "particles.pvd",
                            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" +
                                entries_ + "</Collection>\n</VTKFile>\n");
}

template void VtuSeries::write<1>(const solver::Mpm<1>&, const std::vector<solver::Vec<1>>&);
template void VtuSeries::write<2>(const solver::Mpm<2>&, const std::vector<solver::Vec<2>>&);
template void VtuSeries::write<3>(const solver::Mpm<3>&, const std::vector<solver::Vec<3>>&);

}  // namespace mpmvv::runs
