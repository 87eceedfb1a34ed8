#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/table.hpp"

namespace mpmvv::reports {

/// One benchmark over all its repetitions.
struct BenchmarkRow {
  std::string name;   ///< parts divided by `/`
  std::string label;  ///< what it says of itself; may be empty
  std::map<std::string, std::vector<double>> counters;

  double median(const std::string& counter) const;  ///< NaN when it has none
  double range(const std::string& counter) const;   ///< largest minus smallest over the median
};

/// What the benchmark program measured, on which program.
struct Benchmark {
  std::string digest;
  std::string date;
  std::vector<BenchmarkRow> rows;  ///< in the program's order

  /// The row of this name; null when there is none.
  const BenchmarkRow* find(const std::string& name) const;
};

/// Reads Google Benchmark's JSON; nullopt when the file is absent. Benchmarks that failed are left out.
/// Throws UsageError on anything else.
std::optional<Benchmark> read_benchmark(const std::filesystem::path& file);

/// The cost of a step in the studies' cases, and in other codes; what scenes skip and what that saves; what threads
/// make of it, and what the machine can do; the cost of a step in static blocks. Each is left out where there is
/// nothing to show.
std::vector<Table> benchmark_tables(const Benchmark& benchmark);

}  // namespace mpmvv::reports
