#include "reports/series_style.hpp"

#include <algorithm>
#include <set>

#include "reports/papers.hpp"

namespace mpmvv::reports {

namespace {

bool draws(const records::Figure& figure, const std::string& series) {
  return figure.series.empty() || std::ranges::find(figure.series, series) != figure.series.end();
}

/// The styles of the series that have the same ones in all studies of a paper.
std::map<std::string, int> styles_of_paper(const records::StudyResult& study) {
  std::map<std::string, int> styles;
  for (const Paper& paper : papers())
    if (paper.has(study.name))
      for (const std::string& name : paper.series) styles.emplace(name, static_cast<int>(styles.size()));
  std::erase_if(styles, [&](const auto& style) {
    return std::ranges::find(study.series, style.first, &records::Series::name) == study.series.end();
  });
  return styles;
}

}  // namespace

std::map<std::string, int> series_styles(const records::StudyResult& study) {
  std::map<std::string, int> styles = styles_of_paper(study);
  for (const records::Series& series : study.series) {
    if (styles.contains(series.name)) continue;
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
