#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <string>
#include <vector>

#include "studies/claims/criterion.hpp"
#include "studies/fits/window.hpp"

/// What criteria read at the points of a window, and how they name it.
namespace mpmvv::claims {

/// The norm at a point; an unstable point counts as an infinite error.
inline double error_at(const records::Point& point, const std::string& norm) {
  if (point.status == records::Status::unstable) return std::numeric_limits<double>::infinity();
  const auto y = point.y.find(norm);
  return y == point.y.end() ? support::not_measured : y->second;
}

inline double error_at(const records::Series& series, double x, const std::string& norm) {
  for (const records::Point& point : series.points)
    if (fits::same_level(point.x, x)) return error_at(point, norm);
  return support::not_measured;
}

/// "over cells 16 to 128", "over cells 16".
inline std::string over_window(const Criterion& c, const records::StudyResult& result) {
  const std::string from = fmt::format("over {} {}", result.sweep, c.window.from);
  return c.window.from == c.window.to ? from : fmt::format("{} to {}", from, c.window.to);
}

/// "at cells = 16".
inline std::string at_point(const records::StudyResult& result, double x) {
  return fmt::format("at {} = {}", result.sweep, x);
}

/// The swept values in the window whose points have this status.
inline std::vector<double> values_with(records::Status status, const fits::Window& window,
                                       const records::Series& series) {
  std::vector<double> values;
  for (const records::Point& point : series.points)
    if (window.holds(point.x) && point.status == status) values.push_back(point.x);
  return values;
}

/// "'linear' failed at cells = 16, 32"; empty where no run in the window failed.
inline std::string failures_of(const records::Series& series, const fits::Window& window,
                               const records::StudyResult& result) {
  const std::vector<double> failed = values_with(records::Status::failed, window, series);
  if (failed.empty()) return "";
  return fmt::format("'{}' failed at {} = {}", series.name, result.sweep, fmt::join(failed, ", "));
}

}  // namespace mpmvv::claims
