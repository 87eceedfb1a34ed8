#include "goldens/lost_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "studies/fits/window.hpp"

namespace mpmvv::goldens {

using records::Point;
using records::Status;

namespace {

/// "the run at 8 failed", "the runs at 8, 16 and 32 failed"; empty where no point has that status.
std::string with_status(const std::vector<const Point*>& points, Status status) {
  std::vector<std::string> levels;
  for (const Point* point : points)
    if (point->status == status) levels.push_back(fmt::format("{:g}", point->x));
  if (levels.empty()) return "";
  const bool is_one = levels.size() == 1;
  std::string all = levels.back();
  if (levels.pop_back(); !levels.empty()) all = fmt::format("{} and {}", fmt::join(levels, ", "), all);
  const char* what = status == Status::failed ? "failed" : is_one ? "is unstable" : "are unstable";
  return fmt::format("the {} at {} {}", is_one ? "run" : "runs", all, what);
}

}  // namespace

LostRuns lost_runs(const std::vector<const Point*>& points, double level) {
  std::vector<const Point*> lost;
  std::ranges::copy_if(points, std::back_inserter(lost), [](const Point* p) { return p->status != Status::ok; });
  if (lost.empty()) return {};
  const auto named = std::ranges::find_if(lost, [level](const Point* p) { return fits::same_level(p->x, level); });
  const Point& telling = named == lost.end() ? *lost.back() : **named;
  std::vector<std::string> parts;
  for (const Status status : {Status::unstable, Status::failed})
    if (std::string part = with_status(lost, status); !part.empty()) parts.push_back(std::move(part));
  std::string text = fmt::format("{}", fmt::join(parts, ", "));
  if (telling.reason.empty()) return {text, ""};
  text += lost.size() == 1 ? ": " : fmt::format("; at {:g}: ", telling.x);
  return {text + telling.reason, telling.reason};
}

}  // namespace mpmvv::goldens
