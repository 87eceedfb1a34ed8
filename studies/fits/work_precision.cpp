#include "studies/fits/work_precision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mpmvv::fits {

namespace {

/// The rounds of the cost that lies so much of the way, in logarithms, from one cost to the next; none unless the two
/// are paired.
Rounds rounds_between(const Rounds& one, const Rounds& next, double way) {
  if (!are_paired(std::array{one, next})) return {};
  Rounds between = one;
  for (std::size_t k = 0; k < between.costs.size(); ++k)
    between.costs[k] *= std::pow(next.costs[k] / one.costs[k], way);
  return between;
}

}  // namespace

Estimate quotient(const Ranged& number, const Ranged& over) {
  constexpr double anywhere = std::numeric_limits<double>::infinity();
  const double value = number.value / over.value;
  if (!(std::abs(over.value) > over.half_range)) return {value, -anywhere, anywhere};
  if (over.half_range == 0 && number.half_range == 0) return {value, value, value};
  const double low = number.value - number.half_range, high = number.value + number.half_range;
  const double least = over.value - over.half_range, most = over.value + over.half_range;
  const auto [lower, upper] = std::minmax({low / least, low / most, high / least, high / most});
  return {value, lower, upper};
}

Estimate quotient(const WorkPoint& cost, const WorkPoint& over) {
  const std::array rounds{cost.rounds, over.rounds};
  if (are_paired(rounds)) return over_rounds(rounds, [](std::span<const double> costs) { return costs[0] / costs[1]; });
  return quotient(Ranged{cost.cost, cost.half_range}, Ranged{over.cost, over.half_range});
}

std::vector<WorkPoint> pareto_front(std::vector<WorkPoint> points) {
  constexpr double rounding = 1e-9;  // of an error
  std::sort(points.begin(), points.end(), [](const WorkPoint& a, const WorkPoint& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
  });
  std::vector<WorkPoint> front;
  for (const WorkPoint& point : points)
    if (front.empty() || point.error < (1 - rounding) * front.back().error) front.push_back(point);
  return front;
}

WorkPoint work_to_reach(double error, const std::vector<WorkPoint>& front) {
  const auto next = std::find_if(front.begin(), front.end(), [&](const WorkPoint& p) { return p.error <= error; });
  if (next == front.end()) return {std::numeric_limits<double>::infinity(), error};
  if (next == front.begin()) return {next->cost, error, next->half_range, next->rounds};
  const WorkPoint& above = *std::prev(next);
  const double way = std::log(above.error / error) / std::log(above.error / next->error);
  const double cost = above.cost * std::pow(next->cost / above.cost, way);
  const double of_above = (1 - way) * above.half_range / above.cost, of_next = way * next->half_range / next->cost;
  return {cost, error, cost * std::hypot(of_above, of_next), rounds_between(above.rounds, next->rounds, way)};
}

std::vector<double> decades(double from, double to) {
  std::vector<double> errors;
  for (double k = std::floor(std::log10(to) + 1e-9); k >= std::log10(from) - 1e-9; --k)
    errors.push_back(std::pow(10, k));
  return errors;
}

}  // namespace mpmvv::fits
