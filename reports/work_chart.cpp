#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/chart.hpp"
#include "reports/process_time.hpp"
#include "reports/series_style.hpp"
#include "studies/claims/samples.hpp"
#include "studies/fits/work_precision.hpp"

namespace mpmvv::reports {

using fits::WorkPoint;

namespace {

/// The range of the repetitions is drawn where it can be seen.
Dot dot_of_work(const WorkPoint& point) {
  constexpr double least_seen = 0.04;  // of the cost
  Dot dot{point.cost, point.error, point.error, Mark::inside};
  if (point.rounds.costs.empty()) return dot;
  const auto [least, most] = std::ranges::minmax(point.rounds.costs);
  if (most - least > least_seen * point.cost) dot.least_x = least, dot.most_x = most;
  return dot;
}

}  // namespace

Chart work_chart(const records::StudyResult& study, const records::Figure& figure) {
  Chart chart;
  chart.name = figure.name;
  chart.caption = figure.caption;
  std::vector<WorkPoint> all;
  std::vector<std::string> without;
  const auto styles = series_styles(study);
  for (const records::Series* series : figure_series(study, figure)) {
    const auto points = claims::work_points(*series, figure.quantity);
    all.insert(all.end(), points.begin(), points.end());
    Curve curve{series->name, series->name, styles.at(series->name), true, true, true, {}};
    for (const WorkPoint& p : points) curve.dots.push_back(dot_of_work(p));
    chart.curves.push_back(std::move(curve));
    if (points.size() < series->points.size())
      without.push_back(fmt::format("{} of {}", series->points.size() - points.size(), series->name));
  }
  const auto front = fits::pareto_front(all);
  Rule band{Rule::Kind::front, plain_style, "Pareto front", {}};
  for (const WorkPoint& p : front) band.path.push_back({p.cost, p.error});
  if (!band.path.empty()) chart.rules.push_back(std::move(band));

  std::vector<double> costs, errors;
  for (const Curve& curve : chart.curves)
    for (const Dot& dot : curve.dots) {
      costs.push_back(dot.x);
      errors.push_back(dot.value);
      if (has_range(dot)) costs.insert(costs.end(), {dot.least_x, dot.most_x});
    }
  chart.x = make_axis({figure.xlabel, figure.log_x, figure.x_min, figure.x_max, 0.06, 0.06}, costs);
  chart.y = make_axis({figure.ylabel, figure.log_y, figure.y_min, figure.y_max, 0.06, 0.08}, errors);
  chart.notes.emplace_back("Rings: the Pareto front, the runs than which no other is both cheaper and more accurate.");
  if (std::ranges::any_of(chart.curves, has_ranges))
    chart.notes.emplace_back(
        "Bars: from the smallest to the largest of the repeated times; points: their geometric mean.");
  if (const auto note = process_time_note(figure_series(study, figure)); !note.empty()) chart.notes.push_back(note);
  if (!without.empty())
    chart.omissions.push_back(fmt::format("Without a point, as they are unstable, failed or were not measured: {}.",
                                          fmt::join(without, "; ")));
  return chart;
}

}  // namespace mpmvv::reports
