#include "goldens/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studies/fits/window.hpp"

namespace mpmvv::goldens {

using records::Point;

Judgement pass(std::string measured) {
  return {Verdict::pass, std::move(measured), ""};
}
Judgement fail(std::string measured, std::string reason) {
  return {Verdict::fail, std::move(measured), std::move(reason)};
}
Judgement fail_as_better(std::string measured, std::string reason) {
  return {Verdict::fail, std::move(measured), std::move(reason), true};
}
Judgement fail(std::string measured, const LostRuns& lost) {
  return {Verdict::fail, std::move(measured), lost.text, false, lost.cause};
}
Judgement inconclusive(std::string measured, std::string reason) {
  return {Verdict::inconclusive, std::move(measured), std::move(reason)};
}
Judgement missing(const std::string& what) {
  return inconclusive("", "missing: " + what);
}

const Point* find_point(const records::Series& series, double at) {
  const auto found = std::ranges::find_if(series.points, [&](const Point& p) { return fits::same_level(p.x, at); });
  return found == series.points.end() ? nullptr : &*found;
}

std::string status_text(const Point& point) {
  return point.reason.empty() ? to_string(point.status) : fmt::format("{}: {}", to_string(point.status), point.reason);
}

std::optional<Judgement> lacking(const records::Series& series, const std::string& norm, double at) {
  const Point* point = find_point(series, at);
  if (!point) return missing(fmt::format("no point of '{}' at {}", series.name, at));
  if (point->status != records::Status::ok) return fail("", lost_runs({point}));
  const auto error = point->y.find(norm);
  if (error == point->y.end()) return missing(fmt::format("no {} of '{}' at {}", norm, series.name, at));
  if (std::isnan(error->second)) return inconclusive("", fmt::format("the error at {} was not measured", at));
  return std::nullopt;
}

}  // namespace mpmvv::goldens
