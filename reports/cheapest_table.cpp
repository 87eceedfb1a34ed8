#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/chart.hpp"
#include "reports/table.hpp"
#include "reports/text.hpp"
#include "studies/claims/samples.hpp"
#include "studies/fits/work_precision.hpp"

namespace mpmvv::reports {

namespace {

/// A series and what it costs to come down to some error.
struct Bid {
  std::string name;
  double cost = 0;
};

/// Series that reach the error, cheapest first.
std::vector<Bid> bids(double error, const records::StudyResult& study, const records::Figure& figure) {
  std::vector<Bid> result;
  for (const records::Series* series : figure_series(study, figure)) {
    const double cost = fits::cost_to_reach(error, fits::pareto_front(claims::work_points(*series, figure.quantity)));
    if (std::isfinite(cost)) result.push_back({series->name, cost});
  }
  std::ranges::stable_sort(result, {}, &Bid::cost);
  return result;
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
              {"error", "cheapest", "cheapest, s", "next", "next, s", "times as much", "do not reach it"},
              {}};
  for (const records::Figure& figure : study.figures) {
    if (figure.kind != records::Figure::Kind::work_precision) continue;
    const std::size_t all = figure_series(study, figure).size();
    Table::Group group{fmt::format("{}: {}", figure.name, figure.quantity), {}};
    for (const double error : error_decades(study, figure)) {
      const auto ranked = bids(error, study, figure);
      if (ranked.empty()) continue;
      const bool rival = ranked.size() > 1;
      group.rows.push_back({fmt::format("{:.0e}", error), ranked[0].name, brief(ranked[0].cost),
                            rival ? ranked[1].name : "–", rival ? brief(ranked[1].cost) : "–",
                            rival ? fmt::format("{:.2f}", ranked[1].cost / ranked[0].cost) : "–",
                            fmt::format("{} of {}", all - ranked.size(), all)});
    }
    if (!group.rows.empty()) table.groups.push_back(std::move(group));
  }
  return table;
}

}  // namespace mpmvv::reports
