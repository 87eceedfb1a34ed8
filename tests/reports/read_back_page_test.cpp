#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <tuple>
#include <utility>

#include "tests/reports/distinct.hpp"
#include "tests/reports/written_report.hpp"

/// What stands where on a report's pages beside its studies: the benchmark, mutants.
namespace mpmvv::reports::read_back_page_test {

using read_back::ExpectedTable;
using read_back::WrittenReport;

/// Times in ns per particle and step.
BenchmarkRow timed(const std::string& name, std::vector<double> nanoseconds) {
  for (double& t : nanoseconds) t *= 1e-9;
  return {name, "label of " + name, {{"per_particle_step", nanoseconds}}};
}

BenchmarkRow step(const std::string& name, std::vector<double> nanoseconds, double multiply_adds, double bytes) {
  BenchmarkRow row = timed(name, std::move(nanoseconds));
  row.counters["least_multiply_adds"] = {multiply_adds};
  row.counters["least_bytes"] = {bytes};
  return row;
}

BenchmarkRow moving(const std::string& name, std::vector<double> nanoseconds, double multiply_adds, double bytes,
                    double particles, double steps) {
  BenchmarkRow row = step(name, std::move(nanoseconds), multiply_adds, bytes);
  row.counters["particles"] = {particles};
  row.counters["steps"] = {steps};
  return row;
}

Benchmark measured() {
  return {"d1935",
          "2026-03-04",
          {timed("skip/log/paid", {30, 21, 20}),
           timed("skip/log/skipped", {10, 11, 16}),
           timed("skip/store/paid", {9.6, 9.67, 9.9}),
           timed("skip/store/skipped", {0.035, 0.0357, 0.036}),
           moving("case/2D/linear/square", {95, 99, 108}, 110, 240, 64, 12),
           moving("case/2D/cubic/ring", {121, 125, 134}, 330, 490, 81, 13),
           step("block/2D/linear", {50, 53, 55}, 100, 230),
           step("block/2D/cubic", {60, 67, 70}, 310, 480),
           step("block/3D/linear", {80, 84, 92}, 520, 750),
           timed("threads/square/one", {31, 35, 34}),
           timed("threads/square/two", {17, 20, 18}),
           {"machine/multiply-adds", "", {{"multiply_adds", {2e10}}}},
           {"machine/multiply-adds/real_time/threads:2", "", {{"multiply_adds", {3.1e10}}}},
           {"machine/triad", "", {{"bytes", {1.3e10}}}}}};
}

std::string percent(double fraction) {
  return fmt::format("{:.1f}", 100 * fraction);
}

ExpectedTable what_is_skipped() {
  ExpectedTable table;
  table.add("", {{"what is skipped", "label of skip/log/paid"},
                 {"paid", "21.0"},
                 {"paid, range %", percent(10.0 / 21)},
                 {"skipped", "11.0"},
                 {"skipped, range %", percent(6.0 / 11)},
                 {"saved", "10 ± 16"},  // the ranges are 10 and 6 ns, of 21 and 11
                 {"saved %", "48 ± 54"}});
  table.add("", {{"what is skipped", "label of skip/store/paid"},
                 {"paid", "9.67"},
                 {"paid, range %", percent(0.3 / 9.67)},
                 {"skipped", "0.0357"},
                 {"skipped, range %", percent(0.001 / 0.0357)},
                 {"saved", "9.63 ± 0.30"},
                 {"saved %", "99.631 ± 0.022"}});
  return table;
}

/// A row with its multiply-adds and bytes as shares of the machine's.
read_back::Row roofline(read_back::Row row, int ns, int work, int bytes) {
  row.insert(row.end(), {{"least multiply-adds", std::to_string(work)},
                         {"% of peak", percent(work / (20.0 * ns))},
                         {"least bytes", std::to_string(bytes)},
                         {"% of bandwidth", percent(bytes / (13.0 * ns))}});
  return row;
}

ExpectedTable blocks() {
  ExpectedTable table;
  const auto add = [&table](const char* group, const char* basis, int ns, double spread, int work, int bytes) {
    table.add(group,
              roofline({{"basis", basis}, {"ns", fmt::format("{:.1f}", 1.0 * ns)}, {"range %", percent(spread / ns)}},
                       ns, work, bytes));
  };
  add("2D", "linear", 53, 5, 100, 230), add("2D", "cubic", 67, 10, 310, 480);
  add("3D", "linear", 84, 12, 520, 750);
  return table;
}

ExpectedTable cases() {
  ExpectedTable table;
  table.add("2D", roofline({{"case", "square"},
                            {"basis", "linear"},
                            {"particles", "64"},
                            {"steps", "12"},
                            {"ns", "99.0"},
                            {"range %", percent(13.0 / 99)},
                            {"of the block's", fmt::format("{:.2f}", 99.0 / 53)}},
                           99, 110, 240));
  table.add("2D", roofline({{"case", "ring"},
                            {"basis", "cubic"},
                            {"particles", "81"},
                            {"steps", "13"},
                            {"ns", "125"},
                            {"range %", percent(13.0 / 125)},
                            {"of the block's", fmt::format("{:.2f}", 125.0 / 67)}},
                           125, 330, 490));
  return table;
}

ExpectedTable threads() {
  ExpectedTable table;
  table.add("", {{"case", "square"},
                 {"one thread", "34.0"},
                 {"one thread, range %", percent(4.0 / 34)},
                 {"two threads", "18.0"},
                 {"two threads, range %", percent(3.0 / 18)},
                 {"times as fast", fmt::format("{:.2f}", 34.0 / 18)}});
  return table;
}

ExpectedTable machine() {
  ExpectedTable table;
  table.add("", {{"", "multiply-adds in double precision, 1e9/s"}, {"measured", "20"}});
  table.add("", {{"", "the same on two threads, together"}, {"measured", "31"}});
  table.add("", {{"", "memory bandwidth (triad), 1e9 bytes/s"}, {"measured", "13"}});
  table.add("", {{"", "date"}, {"measured", "2026-03-04"}});
  return table;
}

TEST(ReadBackPage, BenchmarkHasEveryTimeUnderItsName) {
  ReportInput input = read_back::input_of(distinct::everything());
  input.benchmark = measured();
  const WrittenReport report(input);
  for (const auto table : {what_is_skipped, cases, blocks, threads, machine}) report.expect_html_and_latex(table());
}

/// What the stages say of a mutant: c(aught), p(asses), or nothing more.
MutantResult mutant(const std::string& name, const std::string& stages, const std::string& reason = "") {
  static int line = 10;
  MutantResult m{.name = name, .what = "what of " + name, .file = name + ".cpp", .line = ++line};
  m.before = "before " + name, m.after = "after " + name, m.reason = reason;
  const std::array<std::pair<std::optional<StageResult>*, const char*>, 3> all{
      {{&m.unit_tests, "unit tests"}, {&m.quick, "quick"}, {&m.nightly, "nightly"}}};
  for (std::size_t k = 0; k < stages.size(); ++k) {
    StageResult& stage = all[k].first->emplace();
    stage.caught = stages[k] == 'c';
    if (stage.caught) stage.by = {fmt::format("{} by {}", name, all[k].second)};
  }
  return m;
}

std::string stage_text(const MutantResult& m, const std::optional<StageResult>& stage) {
  if (m.is_untried()) return "not tried yet";
  return !stage ? "–" : stage->caught ? stage->by[0] : "passes";
}

/// What is planted, of which some should show and one cannot, and what of the random ones survived.
struct Mutants {
  std::vector<MutantResult> shown{mutant("a", "cc"),  mutant("b", "cc"),  mutant("c", "cp"), mutant("d", "cp"),
                                  mutant("e", "ppc"), mutant("f", "ppp"), mutant("g", ""),   mutant("h", "")};
  std::vector<MutantResult> silent{mutant("s", "pp", "only slower")};
  std::vector<MutantResult> survivors{mutant("r4", "ppp"), mutant("r5", "pp", "equivalent")};

