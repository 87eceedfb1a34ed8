#include "studies/claims/samples.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mpmvv::claims {

using fits::ErrorSample;

double step_size(double x, const std::string& sweep) {
  return sweep == "cells" || sweep == "ppc" ? 1 / x : x;
}

double step_size(const records::Point& point, const std::string& sweep) {
  const auto cfl = point.y.find("cfl");
  return step_size(sweep == "cfl" && cfl != point.y.end() ? cfl->second : point.x, sweep);
}

bool has_step_size(const std::string& sweep) {
  constexpr std::array swept{"cells", "ppc", "cfl", "dt"};
  return std::ranges::find(swept, sweep) != swept.end();
}

bool is_finer(double a, double b, const std::string& sweep) {
  if (sweep == "order" || sweep == "wall_depth") return a > b;
  return step_size(a, sweep) < step_size(b, sweep);
}

std::string extrapolated_to(const std::string& sweep) {
  if (sweep == "cells") return "h = 0";
  return (step_size(2, sweep) < 1 ? "1/" : "") + sweep + " = 0";
}

std::string finest_level(const std::string& sweep) {
  if (sweep == "cells") return "finest grid";
  return (is_finer(2, 1, sweep) ? "largest " : "smallest ") + sweep;
}

std::string points_text(const records::Series& series, const fits::ObservedOrder& order) {
  const fits::Window window{order.from, order.to};
  const auto all = std::ranges::count_if(series.points, [&](const auto& point) { return window.holds(point.x); });
  return all > order.points ? fmt::format("{} of {}", order.points, all) : fmt::format("{}", order.points);
}

namespace {

struct Floor {
  const char *number, *made_by;
  double least;  ///< multiple of it that an error must have
};
constexpr std::array floors{Floor{"output_floor", "the error that the rounding of the code's output makes", 3},
                            Floor{"solution_floor", "the error of the solution, which is not exact for the law", 10}};

/// The first floor that the point's error is near to; null without any.
const Floor* floor_near(const records::Point& point, const std::string& norm) {
  constexpr std::array displacement_errors{"l1", "l2", "linf", "l1_all_steps", "l2_all_steps", "linf_all_steps"};
  const auto error = point.y.find(norm);
  if (std::ranges::find(displacement_errors, norm) == displacement_errors.end() || error == point.y.end())
    return nullptr;
  const auto is_near = [&](const Floor& floor) {
    const auto value = point.y.find(floor.number);
    return value != point.y.end() && error->second < floor.least * value->second;
  };
  const auto found = std::ranges::find_if(floors, is_near);
  return found == floors.end() ? nullptr : &*found;
}

}  // namespace

bool is_near_floor(const records::Point& point, const std::string& norm) {
  return floor_near(point, norm) != nullptr;
}

std::string left_out(const records::Series& series, const std::string& norm, const fits::Window& window) {
  std::vector<std::string> all;
  for (const Floor& floor : floors) {
    std::vector<double> values;
    for (const records::Point& point : series.points)
      if (window.holds(point.x) && floor_near(point, norm) == &floor) values.push_back(point.x);
    if (!values.empty())
      all.push_back(fmt::format("{} (within {} times {})", fmt::join(values, ", "), floor.least, floor.made_by));
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

std::vector<ErrorSample> samples_of(const records::Series& series, const std::string& norm, const std::string& sweep) {
  std::vector<ErrorSample> samples;
  for (const records::Point& point : series.points) {
    const auto y = point.y.find(norm);
    const bool counts = y != point.y.end() && point.status == records::Status::ok && !is_near_floor(point, norm);
    samples.push_back({point.x, step_size(point, sweep), counts ? y->second : support::not_measured});
  }
  return samples;
}

std::vector<ErrorSample> replicate_samples_of(const records::Series& series, const std::string& norm,
                                              const std::string& sweep) {
  std::vector<ErrorSample> samples;
  for (const records::Point& point : series.points)
    if (const auto all = point.replicates.find(norm); all != point.replicates.end() && !is_near_floor(point, norm))
      for (const double e : all->second) samples.push_back({point.x, step_size(point, sweep), e});
  return samples;
}

namespace {

/// What all steps cost in each round, if `cost` is their mean.
fits::Rounds rounds_of(const records::Point& point, double cost) {
  fits::Rounds rounds = point.rounds;
  const double mean = fits::geometric_mean(rounds.costs);
  for (double& one : rounds.costs) one *= cost / mean;
  return rounds;
}

}  // namespace

std::vector<fits::WorkPoint> work_points(const records::Series& series, const std::string& norm) {
  std::vector<fits::WorkPoint> points;
  for (const records::Point& point : series.points) {
    const auto cost = point.y.find("step_seconds"), error = point.y.find(norm);
    if (point.status == records::Status::ok && cost != point.y.end() && error != point.y.end() && cost->second > 0 &&
        error->second > 0 && std::isfinite(error->second))
      points.push_back(
          {cost->second, error->second, cost->second * half_spread(point), rounds_of(point, cost->second)});
  }
  return points;
}

double half_spread(const records::Point& point) {
  const auto spread = point.y.find("step_seconds_spread");
  return spread == point.y.end() ? 0 : spread->second / 2;
}

}  // namespace mpmvv::claims
