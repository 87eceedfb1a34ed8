#include "studies/claims/trend.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace mpmvv::claims {

namespace {

bool has_trend(const Finding& finding) {
  using enum Finding::Kind;
  return !std::isnan(finding.number) &&
         (finding.kind == order || finding.kind == error || finding.kind == limit || finding.kind == value);
}

}  // namespace

std::vector<Trend> trends_of(const std::vector<std::vector<Finding>>& versions) {
  std::vector<Trend> trends;
  std::map<std::pair<std::string, std::string>, std::size_t> places;
  for (std::size_t v = 0; v < versions.size(); ++v)
    for (const Finding& finding : versions[v]) {
      if (!has_trend(finding)) continue;
      const auto [place, is_new] = places.try_emplace({finding.study, finding.name}, trends.size());
      if (is_new)
        trends.push_back(
            {finding.study, finding.kind, finding.name, std::vector<double>(versions.size(), support::not_measured)});
      trends[place->second].numbers[v] = finding.number;
    }
  std::ranges::stable_sort(trends, {}, &Trend::study);
  return trends;
}

}  // namespace mpmvv::claims
