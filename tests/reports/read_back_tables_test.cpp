#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/reports/distinct.hpp"
#include "tests/reports/written_report.hpp"

/// What stands where in the tables of a report, for people and for programs.
namespace mpmvv::reports::read_back_tables_test {

using records::Series;

using read_back::ExpectedTable;
using read_back::WrittenReport;

std::string exact(double v) {
  return fmt::format("{:.17g}", v);
}
std::string brief(double v) {
  return fmt::format("{:.4g}", v);
}
std::string range(double from, double to) {
  return brief(from) + " to " + brief(to);
}
std::string with_interval(double v, double half_width) {
  return fmt::format("{:.2f} ± {:.2f}", v, half_width);
}
std::string word(bool b) {
  return b ? "true" : "false";
}
std::string yes(bool b) {
  return b ? "yes" : "no";
}

/// Calls `add` with every series of the study and each member of the range that it has.
template <class Range, class Add>
void for_each(const records::StudyResult& study, Range Series::*range, const Add& add) {
  for (const Series& series : study.series)
    for (const auto& item : series.*range) add(series, item);
}

/// Files for programs have numbers as they are.
namespace csv {

ExpectedTable points(const records::StudyResult& study) {
  ExpectedTable table;
  for (const Series& s : study.series)
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      const records::Point& p = s.points[i];
      const auto order = [&](std::size_t fit) { return i == 0 ? "" : exact(s.orders[fit].segments[i - 1].order); };
      table.add("", {{"series", s.name},
                     {"x", exact(p.x)},
                     {"status", p.status == records::Status::ok ? "ok" : "unstable"},
                     {"l1", exact(p.y.at("l1"))},
                     {"l1_order", order(0)},
                     {"l2", exact(p.y.at("l2"))},
                     {"linf", exact(p.y.at("linf"))},
                     {"linf_order", order(1)},
                     {"reason", p.reason}});
    }
  return table;
}

ExpectedTable replicates(const records::StudyResult& study) {
  ExpectedTable table;
  for_each(study, &Series::points, [&](const Series& s, const records::Point& p) {
    for (const auto& [quantity, runs] : p.replicates)
      for (std::size_t k = 0; k < runs.size(); ++k)
        table.add("", {{"series", s.name},
                       {"x", exact(p.x)},
                       {"quantity", quantity},
                       {"replicate", std::to_string(k + 1)},
                       {"value", exact(runs[k])}});
  });
  return table;
}

ExpectedTable orders(const records::StudyResult& study) {
  ExpectedTable table;
  for_each(study, &Series::orders, [&](const Series& s, const fits::ObservedOrder& o) {
    table.add("", {{"series", s.name},
                   {"norm", o.norm},
                   {"from", exact(o.from)},
                   {"to", exact(o.to)},
                   {"points", std::to_string(o.points)},
                   {"order", exact(o.order)},
                   {"half_width", exact(o.replicates->half_width)},
                   {"student_half_width", exact(o.half_width)},
                   {"constant", exact(o.constant)},
                   {"r_squared", exact(o.r_squared)},
                   {"asymptotic", word(o.asymptotic)},
                   {"asymptotic_from", exact(o.asymptotic_from)},
                   {"asymptotic_to", exact(o.asymptotic_to)},
                   {"floor_accepted", word(o.floor->accepted)},
                   {"floor", exact(o.floor->floor)},
                   {"floor_order", exact(o.floor->order)},
                   {"floor_constant", exact(o.floor->constant)},
                   {"floor_residual", exact(o.floor->residual)},
                   {"floor_reason", o.floor->reason},
                   {"replicate_observations", std::to_string(o.replicates->observations)},
                   {"replicate_scatter", exact(o.replicates->scatter)},
                   {"replicate_half_width", exact(o.replicates->half_width)},
                   {"lack_of_fit", exact(o.replicates->lack_of_fit)}});
  });
  return table;
}

ExpectedTable extrapolations(const records::StudyResult& study) {
  ExpectedTable table;
  for_each(study, &Series::extrapolations, [&](const Series& s, const fits::Extrapolation& e) {
    table.add("", {{"series", s.name},
                   {"quantity", e.norm},
                   {"from", exact(e.from)},
                   {"to", exact(e.to)},
                   {"points", std::to_string(e.points)},
                   {"model", e.model},
                   {"order", exact(e.order)},
                   {"limit", exact(e.limit)},
                   {"deviation", exact(e.deviation)},
                   {"finest", exact(e.finest)},
                   {"uncertainty", exact(e.uncertainty)},
                   {"convergence_index", exact(e.convergence_index)},
                   {"remark", e.remark}});
  });
  return table;
}

ExpectedTable limits(const records::StudyResult& study) {
  ExpectedTable table;
  for (const Series& s : study.series)
    table.add("", {{"series", s.name},
                   {"key", s.limit->key},
                   {"stable", exact(s.limit->stable)},
                   {"unstable", exact(s.limit->unstable)},
                   {"found", word(s.limit->found)},
                   {"monotone", word(s.limit->monotone)}});
  return table;
}

ExpectedTable probes(const records::StudyResult& study) {
  ExpectedTable table;
  for (const Series& s : study.series)
    for (const fits::Probe& p : s.limit->probes)
      table.add("", {{"series", s.name},
                     {"key", s.limit->key},
                     {"value", exact(p.value)},
                     {"stable", word(p.stable)},
                     {"steps", std::to_string(p.steps)},
                     {"reason", p.reason}});
  return table;
}

ExpectedTable values(const records::StudyResult& study) {
  ExpectedTable table;
  for (const records::Value& v : study.values)
    table.add("", {{"name", v.name}, {"value", exact(v.value)}, {"meaning", v.meaning}});
  return table;
}

}  // namespace csv

