#include "cli/run_reasons.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

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
  std::string series, gist;
  std::string first;                     ///< what the first one said
  std::vector<std::string> values = {};  ///< of the swept key
  std::vector<std::string> errors = {};  ///< beyond their bound, of the same runs; empty where this is not the reason
};

/// The reason without what the code printed last, which may be of its own run.
std::string without_log(const std::string& reason) {
  return reason.substr(0, reason.find("; the code ended without an error: "));
}

/// A run's reason and behind it, where a failed run has left its folder, that.
std::pair<std::string, std::string> with_folder(const std::string& reason) {
  const std::string mark = "; its folder: ";
  const auto at = std::min(reason.rfind(mark), reason.size());
  return {reason.substr(0, at), at == reason.size() ? "" : reason.substr(at + mark.size())};
}

constexpr std::string_view error_mark = "displacement error ";

/// The error that the reason begins with; empty where it is another one.
std::string error_in(const std::string& reason) {
  if (!reason.starts_with(error_mark)) return "";
  return reason.substr(error_mark.size(), reason.find(' ', error_mark.size()) - error_mark.size());
}

/// The reason without what is each run's own, its error and its folder.
std::string gist_of(const std::string& reason) {
  const std::string error = error_in(reason), text = with_folder(reason).first;
  return error.empty() ? without_log(text) : text.substr(error_mark.size() + error.size());
}

/// What one run said as it is; of several the gist, with their errors or the folder of the first one.
std::string text_of(const Reason& reason) {
  if (reason.values.size() == 1) return reason.first;
  if (!reason.errors.empty())
    return fmt::format("displacement errors {}{}", fmt::join(reason.errors, ", "), reason.gist);
  const std::string folder = with_folder(reason.first).second;
  return reason.gist + (folder.empty() ? "" : "; folder of the first one: " + folder);
}

std::vector<Reason> reasons_of(Status status, const Series& series) {
  std::vector<Reason> reasons;
  for (const Point& point : series.points) {
    if (point.status != status) continue;
    const std::string gist = gist_of(point.reason);
    auto reason = std::ranges::find(reasons, gist, &Reason::gist);
    if (reason == reasons.end()) reason = reasons.insert(reason, {series.name, gist, point.reason});
    reason->values.push_back(fmt::format("{:.6g}", point.x));
    if (const std::string error = error_in(point.reason); !error.empty()) reason->errors.push_back(error);
  }
  return reasons;
}

void print_table(Status status, const std::vector<Reason>& reasons, const std::string& sweep) {
  Table table({{to_string(status)}, {sweep}, {"why", Table::Kind::prose}});
  for (const Reason& reason : reasons)
    table.add({reason.series, fmt::format("{}", fmt::join(reason.values, ", ")), text_of(reason)});
  table.print_apart();
}

/// A code that goes on to its end is found unstable by its error alone.
bool may_have_ended(const Reason& reason) {
  return !reason.errors.empty();
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
