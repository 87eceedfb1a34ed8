#include "reports/benchmark.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reports/report.hpp"
#include "studies/support/error.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports {
namespace benchmark_test {

using testing::ElementsAre;
using testing::HasSubstr;

/// Three repetitions of a pair, one of a step, the machine, two threads, an aggregate and a failure, as Google
/// Benchmark writes them.
constexpr const char* answer = R"({
  "context": {"date": "2026-01-02T03:04:05+00:00", "digest": "d1", "num_cpus": 2},
  "benchmarks": [
    {"run_name": "skip/log/paid", "run_type": "iteration", "label": "no logarithm", "per_particle_step": 30e-9},
    {"run_name": "skip/log/skipped", "run_type": "iteration", "label": "no logarithm", "per_particle_step": 10e-9},
    {"run_name": "skip/log/paid", "run_type": "iteration", "label": "no logarithm", "per_particle_step": 20e-9},
    {"run_name": "skip/log/skipped", "run_type": "iteration", "label": "no logarithm", "per_particle_step": 10e-9},
    {"run_name": "skip/log/paid", "run_type": "iteration", "label": "no logarithm", "per_particle_step": 21e-9},
    {"run_name": "skip/log/skipped", "run_type": "iteration", "label": "no logarithm", "per_particle_step": 15e-9},
    {"run_name": "skip/log/paid", "run_type": "aggregate", "aggregate_name": "mean", "per_particle_step": 7},
    {"run_name": "step/3D, 8 per cell/linear", "run_type": "iteration", "per_particle_step": 50e-9,
     "least_multiply_adds": 100, "least_bytes": 200},
    {"run_name": "step/3D, 8 per cell/broken", "run_type": "iteration", "error_occurred": true},
    {"run_name": "threads/square/one/real_time", "run_type": "iteration", "per_particle_step": 30e-9},
    {"run_name": "threads/square/two/real_time", "run_type": "iteration", "per_particle_step": 15e-9},
    {"run_name": "machine/multiply-adds", "run_type": "iteration", "multiply_adds": 2e10},
    {"run_name": "machine/triad", "run_type": "iteration", "bytes": 1e10}
  ]})";

Benchmark benchmark_of(const TempFolder& folder, const std::string& text) {
  std::ofstream(folder / "benchmark.json") << text;
  return read_benchmark(folder / "benchmark.json").value();
}

TEST(Benchmark, MediansOverRepetitionsWithoutAggregatesAndFailures) {
  const TempFolder folder;
  const Benchmark benchmark = benchmark_of(folder, answer);
  EXPECT_EQ(benchmark.digest, "d1");
  EXPECT_EQ(benchmark.rows.size(), 7u);
  EXPECT_EQ(benchmark.find("skip/log/paid")->median("per_particle_step"), 21e-9);
  EXPECT_NEAR(benchmark.find("skip/log/paid")->range("per_particle_step"), 10.0 / 21, 1e-12);
  EXPECT_TRUE(std::isnan(benchmark.find("machine/triad")->median("per_particle_step")));
  EXPECT_EQ(benchmark.find("step/3D, 8 per cell/broken"), nullptr);
}

TEST(Benchmark, TablesOfSkippingStepsThreadsAndMachine) {
  const TempFolder folder;
  const auto tables = benchmark_tables(benchmark_of(folder, answer));
  ASSERT_EQ(tables.size(), 4u);
  EXPECT_THAT(tables[0].groups[0].rows,
              ElementsAre(ElementsAre("no logarithm", "21", "47.6", "10", "50.0", "11", "52.4")));
  EXPECT_EQ(tables[1].groups[0].title, "3D, 8 per cell");
  // 100 in 50 ns are 2e9 per second, a tenth of the peak; 200 bytes are 4e9 per second, four tenths.
  EXPECT_THAT(tables[1].groups[0].rows, ElementsAre(ElementsAre("linear", "50", "0.0", "100", "10.0", "200", "40.0")));
  EXPECT_THAT(tables[2].groups[0].rows, ElementsAre(ElementsAre("square", "30", "0.0", "15", "0.0", "2.00")));
  EXPECT_EQ(tables[3].groups[0].rows[0][1], "20");
}

TEST(Benchmark, RowsStandInTheProgramsOrder) {
  const TempFolder folder;
  const auto benchmark = benchmark_of(folder, R"({"context": {}, "benchmarks": [
    {"run_name": "b", "run_type": "iteration", "family_index": 1},
    {"run_name": "a", "run_type": "iteration", "family_index": 0},
    {"run_name": "b", "run_type": "iteration", "family_index": 1}]})");
  ASSERT_EQ(benchmark.rows.size(), 2u);
  EXPECT_EQ(benchmark.rows[0].name, "a");
}

TEST(Benchmark, WithoutRowsThereAreNoTables) {
  const TempFolder folder;
  EXPECT_TRUE(benchmark_tables(benchmark_of(folder, R"({"context": {}, "benchmarks": []})")).empty());
}

TEST(Benchmark, AbsentIsNoneAndAnythingElseIsRefused) {
  const TempFolder folder;
  EXPECT_FALSE(read_benchmark(folder / "benchmark.json"));
  for (const char* text : {"", "no json", "{}", R"({"context": {}, "benchmarks": [{}]})"})
    EXPECT_THROW(benchmark_of(folder, text), support::UsageError) << text;
}

TEST(Benchmark, StandsInTheReport) {
  const TempFolder folder;
  ReportInput input;
  input.studies = {synthetic::check()};
  input.benchmark = benchmark_of(folder, answer);
  write_report(input, folder / "out", [](const std::string&) {});
  const auto page = content(folder / "out" / "index.html");
  EXPECT_THAT(page, HasSubstr("<td>no logarithm</td><td>21</td>"));
  EXPECT_THAT(page, HasSubstr("href=\"#benchmark\""));
  EXPECT_THAT(page, HasSubstr("partition_of_unity")) << "the studies' tables are still there";
  EXPECT_THAT(content(folder / "out" / "tables" / "program" / "benchmark.tex"), HasSubstr("no logarithm & 21"));
  input.benchmark.reset();
  write_report(input, folder / "out", [](const std::string&) {});
  EXPECT_THAT(content(folder / "out" / "index.html"), testing::Not(HasSubstr("#benchmark")));
}

}  // namespace benchmark_test
}  // namespace mpmvv::reports