TEST(ReadBackTables, FilesForProgramsHaveEveryNumberUnderItsName) {
  const records::StudyResult study = distinct::everything();
  const WrittenReport report(read_back::input_of(study));
  for (const auto table :
       {csv::points, csv::orders, csv::replicates, csv::extrapolations, csv::limits, csv::probes, csv::values})
    report.expect_csv(table(study));
}

/// Tables for people round them, and have their units.
namespace shown {

/// The order of the segment that ends at the i-th point.
std::string segment(const fits::ObservedOrder& o, std::size_t i) {
  return i == 0 ? "–" : fmt::format("{:.2f}", o.segments[i - 1].order);
}

ExpectedTable points(const records::StudyResult& study) {
  ExpectedTable table;
  for (const Series& s : study.series)
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      const records::Point& p = s.points[i];
      table.add(s.name, {{"cells", brief(p.x)},
                         {"status", p.status == records::Status::ok ? "ok" : "unstable"},
                         {"l1 (m)", fmt::format("{:.3e}", p.y.at("l1"))},
                         {"order of l1", segment(s.orders[0], i)},
                         {"linf (m)", fmt::format("{:.3e}", p.y.at("linf"))},
                         {"order of linf", segment(s.orders[1], i)},
                         {"l2 (m)", fmt::format("{:.3e}", p.y.at("l2"))},
                         {"reason", p.reason}});
    }
  return table;
}

ExpectedTable orders(const records::StudyResult& study) {
  ExpectedTable table;
  for_each(study, &Series::orders, [&](const Series& s, const fits::ObservedOrder& o) {
    const std::string floor =
        fmt::format("E0 = {:.4g}, order {:.2f}: {}", o.floor->floor, o.floor->order, o.floor->reason);
    table.add(s.name, {{"norm", o.norm},
                       {"window", range(o.from, o.to)},
                       {"points", std::to_string(o.points)},
                       {"order", with_interval(o.order, o.replicates->half_width)},
                       {"C", brief(o.constant)},
                       {"R²", fmt::format("{:.5f}", o.r_squared)},
                       {"asymptotic", fits::asymptotic_word(o)},
                       {"asymptotic range found", range(o.asymptotic_from, o.asymptotic_to)},
                       {"floor", o.floor->accepted ? floor : o.floor->reason}});
  });
  return table;
}

