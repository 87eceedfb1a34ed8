#include "studies/claims/trend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "studies/fits/window.hpp"

namespace mpmvv::claims {

namespace {

bool has_trend(const Finding& finding) {
  using enum Finding::Kind;
  if (finding.kind == limit) return true;  // also where none was found, which is a result
  return !std::isnan(finding.number) && (finding.kind == order || finding.kind == error || finding.kind == value);
}

/// The findings of one version, by study and name; statuses by study and series.
class VersionFindings {
 public:
  explicit VersionFindings(const std::vector<Finding>& findings) {
    for (const Finding& finding : findings)
      if (finding.kind == Finding::Kind::status)
        statuses_[{finding.study, finding.series}].push_back(&finding);
      else
        named_.try_emplace({finding.study, finding.name}, &finding);
  }

  const Finding* find(const Trend& trend) const {
    const auto found = named_.find({trend.study, trend.name});
    return found == named_.end() ? nullptr : found->second;
  }

  /// The status of the first run in the window that is not ok; empty where all are.
  std::string trouble_in(const std::string& study, const std::string& series, const fits::Window& window) const {
    const auto runs = statuses_.find({study, series});
    if (runs == statuses_.end()) return "";
    for (const Finding* run : runs->second)
      if (window.holds(run->at) && run->word != to_string(records::Status::ok)) return run->word;
    return "";
  }

 private:
  using Key = std::pair<std::string, std::string>;
  std::map<Key, const Finding*> named_;
  std::map<Key, std::vector<const Finding*>> statuses_;
};

double number_of(const Finding& finding, double at) {
  if (std::isnan(at)) return finding.number;
  for (const Finding::Level& level : finding.levels)
    if (fits::same_level(level.x, at)) return level.y;
  return not_measured;
}

/// What a search found instead of a limit; empty where it found one.
std::string without_limit(const Finding& limit) {
  if (limit.word.empty()) return "";
  return limit.side > 0 ? "all stable" : limit.side < 0 ? "all unstable" : "not found";
}

void add_version(Trend& trend, const std::string& series, const fits::Window& window, const VersionFindings& version) {
  const Finding* finding = version.find(trend);
  trend.numbers.push_back(finding ? number_of(*finding, trend.at) : not_measured);
  trend.remarks.push_back(version.trouble_in(trend.study, series, window));
  if (finding && finding->kind == Finding::Kind::limit) trend.remarks.back() = without_limit(*finding);
}

}  // namespace

std::string label(const Trend& trend) {
  return std::isnan(trend.at) ? trend.name : fmt::format("{} at {:g}", trend.name, trend.at);
}

std::string label_with_unit(const Trend& trend) {
  Trend with_unit = trend;
  if (const std::string unit = records::unit_of(trend.quantity); !unit.empty())
    with_unit.name += fmt::format(" ({})", unit);
  return label(with_unit);
}

std::vector<Trend> trends_of(const std::vector<std::vector<Finding>>& versions) {
  const std::vector<VersionFindings> found(versions.begin(), versions.end());
  std::vector<Trend> trends;
  std::set<std::tuple<std::string, std::string>> known;
  for (const std::vector<Finding>& version : versions)
    for (const Finding& finding : version) {
      if (!has_trend(finding)) continue;
      Trend trend{finding.study, finding.kind, finding.name, {}, finding.at, {}, finding.quantity};
      if (!known.emplace(finding.study, label(trend)).second) continue;
      const bool is_error = finding.kind == Finding::Kind::error;
      const fits::Window window = is_error ? fits::Window{finding.at, finding.at} : finding.window;
      for (const VersionFindings& one : found) add_version(trend, finding.series, window, one);
      trends.push_back(std::move(trend));
    }
  std::ranges::stable_sort(trends, {}, &Trend::study);
  return trends;
}

}  // namespace mpmvv::claims
