#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "reports/chart.hpp"
#include "reports/original_look.hpp"
#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::reports {

using records::Figure;
using records::Series;
using records::StudyKind;

std::vector<const Series*> figure_series(const records::StudyResult& study, const Figure& figure) {
  std::vector<const Series*> chosen;
  for (const auto& s : study.series)
    if (figure.series.empty()) chosen.push_back(&s);
  for (const auto& name : figure.series) {
    const auto it = std::ranges::find(study.series, name, &Series::name);
    if (it == study.series.end()) {
      std::vector<std::string> known;
      for (const auto& s : study.series) known.push_back(s.name);
      throw support::UsageError(
          fmt::format("figure '{}' of study '{}' names the series '{}', which the study lacks (it has: {})",
                      figure.name, study.name, name, fmt::join(known, ", ")));
    }
    chosen.push_back(&*it);
  }
  return chosen;
}

namespace {

Chart curves_chart(const records::StudyResult& study, const Figure& figure, double letter) {
  Chart chart = error_chart(study, figure, letter);
  give_original_look(chart, figure);
  return chart;
}

Chart chart_of(const records::StudyResult& study, const Figure& figure, double letter) {
  switch (figure.kind) {
    case Figure::Kind::curves:
      return curves_chart(study, figure, letter);
    case Figure::Kind::work_precision:
      return work_chart(study, figure);
    case Figure::Kind::particles:
      return study.kind == StudyKind::check ? particle_chart(study, figure) : particle_error_chart(study, figure);
  }
  return {};
}

/// Says of which trial it is; a caption that goes on, with this or with what is left out, ends with a full stop.
void finish(Chart& chart, const records::StudyResult& study) {
  chart.trial = trial_sentence(study);
  const bool goes_on = !chart.trial.empty() || !chart.omissions.empty();
  if (goes_on && !chart.caption.empty() && std::isalnum(static_cast<unsigned char>(chart.caption.back())) != 0)
    chart.caption += '.';
}

}  // namespace

std::string trial_sentence(const records::StudyResult& study) {
  const std::string trial = store::trial_of(study.text);
  return trial.empty() ? "" : fmt::format("Made with --set: {}.", trial);
}

std::vector<Chart> charts_of(const records::StudyResult& study, double letter) {
  const auto has_value = [&](const Figure& f) {
    return std::ranges::any_of(study.series, [&](const Series& s) {
      return std::ranges::any_of(s.points, [&](const records::Point& p) { return p.y.contains(f.quantity); });
    });
  };
  const bool limits = study.kind == StudyKind::limit;
  bool mapped = false;
  std::vector<Chart> charts;
  for (const auto& figure : study.figures) {
    const bool map = limits && !has_value(figure);
    charts.push_back(map ? stability_map(study, figure) : chart_of(study, figure, letter));
    mapped |= map;
  }
  const bool probed = std::ranges::any_of(study.series, [](const Series& s) { return s.limit.has_value(); });
  if (limits && probed && !mapped) {
    Figure map;
    map.name = study.name + "-map";
    while (std::ranges::find(study.figures, map.name, &Figure::name) != study.figures.end()) map.name += "-map";
    map.caption = study.title + ": stable and unstable runs of the search for the limit.";
    charts.push_back(stability_map(study, map));
  }
  for (Chart& chart : charts) finish(chart, study);
  return charts;
}

}  // namespace mpmvv::reports