ExpectedTable replicates(const records::StudyResult& study) {
  ExpectedTable table;
  for_each(study, &Series::orders, [&](const Series& s, const fits::ObservedOrder& o) {
    table.add(s.name, {{"norm", o.norm},
                       {"window", range(o.from, o.to)},
                       {"runs", std::to_string(o.replicates->observations)},
                       {"order", with_interval(o.order, o.replicates->half_width)},
                       {"scatter", brief(o.replicates->scatter)},
                       {"lack of fit p", brief(o.replicates->lack_of_fit)}});
  });
  return table;
}

ExpectedTable extrapolations(const records::StudyResult& study) {
  ExpectedTable table;
  for_each(study, &Series::extrapolations, [&](const Series& s, const fits::Extrapolation& e) {
    table.add(s.name, {{"quantity", e.norm},
                       {"window", range(e.from, e.to)},
                       {"grids", std::to_string(e.points)},
                       {"model", e.model},
                       {"free order", fmt::format("{:.2f}", e.order)},
                       {"limit", brief(e.limit)},
                       {"finest grid", brief(e.finest)},
                       {"uncertainty", brief(e.uncertainty)},
                       {"GCI", brief(e.convergence_index)},
                       {"remark", e.remark}});
  });
  return table;
}

ExpectedTable limits(const records::StudyResult& study) {
  ExpectedTable table;
  for (const Series& s : study.series)
    table.add("", {{"series", s.name},
                   {"key", s.limit->key},
                   {"limit", s.limit->found ? brief((s.limit->stable + s.limit->unstable) / 2) : "not found"},
                   {"stable at", brief(s.limit->stable)},
                   {"unstable at", brief(s.limit->unstable)},
                   {"monotone", yes(s.limit->monotone)},
                   {"steps", std::to_string(steps_at_limit(*s.limit))},
                   {"growth seen", growth_text(steps_at_limit(*s.limit))},
                   {"probes", std::to_string(s.limit->probes.size())}});
  return table;
}

ExpectedTable values(const records::StudyResult& study) {
  ExpectedTable table;
  for (const records::Value& v : study.values)
    table.add("", {{"name", v.name}, {"value", brief(v.value)}, {"meaning", v.meaning}});
  return table;
}

}  // namespace shown

TEST(ReadBackTables, TablesForPeopleHaveEveryNumberUnderItsName) {
  const records::StudyResult study = distinct::everything();
  const WrittenReport report(read_back::input_of(study));
  for (const auto table : {shown::points, shown::orders, shown::extrapolations}) report.expect_html(table(study));
  for (const auto table : {shown::replicates, shown::limits, shown::values}) report.expect_html_and_latex(table(study));
}

/// What it costs to come down to an error between two runs.
double cost(double error, double cheap, double large, double dear, double small) {
  return cheap * std::pow(dear / cheap, std::log(large / error) / std::log(large / small));
}

TEST(ReadBackTables, CheapestSeriesStandsBesideItsCost) {
  const double slow = cost(0.1, 14, 0.23, 170, 0.087), fast = cost(0.1, 11, 0.29, 97, 0.071);
  ExpectedTable cheapest;
  cheapest.add("costs: l2", {{"error", "1e-01"},
                             {"cheapest", "fast"},
                             {"cheapest, s", brief(fast)},
                             {"as cheap within intervals", "–"},
                             {"next", "slow"},
                             {"next, s", brief(slow)},
                             {"times as much", fmt::format("{:.2f}", slow / fast)},
                             {"do not reach it", "0 of 2"}});
  WrittenReport(read_back::input_of(distinct::costs())).expect_html_and_latex(cheapest);
}

}  // namespace mpmvv::reports::read_back_tables_test
