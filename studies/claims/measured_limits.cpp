#include "studies/claims/measured_limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace mpmvv::claims {

using fits::LimitRange;
using fits::StabilityLimit;
using records::Series;

namespace {

std::string remarks_on(const StabilityLimit& limit) {
  std::vector<std::string> remarks;
  if (!limit.monotone) remarks.emplace_back("not monotone");
  if (const std::string few = too_few_steps(limit); !few.empty()) remarks.push_back(few);
  return fmt::format("{}", fmt::join(remarks, ", "));
}

/// Where the limit of a series may lie; none where nothing is known, and `out.missing` says why.
std::optional<LimitRange> range_of_limit(const Series& series, Measured& out) {
  const auto range = series.limit ? sure_range_of(*series.limit) : std::nullopt;
  if (range) return range;
  out.missing = fmt::format("'{}' has no limit{}", series.name,
                            series.limit ? ": " + text_without_limit(*series.limit) : " in the range searched");
  if (series.limit)
    if (const std::string remark = too_few_steps(*series.limit); !remark.empty()) out.missing += ", " + remark;
  return range;
}

/// Adds a number of which one end alone is known.
void add_open(const std::string& label, double lower, double upper, const std::string& remark, Measured& out) {
  const double end = lower == 0 ? upper : lower;
  out.add(label, end, Interval{lower, upper}, remark);
}

/// "that of 'b' not monotone"; empty where there is nothing to remark. Without "; ", as every remark (records::Found).
std::string remarks_on_both(const Series& series, const Series& over) {
  const std::string of_series = remarks_on(*series.limit), of_over = remarks_on(*over.limit);
  if (of_series == of_over && !of_over.empty())
    return fmt::format("that of '{}' and '{}' {}", series.name, over.name, of_over);
  std::vector<std::string> remarks;
  if (!of_series.empty()) remarks.push_back(fmt::format("that of '{}' {}", series.name, of_series));
  if (!of_over.empty()) remarks.push_back(fmt::format("that of '{}' {}", over.name, of_over));
  return fmt::format("{}", fmt::join(remarks, ", and "));
}

}  // namespace

void measure_limit(const Series& series, Measured& out) {
  const auto range = range_of_limit(series, out);
  if (!range) return;
  const StabilityLimit& limit = *series.limit;
  const std::string label = fmt::format("{} limit of '{}'", limit.key, series.name);
  const std::string remark = remarks_on(limit);
  if (!limit.found)
    add_open(fmt::format("{}, {}", label, text_without_limit(limit)), range->lower, range->upper, remark, out);
  else
    out.add(fmt::format("{} between {:.4g} and {:.4g}", label, limit.stable, limit.unstable), limit.value(),
            Interval{range->lower, range->upper}, remark);
}

void measure_limit_ratio(const Series& series, const Series& over, Measured& out) {
  const auto a = range_of_limit(series, out), b = range_of_limit(over, out);
  if (!a || !b) return;
  const Interval ratio{a->lower / b->upper, a->upper / b->lower};
  const std::string label = fmt::format("limit of '{}' over '{}'", series.name, over.name);
  const std::string remark = remarks_on_both(series, over);
  if (ratio.lower == 0 && std::isinf(ratio.upper))
    out.missing = fmt::format("nothing is known of the {}", label);
  else if (a->is_open() || b->is_open())
    add_open(label, ratio.lower, ratio.upper, remark, out);
  else
    out.add(fmt::format("{} between {:.4g} and {:.4g}", label, ratio.lower, ratio.upper),
            series.limit->value() / over.limit->value(), ratio, remark);
}

}  // namespace mpmvv::claims
