#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reports/chart.hpp"
#include "reports/process_time.hpp"
#include "reports/table.hpp"
#include "reports/text.hpp"
#include "studies/claims/samples.hpp"
#include "studies/fits/work_precision.hpp"

namespace mpmvv::reports {

namespace {

/// A series and what it costs to come down to some error.
struct Bid {
  std::string name;
  fits::WorkPoint work;
};

/// Series that reach the error, cheapest first.
std::vector<Bid> bids(double error, const records::StudyResult& study, const records::Figure& figure) {
  std::vector<Bid> result;
  for (const records::Series* series : figure_series(study, figure)) {
    const auto work = fits::work_to_reach(error, fits::pareto_front(claims::work_points(*series, figure.quantity)));
    if (std::isfinite(work.cost)) result.push_back({series->name, work});
  }
  std::ranges::stable_sort(result, {}, [](const Bid& bid) { return bid.work.cost; });
  return result;
}

/// Whether the interval of their ratio reaches down to 1.
bool may_be_as_cheap(const Bid& bid, const Bid& cheapest) {
  return fits::quotient(bid.work, cheapest.work).lower <= 1;
}

/// The names of those that may be as cheap as the first; a dash without any.
std::string rivals(const std::vector<Bid>& ranked) {
  std::vector<std::string> names;
  for (std::size_t k = 1; k < ranked.size(); ++k)
    if (may_be_as_cheap(ranked[k], ranked[0])) names.push_back(ranked[k].name);
  return names.empty() ? "–" : fmt::format("{}", fmt::join(names, ", "));
}

std::vector<std::string> row_of(double error, const std::vector<Bid>& ranked, std::size_t all) {
  const Bid& cheapest = ranked[0];
  const auto next = std::ranges::find_if(ranked.begin() + 1, ranked.end(),
                                         [&](const Bid& b) { return !may_be_as_cheap(b, cheapest); });
  std::vector<std::string> row{fmt::format("{:.0e}", error), cheapest.name, brief(cheapest.work.cost), rivals(ranked)};
  if (next == ranked.end())
    row.insert(row.end(), 3, "–");
  else
    row.insert(row.end(),
               {next->name, brief(next->work.cost), fmt::format("{:.2f}", next->work.cost / cheapest.work.cost)});
  row.push_back(fmt::format("{} of {}", all - ranked.size(), all));
  return row;
}

/// The powers of ten among a figure's errors.
std::vector<double> error_decades(const records::StudyResult& study, const records::Figure& figure) {
  double least = INFINITY, largest = 0;
  for (const records::Series* series : figure_series(study, figure))
    for (const fits::WorkPoint& p : claims::work_points(*series, figure.quantity))
      least = std::min(least, p.error), largest = std::max(largest, p.error);
  return largest > 0 ? fits::decades(least, largest) : std::vector<double>{};
}

}  // namespace

Table cheapest_table(const records::StudyResult& study) {
  Table table{"Cheapest series for a given error (step seconds on one core, power laws between measured runs)",
              {"error", "cheapest", "cheapest, s", "as cheap within intervals", "next", "next, s", "times as much",
               "do not reach it"},
              {}};
  std::vector<const records::Series*> shown;
  for (const records::Figure& figure : study.figures) {
    if (figure.kind != records::Figure::Kind::work_precision) continue;
    const auto drawn = figure_series(study, figure);
    for (const records::Series* series : drawn)
      if (std::ranges::find(shown, series) == shown.end()) shown.push_back(series);
    Table::Group group{fmt::format("{}: {}", figure.name, figure.quantity), {}};
    for (const double error : error_decades(study, figure)) {
      const auto ranked = bids(error, study, figure);
      if (!ranked.empty()) group.rows.push_back(row_of(error, ranked, drawn.size()));
    }
    if (!group.rows.empty()) table.groups.push_back(std::move(group));
  }
  table.note = process_time_note(shown);
  return table;
}

}  // namespace mpmvv::reports
