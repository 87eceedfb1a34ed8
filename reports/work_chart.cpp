#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/chart.hpp"
#include "studies/claims/samples.hpp"
#include "studies/fits/work_precision.hpp"

namespace mpmvv::reports {

using fits::WorkPoint;

Chart work_chart(const records::StudyResult& study, const records::Figure& figure) {
  Chart chart;
  chart.name = figure.name;
  chart.caption = figure.caption;
  std::vector<WorkPoint> all;
  std::vector<std::string> without;
  for (const records::Series* series : figure_series(study, figure)) {
    const auto points = claims::work_points(*series, figure.quantity);
    all.insert(all.end(), points.begin(), points.end());
    Curve curve{series->name, series->name, static_cast<int>(chart.curves.size()), true, true, true, {}};
    for (const WorkPoint& p : points) curve.dots.push_back({p.cost, p.error, p.error, Mark::inside});
    chart.curves.push_back(std::move(curve));
    if (points.size() < series->points.size())
      without.push_back(fmt::format("{} of {}", series->points.size() - points.size(), series->name));
  }
  const auto front = fits::pareto_front(all);
  Rule band{Rule::Kind::front, plain_style, "Pareto front", {}};
  for (const WorkPoint& p : front) band.path.push_back({p.cost, p.error});
  if (!band.path.empty()) chart.rules.push_back(std::move(band));

  std::vector<double> costs, errors;
  for (const WorkPoint& p : all) costs.push_back(p.cost), errors.push_back(p.error);
  chart.x = make_axis({figure.xlabel, figure.log_x, figure.x_min, figure.x_max, 0.06, 0.06}, costs);
  chart.y = make_axis({figure.ylabel, figure.log_y, figure.y_min, figure.y_max, 0.06, 0.08}, errors);
  chart.notes.emplace_back("Rings: the Pareto front, the runs than which no other is both cheaper and more accurate.");
  if (!without.empty())
    chart.omissions.push_back(fmt::format("Without a point, unstable or not measured: {}.", fmt::join(without, "; ")));
  return chart;
}

}  // namespace mpmvv::reports
