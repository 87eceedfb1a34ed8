#include "studies/claims/samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mpmvv::claims {

using fits::ErrorSample;

double step_size(double x, const std::string& sweep) {
  return sweep == "cells" ? 1 / x : x;
}

bool is_near_floor(const records::Point& point, const std::string& norm) {
  constexpr std::array displacement_errors{"l1", "l2", "linf"};
  if (std::find(displacement_errors.begin(), displacement_errors.end(), norm) == displacement_errors.end())
    return false;
  const auto floor = point.y.find("output_floor"), error = point.y.find(norm);
  return floor != point.y.end() && error != point.y.end() && error->second < least_over_floor * floor->second;
}

std::vector<double> left_out(const records::Series& series, const std::string& norm) {
  std::vector<double> values;
  for (const records::Point& point : series.points)
    if (is_near_floor(point, norm)) values.push_back(point.x);
  return values;
}

std::vector<ErrorSample> samples_of(const records::Series& series, const std::string& norm, const std::string& sweep) {
  std::vector<ErrorSample> samples;
  for (const records::Point& point : series.points)
    if (const auto y = point.y.find(norm);
        y != point.y.end() && point.status == records::Status::ok && !is_near_floor(point, norm))
      samples.push_back({point.x, step_size(point.x, sweep), y->second});
  return samples;
}

std::vector<ErrorSample> replicate_samples_of(const records::Series& series, const std::string& norm,
                                              const std::string& sweep) {
  std::vector<ErrorSample> samples;
  for (const records::Point& point : series.points)
    if (const auto all = point.replicates.find(norm); all != point.replicates.end())
      for (const double e : all->second) samples.push_back({point.x, step_size(point.x, sweep), e});
  return samples;
}

std::vector<fits::WorkPoint> work_points(const records::Series& series, const std::string& norm) {
  std::vector<fits::WorkPoint> points;
  for (const records::Point& point : series.points) {
    const auto cost = point.y.find("step_seconds"), error = point.y.find(norm);
    if (point.status == records::Status::ok && cost != point.y.end() && error != point.y.end() && cost->second > 0 &&
        error->second > 0 && std::isfinite(error->second))
      points.push_back({cost->second, error->second});
  }
  return points;
}

}  // namespace mpmvv::claims
