#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/benchmark.hpp"
#include "reports/published_costs.hpp"
#include "reports/text.hpp"
#include "studies/support/not_measured.hpp"

namespace mpmvv::reports {

namespace {

constexpr const char* per_step = "per_particle_step";  ///< s

/// The parts of a benchmark's name: its kind, its filling (the dimension and the particles per cell), its basis and,
/// for a case, which one.
struct RowName {
  std::string kind, filling, basis, what;
};

RowName parts_of(const BenchmarkRow& row) {
  std::array<std::string, 4> parts;
  std::size_t begin = 0;
  for (std::string& part : parts) {
    const std::size_t end = &part == &parts.back() ? std::string::npos : row.name.find('/', begin);
    part = row.name.substr(begin, end - begin);
    if (end == std::string::npos) break;
    begin = end + 1;
  }
  return {parts[0], parts[1], parts[2], parts[3]};
}

std::string nanoseconds(double seconds) {
  return three_digits(1e9 * seconds);
}

std::string percent(double fraction) {
  return std::isnan(fraction) ? "–" : fmt::format("{:.1f}", 100 * fraction);
}

std::string ratio(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.2f}", value);
}

/// A difference of numbers and the sum of their ranges, both to the second digit of that sum: "1.2 ± 3.7".
std::string with_range(double value, double range) {
  if (!(range > 0)) return three_digits(value);
  const int place = static_cast<int>(std::floor(std::log10(range))) - 1;
  const double unit = std::pow(10, place);
  const auto text = [&](double number) {
    return fmt::format("{:.{}f}", std::round(number / unit) * unit + 0.0, std::max(0, -place));
  };
  return text(value) + " ± " + text(range);
}

double machine(const Benchmark& benchmark, const std::string& name, const std::string& counter) {
  const BenchmarkRow* row = benchmark.find("machine/" + name);
  return row ? row->median(counter) : support::not_measured;
}

/// The least multiply-adds and bytes of a step, and which share of what the machine can do they take.
std::array<std::string, 4> roofline(const Benchmark& benchmark, const BenchmarkRow& row) {
  const double seconds = row.median(per_step);
  const double work = row.median("least_multiply_adds"), bytes = row.median("least_bytes");
  return {brief(work), percent(work / seconds / machine(benchmark, "multiply-adds", "multiply_adds")), brief(bytes),
          percent(bytes / seconds / machine(benchmark, "triad", "bytes"))};
}

Table::Group& group_titled(Table& table, const std::string& title) {
  const auto group = std::ranges::find(table.groups, title, &Table::Group::title);
  return group != table.groups.end() ? *group : table.groups.emplace_back(Table::Group{title, {}});
}

Table case_table(const Benchmark& benchmark) {
  Table table{
      "Cost of a step on one core in the studies' cases, each over its whole end time with its body force: ns per "
      "particle and step, beside the static block of the same basis; the least multiply-adds and bytes of a step, and "
      "what shares of the machine's peak and bandwidth they are",
      {"case", "basis", "particles", "steps", "ns", "range %", "of the block's", "least multiply-adds", "% of peak",
       "least bytes", "% of bandwidth"},
      {}};
  for (const BenchmarkRow& row : benchmark.rows) {
    const RowName name = parts_of(row);
    if (name.kind != "case") continue;
    const BenchmarkRow* block = benchmark.find(fmt::format("block/{}/{}", name.filling, name.basis));
    const double seconds = row.median(per_step);
    const auto [work, of_peak, bytes, of_bandwidth] = roofline(benchmark, row);
    group_titled(table, name.filling)
        .rows.push_back({name.what, name.basis, fmt::format("{}", row.median("particles")),
                         fmt::format("{}", row.median("steps")), nanoseconds(seconds), percent(row.range(per_step)),
                         ratio(block ? seconds / block->median(per_step) : support::not_measured), work, of_peak, bytes,
                         of_bandwidth});
  }
  return table;
}

Table block_table(const Benchmark& benchmark) {
  Table table{
      "Micro-benchmark: 20 steps of a static block, no particle of which leaves its cell, without a body force, on one "
      "core",
      {"basis", "ns", "range %", "least multiply-adds", "% of peak", "least bytes", "% of bandwidth"},
      {}};
  for (const BenchmarkRow& row : benchmark.rows) {
    const RowName name = parts_of(row);
    if (name.kind != "block") continue;
    const auto [work, of_peak, bytes, of_bandwidth] = roofline(benchmark, row);
    group_titled(table, name.filling)
        .rows.push_back({name.basis, nanoseconds(row.median(per_step)), percent(row.range(per_step)), work, of_peak,
                         bytes, of_bandwidth});
  }
  return table;
}

/// Calls `add` with the pairs "KIND/.../FIRST" and "KIND/.../SECOND".
template <class Add>
void for_pairs(const Benchmark& benchmark, const std::string& kind, const std::string& first, const std::string& second,
               const Add& add) {
  for (const BenchmarkRow& row : benchmark.rows) {
    if (!row.name.starts_with(kind + "/") || !row.name.ends_with("/" + first)) continue;
    const std::string stem = row.name.substr(0, row.name.size() - first.size());
    if (const BenchmarkRow* other = benchmark.find(stem + second))
      add(stem.substr(kind.size() + 1, stem.size() - kind.size() - 2), row, *other);
  }
}

Table skip_table(const Benchmark& benchmark) {
  Table table{"What scenes skip, and what that saves over a case's whole end time: ns per particle and step",
              {"what is skipped", "paid", "paid, range %", "skipped", "skipped, range %", "saved", "saved %"},
              {}};
  for_pairs(benchmark, "skip", "paid", "skipped",
            [&](const std::string&, const BenchmarkRow& paid, const BenchmarkRow& skipped) {
              const double with = paid.median(per_step), without = skipped.median(per_step);
              const double of_with = paid.range(per_step), of_without = skipped.range(per_step);
              const double saved = 1e9 * (with - without), range = 1e9 * (with * of_with + without * of_without);
              const double share = 100 * without / with;
              group_titled(table, "").rows.push_back(
                  {paid.label, nanoseconds(with), percent(of_with), nanoseconds(without), percent(of_without),
                   with_range(saved, range), with_range(100 - share, share * (of_with + of_without))});
            });
  return table;
}

Table thread_table(const Benchmark& benchmark) {
  Table table{
      "What two threads make of a case, quadratic B-splines, whole end time: ns per particle and step, of one by the "
      "processor's time, of two by the clock",
      {"case", "one thread", "one thread, range %", "two threads", "two threads, range %", "times as fast"},
      {}};
  for_pairs(benchmark, "threads", "one", "two",
            [&](const std::string& what, const BenchmarkRow& alone, const BenchmarkRow& both) {
              const double of_one = alone.median(per_step), of_two = both.median(per_step);
              group_titled(table, "").rows.push_back({what, nanoseconds(of_one), percent(alone.range(per_step)),
                                                      nanoseconds(of_two), percent(both.range(per_step)),
                                                      ratio(of_one / of_two)});
            });
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

std::vector<Table> benchmark_tables(const Benchmark& benchmark) {
  std::vector<Table> tables{case_table(benchmark),    others_table(benchmark, published_costs()),
                            skip_table(benchmark),    thread_table(benchmark),
                            machine_table(benchmark), block_table(benchmark)};
  std::erase_if(tables, [](const Table& t) { return t.empty(); });
  return tables;
}

}  // namespace mpmvv::reports