  MutationResults results() const {
    MutationResults all;
    all.planted = {
        .should_show = 8, .equivalent = 1, .unit_tests = 4, .quick = 2, .nightly = 1, .caught = 5, .untried = 2};
    all.random = {.tried = 5, .caught = 3, .explained = 1};
    all.mistakes = shown;
    all.mistakes.insert(all.mistakes.end(), silent.begin(), silent.end());
    all.survivors = survivors;
    return all;
  }
};

ExpectedTable score() {
  ExpectedTable table;
  const auto add = [&table](const std::vector<std::string>& cells) {
    table.add("", {{"mistakes", cells[0]},
                   {"unit tests", cells[1]},
                   {"quick gate", cells[2]},
                   {"nightly gate, of what these miss", cells[3]},
                   {"any of them", cells[4]},
                   {"explained", cells[5]}});
  };
  add({"planted, should show", "4 of 6 (67 %)", "2 of 6 (33 %)", "1", "5 of 6 (83 %)", ""});
  add({"planted, not tried yet: 2", "", "", "", "", ""});
  add({"planted, efficiency or robustness only: 1", "", "", "", "", ""});
  add({"random", "", "", "", "3 of 5 (60 %)", "1 of 2 (50 %)"});
  return table;
}

std::string place(const MutantResult& m) {
  return fmt::format("{}:{}", m.file, m.line);
}

ExpectedTable mistakes(const Mutants& mutants) {
  ExpectedTable table;
  const auto add = [&table](const std::string& group, const std::vector<MutantResult>& of_it) {
    for (const MutantResult& m : of_it)
      table.add(group, {{"mistake", m.name},
                        {"what", m.what},
                        {"where", place(m)},
                        {"unit tests", stage_text(m, m.unit_tests)},
                        {"quick gate", stage_text(m, m.quick)},
                        {"nightly gate", stage_text(m, m.nightly)},
                        {"reason", m.reason}});
  };
  add("that an order, an error, a limit or a report can show", mutants.shown);
  add("that change efficiency or robustness only", mutants.silent);
  return table;
}

ExpectedTable random_ones(const Mutants& mutants) {
  ExpectedTable table;
  for (const MutantResult& m : mutants.survivors)
    table.add(m.reason.empty() ? "not explained" : "explained", {{"mutation", m.name},
                                                                 {"where", place(m)},
                                                                 {"line", m.before},
                                                                 {"with the mutation", m.after},
                                                                 {"reason", m.reason}});
  return table;
}

TEST(ReadBackPage, MutantsHaveEveryStageUnderItsName) {
  const Mutants mutants;
  ReportInput input = read_back::input_of(distinct::everything());
  input.mutation = mutants.results();
  const WrittenReport report(input);
  for (const ExpectedTable& table : {score(), mistakes(mutants), random_ones(mutants)})
    report.expect_html_and_latex(table);
}

TEST(ReadBackPage, FalseAlarmsStandByBuild) {
  ReportInput input = read_back::input_of(distinct::everything());
  input.mutation = Mutants().results();
  input.alarms = {{.build = "clang++", .runs = 2, .judged = 25, .alarms = 1},
                  {.build = "g++", .runs = 1, .judged = 7, .alarms = 0}};
  ExpectedTable alarms;
  for (const auto& [build, runs, judged, alarm] : {std::tuple("clang++", 2, 25, 1), std::tuple("g++", 1, 7, 0)})
    alarms.add("", {{"build", build},
                    {"runs", std::to_string(runs)},
                    {"goldens judged", std::to_string(judged)},
                    {"false alarms", std::to_string(alarm)}});
  WrittenReport(input).expect_html_and_latex(alarms);
}

}  // namespace mpmvv::reports::read_back_page_test
