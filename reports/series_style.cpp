#include "reports/series_style.hpp"

#include <algorithm>
#include <set>

namespace mpmvv::reports {

namespace {

bool draws(const records::Figure& figure, const std::string& series) {
  return figure.series.empty() || std::ranges::find(figure.series, series) != figure.series.end();
}

}  // namespace

std::map<std::string, int> series_styles(const records::StudyResult& study) {
  std::map<std::string, int> styles;
  for (const records::Series& series : study.series) {
    std::set<int> taken;
    for (const records::Figure& figure : study.figures)
      for (const auto& [other, style] : styles)
        if (draws(figure, series.name) && draws(figure, other)) taken.insert(style);
    int own = 0;
    while (taken.contains(own)) ++own;
    styles.emplace(series.name, own);
  }
  return styles;
}

}  // namespace mpmvv::reports
