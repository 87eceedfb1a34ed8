#include "cli/run_reasons.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/lines.hpp"
#include "cli/table.hpp"

namespace mpmvv::cli {

using records::Point;
using records::Series;
using records::Status;
using records::StudyResult;

namespace {

/// Runs of a series that ended for the same reason.
struct Reason {
  std::string series, why;
  std::vector<std::string> values = {};  ///< of the swept key
};

std::vector<Reason> reasons_of(Status status, const Series& series) {
  std::vector<Reason> reasons;
  for (const Point& point : series.points) {
    if (point.status != status) continue;
    auto reason = std::ranges::find(reasons, point.reason, &Reason::why);
    if (reason == reasons.end()) reason = reasons.insert(reason, {series.name, point.reason});
    reason->values.push_back(fmt::format("{:.6g}", point.x));
  }
  return reasons;
}

void print_table(Status status, const std::vector<Reason>& reasons, const std::string& sweep) {
  Table table({{to_string(status)}, {sweep}, {"why", Table::Kind::prose}});
  for (const Reason& reason : reasons)
    table.add({reason.series, fmt::format("{}", fmt::join(reason.values, ", ")), reason.why});
  table.print_apart();
}

/// A code that goes on to its end is found unstable by its error alone.
bool may_have_ended(const Reason& reason) {
  return reason.why.starts_with("displacement error ");
}

}  // namespace

void print_run_reasons(const StudyResult& study, bool verbose) {
  std::vector<Reason> failed, unstable;
  bool has_ended = false;
  for (const Series& series : study.series) {
    std::ranges::move(reasons_of(Status::failed, series), std::back_inserter(failed));
    if (!verbose && !is_of_another_code(series)) continue;
    const std::vector<Reason> reasons = reasons_of(Status::unstable, series);
    has_ended = has_ended || (is_of_another_code(series) && std::ranges::any_of(reasons, may_have_ended));
    unstable.insert(unstable.end(), reasons.begin(), reasons.end());
  }
  print_table(Status::failed, failed, study.sweep);
  print_table(Status::unstable, unstable, study.sweep);
  if (has_ended)
    print_indented(
        "another code's run with a displacement error beyond that may have come to its end: then a wrong force is more "
        "likely than too long a time step, and blowup_error = 10 measures the error");
}

}  // namespace mpmvv::cli
