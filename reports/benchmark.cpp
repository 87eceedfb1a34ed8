#include "reports/benchmark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/text.hpp"
#include "studies/fits/median.hpp"
#include "studies/records/record.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::reports {

namespace {

constexpr const char* per_step = "per_particle_step";  ///< s

void add_run(const nlohmann::json& run, Benchmark& benchmark) {
  if (run.at("run_type") != "iteration" || run.value("error_occurred", false)) return;
  const std::string name = run.at("run_name");
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

/// "a/b/c" without its first part, cut at the last `/`.
std::pair<std::string, std::string> group_and_item(const std::string& name) {
  const auto first = name.find('/') + 1, last = name.rfind('/');
  return {name.substr(first, last - std::min(first, last)), name.substr(last + 1)};
}

std::string nanoseconds(double seconds) {
  return fmt::format("{:.3g}", 1e9 * seconds);
}

std::string percent(double fraction) {
  return std::isnan(fraction) ? "–" : fmt::format("{:.1f}", 100 * fraction);
}

double machine(const Benchmark& benchmark, const std::string& name, const std::string& counter) {
  const BenchmarkRow* row = benchmark.find("machine/" + name);
  return row ? row->median(counter) : support::not_measured;
}

Table skip_table(const Benchmark& benchmark) {
  Table table{"What scenes skip, and what that saves: ns per particle and step, medians of interleaved repetitions",
              {"skipped", "paid", "range %", "skipped", "range %", "saved", "saved %"},
              {}};
  Table::Group group;
  for (const BenchmarkRow& paid : benchmark.rows) {
    if (!paid.name.starts_with("skip/") || !paid.name.ends_with("/paid")) continue;
    const BenchmarkRow* skipped = benchmark.find(paid.name.substr(0, paid.name.size() - 4) + "skipped");
    if (!skipped) continue;
    const double with = paid.median(per_step), without = skipped->median(per_step);
    group.rows.push_back({paid.label, nanoseconds(with), percent(paid.range(per_step)), nanoseconds(without),
                          percent(skipped->range(per_step)), nanoseconds(with - without),
                          percent((with - without) / with)});
  }
  if (!group.rows.empty()) table.groups.push_back(std::move(group));
  return table;
}

Table step_table(const Benchmark& benchmark) {
  Table table{"Cost of a step on one core, and what the method cannot do without, against what the machine can",
              {"basis", "ns per particle and step", "range %", "least multiply-adds", "% of peak", "least bytes",
               "% of bandwidth"},
              {}};
  const double peak = machine(benchmark, "multiply-adds", "multiply_adds");
  const double bandwidth = machine(benchmark, "triad", "bytes");
  for (const BenchmarkRow& row : benchmark.rows) {
    if (!row.name.starts_with("step/")) continue;
    const auto [title, basis] = group_and_item(row.name);
    auto group = std::ranges::find(table.groups, title, &Table::Group::title);
    if (group == table.groups.end()) group = table.groups.insert(group, Table::Group{title, {}});
    const double seconds = row.median(per_step);
    const double work = row.median("least_multiply_adds"), bytes = row.median("least_bytes");
    group->rows.push_back({basis, nanoseconds(seconds), percent(row.range(per_step)), brief(work),
                           percent(work / seconds / peak), brief(bytes), percent(bytes / seconds / bandwidth)});
  }
  return table;
}

Table thread_table(const Benchmark& benchmark) {
  const std::string one = "/one/real_time", two = "/two/real_time";
  Table table{"What two threads make of a step, quadratic B-splines: ns per particle and step",
              {"", "one thread", "range %", "two threads", "range %", "times as fast"},
              {}};
  Table::Group group;
  for (const BenchmarkRow& alone : benchmark.rows) {
    if (!alone.name.starts_with("threads/") || !alone.name.ends_with(one)) continue;
    const BenchmarkRow* both = benchmark.find(alone.name.substr(0, alone.name.size() - one.size()) + two);
    if (!both) continue;
    const double of_one = alone.median(per_step), of_two = both->median(per_step);
    group.rows.push_back({alone.name.substr(8, alone.name.size() - one.size() - 8), nanoseconds(of_one),
                          percent(alone.range(per_step)), nanoseconds(of_two), percent(both->range(per_step)),
                          fmt::format("{:.2f}", of_one / of_two)});
  }
  if (!group.rows.empty()) table.groups.push_back(std::move(group));
  return table;
}

Table machine_table(const Benchmark& benchmark) {
  Table table{
      "What one core of the machine can do, and two threads: processors may share a core", {"", "measured"}, {}};
  const double peak = machine(benchmark, "multiply-adds", "multiply_adds");
  const double of_two = machine(benchmark, "multiply-adds/real_time/threads:2", "multiply_adds");
  const double bandwidth = machine(benchmark, "triad", "bytes");
  if (!std::isnan(peak) || !std::isnan(bandwidth))
    table.groups.push_back({"",
                            {{"multiply-adds in double precision, 1e9/s", brief(peak / 1e9)},
                             {"the same on two threads, together", brief(of_two / 1e9)},
                             {"memory bandwidth (triad), 1e9 bytes/s", brief(bandwidth / 1e9)},
                             {"date", benchmark.date}}});
  return table;
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

std::vector<Table> benchmark_tables(const Benchmark& benchmark) {
  std::vector<Table> tables{skip_table(benchmark), step_table(benchmark), thread_table(benchmark),
                            machine_table(benchmark)};
  std::erase_if(tables, [](const Table& t) { return t.empty(); });
  return tables;
}

}  // namespace mpmvv::reports
