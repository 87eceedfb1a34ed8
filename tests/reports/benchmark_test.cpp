#include "reports/benchmark.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "reports/report.hpp"
#include "studies/support/error.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

namespace mpmvv::reports::benchmark_test {

using testing::ElementsAre;
using testing::HasSubstr;

/// Three repetitions of a pair, one of a case, of its block and of another, the machine, two threads, an aggregate and
/// a failure, as Google Benchmark writes them.
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
    {"run_name": "case/3D, 8 per cell/linear/cube, 32 cells/repeats:1", "run_type": "iteration",
     "per_particle_step": 80e-9, "particles": 262144, "steps": 80, "least_multiply_adds": 100, "least_bytes": 200},
    {"run_name": "case/2D, 4 per cell/cpdi/alone/repeats:1", "run_type": "iteration", "per_particle_step": 8.24e-9,
     "particles": 64, "steps": 5, "least_multiply_adds": 10, "least_bytes": 20},
    {"run_name": "block/3D, 8 per cell/linear", "run_type": "iteration", "per_particle_step": 50e-9,
     "least_multiply_adds": 100, "least_bytes": 200},
    {"run_name": "block/3D, 8 per cell/broken", "run_type": "iteration", "error_occurred": true},
    {"run_name": "threads/square/one", "run_type": "iteration", "per_particle_step": 30e-9},
    {"run_name": "threads/square/two", "run_type": "iteration", "per_particle_step": 15e-9},
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
  EXPECT_EQ(benchmark.rows.size(), 9u);
  EXPECT_EQ(benchmark.find("skip/log/paid")->median("per_particle_step"), 21e-9);
  EXPECT_NEAR(benchmark.find("skip/log/paid")->range("per_particle_step"), 10.0 / 21, 1e-12);
  EXPECT_TRUE(std::isnan(benchmark.find("machine/triad")->median("per_particle_step")));
  EXPECT_EQ(benchmark.find("block/3D, 8 per cell/broken"), nullptr);
  EXPECT_NE(benchmark.find("case/3D, 8 per cell/linear/cube, 32 cells"), nullptr) << "without how often it ran";
}

TEST(Benchmark, CasesStandBesideTheirBlock) {
  const TempFolder folder;
  const Table table = benchmark_tables(benchmark_of(folder, answer)).at(0);
  ASSERT_EQ(table.groups.size(), 2u);
  EXPECT_EQ(table.groups[0].title, "3D, 8 per cell");
  // 100 in 80 ns are 1.25e9 per second, a sixteenth of the peak; 200 bytes are 2.5e9 per second, a quarter.
  EXPECT_THAT(table.groups[0].rows, ElementsAre(ElementsAre("cube, 32 cells", "linear", "262144", "80", "80.0", "0.0",
                                                            "1.60", "100", "6.2", "200", "25.0")));
  EXPECT_THAT(table.groups[1].rows,
              ElementsAre(ElementsAre("alone", "cpdi", "64", "5", "8.24", "0.0", "–", "10", "6.1", "20", "24.3")));
}

TEST(Benchmark, TablesOfSkippingThreadsMachineAndBlocks) {
  const TempFolder folder;
  const auto tables = benchmark_tables(benchmark_of(folder, answer));
  ASSERT_EQ(tables.size(), 5u);
  EXPECT_THAT(tables[1].groups[0].rows,
              ElementsAre(ElementsAre("no logarithm", "21.0", "47.6", "10.0", "50.0", "11 ± 15", "52 ± 46")));
  EXPECT_THAT(tables[2].groups[0].rows, ElementsAre(ElementsAre("square", "30.0", "0.0", "15.0", "0.0", "2.00")));
  EXPECT_EQ(tables[3].groups[0].rows[0][1], "20");
  EXPECT_THAT(tables[4].caption, HasSubstr("Micro-benchmark"));
  EXPECT_EQ(tables[4].groups[0].title, "3D, 8 per cell");
  // 100 in 50 ns are 2e9 per second, a tenth of the peak; 200 bytes are 4e9 per second, four tenths.
  EXPECT_THAT(tables[4].groups[0].rows,
              ElementsAre(ElementsAre("linear", "50.0", "0.0", "100", "10.0", "200", "40.0")));
}

TEST(Benchmark, NoTwoColumnsOfATableHaveOneHead) {
  const TempFolder folder;
  for (const Table& table : benchmark_tables(benchmark_of(folder, answer))) {
    const std::set<std::string> heads(table.columns.begin(), table.columns.end());
    EXPECT_EQ(heads.size(), table.columns.size()) << table.caption;
  }
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
  input.benchmark->rows.push_back({"case/2D, 4 per cell/bspline2/block", "", {{"per_particle_step", {5e-8}}}});
  write_report(input, folder / "out", [](const std::string&) {});
  const auto page = content(folder / "out" / "benchmark.html");
  EXPECT_THAT(page, HasSubstr("<tr><th scope=\"row\" class=\"w\">no logarithm<td>21.0<td>"));
  EXPECT_THAT(page,
              HasSubstr("<a href=\"https://github.com/nairnj/nairn-mpm-fea\">github.com/nairnj/nairn-mpm-fea</a>"));
  EXPECT_THAT(content(folder / "out" / "index.html"), HasSubstr("href=\"benchmark.html\""));
  EXPECT_THAT(content(folder / "out" / "tables" / "program" / "benchmark.tex"), HasSubstr("no logarithm & $21.0$"));
  input.benchmark.reset();
  write_report(input, folder / "out", [](const std::string&) {});
  EXPECT_THAT(content(folder / "out" / "index.html"), testing::Not(HasSubstr("benchmark.html")));
}

}  // namespace mpmvv::reports::benchmark_test
