#pragma once
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "solver/mpm.hpp"
#include "studies/codes/snapshot.hpp"
#include "studies/runs/prepared_case.hpp"
#include "studies/settings/settings.hpp"

/// A run of ours, written as other codes write theirs.
namespace mpmvv::written_run {

using codes::Point;
using codes::Tensor;

struct State {
  std::vector<std::int64_t> id;
  std::vector<Point> X, x, v;
  std::vector<double> m;
  std::vector<Tensor> F, stress;

  std::size_t size() const { return id.size(); }

  /// The same particles in another order.
  State shuffled(unsigned seed) const {
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    State other;
    for (const std::size_t p : order) {
      other.id.push_back(id[p]), other.X.push_back(X[p]), other.x.push_back(x[p]), other.v.push_back(v[p]);
      other.m.push_back(m[p]), other.F.push_back(F[p]), other.stress.push_back(stress[p]);
    }
    return other;
  }
};

template <int D>
Point point(const solver::Vec<D>& v) {
  Point all{};
  std::copy(v.data(), v.data() + D, all.begin());
  return all;
}

template <int D>
Tensor tensor(const solver::Mat<D>& m) {
  Tensor all{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) all[3 * i + j] = m(static_cast<int>(i), static_cast<int>(j));
  return all;
}

/// The particles after some steps, by their ids.
template <int D>
State run(const cases::Case& c, std::int64_t steps) {
  auto prepared = runs::prepare_case<D>(c, problems::find_problem(c.problem.name, "the test"), 1);
  solver::Mpm<D> mpm(std::move(prepared.scene));
  for (std::int64_t step = 0; step < steps; ++step) mpm.step(c.resolution.dt);
  const auto& p = mpm.particles();
  State s;
  for (std::size_t k = 0; k < p.size(); ++k) {
    s.id.push_back(p.id[k] + 1), s.X.push_back(point<D>(prepared.X[p.id[k]])), s.x.push_back(point<D>(p.x[k]));
    s.v.push_back(point<D>(p.v[k])), s.m.push_back(p.m[k]), s.F.push_back(tensor<D>(p.F[k]));
    s.stress.push_back(tensor<D>(mpm.stress(k)));
  }
  return s;
}

inline cases::Case make_case(const std::vector<std::pair<std::string, std::string>>& settings) {
  std::vector<settings::Setting> given;
  for (const auto& [key, value] : settings) given.push_back({key, value, "the test"});
  return mpmvv::settings::make_case(given);
}

/// A small square in motion, up to a fifth of its period; its stress error is asked for.
inline cases::Case square(const char* end_time = "0.004") {
  return make_case({{"problem", "square"},
                    {"basis", "bspline2"},
                    {"cells", "8"},
                    {"ppc", "2"},
                    {"cfl", "0.2"},
                    {"end_time", end_time},
                    {"stress_error", "true"}});
}

/// Named columns of a state.
using Field = std::pair<std::string, std::function<double(std::size_t)>>;
std::vector<Field> fields(const State& s, bool has_id, bool has_X);

enum class Bytes { text, little, big };
enum class Vtk { text, base64, zlib, raw, base64_appended, zlib_appended };  ///< raw: appended, too

std::string csv(const std::vector<Field>& fields, std::size_t particles, int digits = 17);
std::string ply(const std::vector<Field>& fields, std::size_t particles, Bytes bytes);
std::string dump(const std::vector<Field>& fields, std::size_t particles, std::int64_t step, int digits = 17);
std::string vtu(const std::vector<Field>& fields, std::size_t particles, Vtk kind);
std::string legacy_vtk(const std::vector<Field>& fields, std::size_t particles, Bytes bytes);
std::string nairn(const State& s);

inline std::filesystem::path write(const std::string& name, const std::string& content) {
  auto file = std::filesystem::temp_directory_path() / fmt::format("mpmvv-{}-{}", ::getpid(), name);
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

}  // namespace mpmvv::written_run
