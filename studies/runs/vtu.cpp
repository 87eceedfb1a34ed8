#include "studies/runs/vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "studies/runs/vtu_text.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::runs {

namespace {

/// Whether a file has a name of the series: particles.pvd or particles-0000.vtu, with four digits or more.
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
  VtuText file(n, [&](std::size_t p, int k) { return padded(particles.x[p], k); });
  file.add_integers("id", [&](std::size_t p) { return std::int64_t{particles.id[p]} + 1; });
  file.add("displacement", 3,
           [&](std::size_t p, int k) { return padded(solver::Vec<D>(particles.x[p] - X[particles.id[p]]), k); });
  file.add("velocity", 3, [&](std::size_t p, int k) { return padded(particles.v[p], k); });
  file.add("deformation_gradient", 9, [&](std::size_t p, int k) {
    const int i = k / 3, j = k % 3;
    return i < D && j < D ? particles.F[p](i, j) : i == j ? 1.0 : 0.0;
  });
  file.add("mass", 1, [&](std::size_t p, int) { return particles.m[p]; });

  const std::string name = fmt::format("particles-{:04}.vtu", count_++);
  support::write_if_changed(dir_ / name, file.text(mpm.time()));
  entries_ += fmt::format("<DataSet timestep=\"{:.17g}\" file=\"{}\"/>\n", mpm.time(), name);
  support::write_if_changed(dir_ / "particles.pvd",
                            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" +
                                entries_ + "</Collection>\n</VTKFile>\n");
}

template void VtuSeries::write<1>(const solver::Mpm<1>&, const std::vector<solver::Vec<1>>&);
template void VtuSeries::write<2>(const solver::Mpm<2>&, const std::vector<solver::Vec<2>>&);
template void VtuSeries::write<3>(const solver::Mpm<3>&, const std::vector<solver::Vec<3>>&);

}  // namespace mpmvv::runs
