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

double cost_to_reach(double error, const std::vector<WorkPoint>& front) {
  const auto next = std::find_if(front.begin(), front.end(), [&](const WorkPoint& p) { return p.error <= error; });
  if (next == front.end()) return std::numeric_limits<double>::infinity();
  if (next == front.begin()) return next->cost;
  const WorkPoint& above = *std::prev(next);
  const double way = std::log(above.error / error) / std::log(above.error / next->error);
  return above.cost * std::pow(next->cost / above.cost, way);
}

std::vector<double> decades(double from, double to) {
  std::vector<double> errors;
  for (double k = std::floor(std::log10(to) + 1e-9); k >= std::log10(from) - 1e-9; --k)
    errors.push_back(std::pow(10, k));
  return errors;
}

}  // namespace mpmvv::fits
