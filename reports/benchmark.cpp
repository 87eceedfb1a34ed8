#include "reports/benchmark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "studies/fits/median.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/not_measured.hpp"

namespace mpmvv::reports {

namespace {

/// The name without the number of repetitions that Google Benchmark appends.
std::string name_of(const nlohmann::json& run) {
  const std::string name = run.at("run_name");
  return name.substr(0, name.find("/repeats:"));
}

void add_run(const nlohmann::json& run, Benchmark& benchmark) {
  if (run.at("run_type") != "iteration" || run.value("error_occurred", false)) return;
  const std::string name = name_of(run);
  auto row = std::ranges::find(benchmark.rows, name, &BenchmarkRow::name);
  if (row == benchmark.rows.end())
    row = benchmark.rows.insert(row, BenchmarkRow{name, run.value("label", std::string()), {}});
  for (const auto& [key, value] : run.items())
    if (value.is_number()) row->counters[key].push_back(value.get<double>());
}

/// The order in which the program names its benchmarks; interleaved repetitions are reported in another one.
double order_of(const BenchmarkRow& row) {
  const auto it = row.counters.find("family_index");
  return it == row.counters.end() ? 0 : it->second.front();
}

}  // namespace

double BenchmarkRow::median(const std::string& counter) const {
  const auto it = counters.find(counter);
  if (it == counters.end()) return support::not_measured;
  return fits::median_of(it->second);
}

double BenchmarkRow::range(const std::string& counter) const {
  const auto it = counters.find(counter);
  if (it == counters.end()) return support::not_measured;
  const auto [least, largest] = std::ranges::minmax(it->second);
  return (largest - least) / median(counter);
}

const BenchmarkRow* Benchmark::find(const std::string& name) const {
  const auto it = std::ranges::find(rows, name, &BenchmarkRow::name);
  return it == rows.end() ? nullptr : &*it;
}

std::optional<Benchmark> read_benchmark(const std::filesystem::path& file) {
  const auto text = support::read_file(file);
  if (!text) return std::nullopt;
  try {
    const auto json = nlohmann::json::parse(*text);
    Benchmark benchmark{json.at("context").value("digest", ""), json.at("context").value("date", ""), {}};
    for (const auto& run : json.at("benchmarks")) add_run(run, benchmark);
    std::ranges::stable_sort(benchmark.rows, {}, order_of);
    return benchmark;
  } catch (const nlohmann::json::exception&) {
    throw support::UsageError(
        fmt::format("{} is not what the benchmark writes (`./run benchmark` makes it anew)", file.string()));
  }
}

}  // namespace mpmvv::reports
