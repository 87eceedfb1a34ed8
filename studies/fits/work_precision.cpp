#include "studies/fits/work_precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mpmvv::fits {

std::vector<WorkPoint> pareto_front(std::vector<WorkPoint> points) {
  std::sort(points.begin(), points.end(), [](const WorkPoint& a, const WorkPoint& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
  });
  std::vector<WorkPoint> front;
  for (const WorkPoint& point : points)
    if (front.empty() || point.error < front.back().error) front.push_back(point);
  return front;
}

WorkPoint work_to_reach(double error, const std::vector<WorkPoint>& front) {
  const auto next = std::find_if(front.begin(), front.end(), [&](const WorkPoint& p) { return p.error <= error; });
  if (next == front.end()) return {std::numeric_limits<double>::infinity(), error};
  if (next == front.begin()) return {next->cost, error, next->half_range};
  const WorkPoint& above = *std::prev(next);
  const double way = std::log(above.error / error) / std::log(above.error / next->error);
  const double cost = above.cost * std::pow(next->cost / above.cost, way);
  const double of_above = (1 - way) * above.half_range / above.cost, of_next = way * next->half_range / next->cost;
  return {cost, error, cost * std::hypot(of_above, of_next)};
}

std::vector<double> decades(double from, double to) {
  std::vector<double> errors;
  for (double k = std::floor(std::log10(to) + 1e-9); k >= std::log10(from) - 1e-9; --k)
    errors.push_back(std::pow(10, k));
  return errors;
}

}  // namespace mpmvv::fits
