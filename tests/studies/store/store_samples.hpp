#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "studies/store/store.hpp"
#include "studies/support/error.hpp"
#include "tests/own_folder.hpp"

namespace mpmvv::store::store_samples {

/// A folder of its own for every test, gone at its end.
class StoreTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ = own_folder("store");
  std::filesystem::path file_ = folder_ / "results.db";
};

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return (std::stringstream() << stream.rdbuf()).str();
}

/// What the UsageError says that this throws; empty when it throws none.
template <class Action>
std::string complaint(const Action& action) {
  try {
    action();
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return {};
}

inline Provenance provenance(const std::string& digest = "d1") {
  return {.digest = digest,
          .commit = "c0ffee",
          .dirty = true,
          .compiler = "GNU 12.2.0",
          .flags = "-O3",
          .build_type = "Release",
          .cpu = "A \"fast\", one",
          .time = "2024-05-06T07:08:09Z"};
}

inline cases::Case bar(int cells) {
  return {.problem = {.name = "bar", .parameters = {{"amplitude", 0.05}}, .end_time = 0.01},
          .scheme = {.basis = "bspline2", .integrator = "cd", .boundary = "xmin=symmetry,xmax=free"},
          .resolution = {.cells = cells, .ppc = 4, .dt = 0.01 / 3, .steps = 3},
          .measure = {}};
}

inline records::Record record(int cells) {
  return {.the_case = bar(cells),
          .particles = 4 * cells,
          .steps = 3,
          .cfl = 1.0 / 3,
          .status = records::Status::ok,
          .reason = "",
          .error = {.l1 = 0.1 / cells, .l2 = 0.2 / cells, .linf = 0.3 / cells},
          .energy = {.kinetic = 1.0 / 7, .strain = 1e-300, .initial_total = 5},
          .balance = {.mass = 0, .momentum = 3e-16, .angular_momentum = 0.01},
          .wall_seconds = 1e-3,
          .ns_per_particle_step = 12.5};
}

inline records::StudyResult study(const std::string& name, const std::string& title = "",
                                  std::vector<records::Series> series = {}) {
  records::StudyResult s;
  s.name = name;
  s.title = title;
  s.series = std::move(series);
  return s;
}

inline records::Series series(const std::string& name, std::vector<records::Point> points = {}) {
  records::Series s;
  s.name = name;
  s.points = std::move(points);
  return s;
}

inline records::Point point(double x, std::map<std::string, double> y = {}) {
  records::Point p;
  p.x = x;
  p.y = std::move(y);
  return p;
}

}  // namespace mpmvv::store::store_samples
