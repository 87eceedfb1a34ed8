#include "reports/figure_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "reports/text.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::reports {

using records::StudyResult;

namespace {

bool has_claim(const StudyResult& study, const std::string& id) {
  return std::ranges::find(study.claims, id) != study.claims.end();
}

template <class Belongs>
std::vector<Chart> charts_where(const std::vector<StudyResult>& studies, const Belongs& belongs) {
  std::vector<Chart> charts;
  for (const StudyResult& study : studies)
    if (belongs(study)) std::ranges::move(charts_of(study, paper_letter), std::back_inserter(charts));
  return charts;
}

/// Whether the figure is one of the study's own or, by its name, a map that is added to them.
bool may_have(const StudyResult& study, const std::string& figure) {
  return figure.starts_with(study.name + "-map") ||
         std::ranges::find(study.figures, figure, &records::Figure::name) != study.figures.end();
}

/// "s-fig9a" of "s-fig9".
bool is_panel(const std::string& figure, const std::string& name) {
  return figure.size() == name.size() + 1 && figure.starts_with(name) &&
         std::isalpha(static_cast<unsigned char>(figure.back())) != 0;
}

/// The figure of the claim's own name, or its panels, and the rest.
FigureChoice choose_of_claim(std::vector<Chart> charts, const std::string& id) {
  const std::string name = lower_case(id);
  const auto same = [&](const Chart& c) { return c.name == name; };
  const auto panel = [&](const Chart& c) { return is_panel(c.name, name); };
  const bool has_same = std::ranges::any_of(charts, same);
  if (!has_same && std::ranges::none_of(charts, panel)) return {std::move(charts), {}};
  FigureChoice choice;
  for (Chart& chart : charts)
    if (has_same ? same(chart) : panel(chart))
      choice.chosen.push_back(std::move(chart));
    else
      choice.others.push_back(chart.name);
  return choice;
}

[[noreturn]] void fail_without_figure(const std::string& what, const std::string& name) {
  throw support::UsageError(
      fmt::format("{} '{}' has no figure in the store (a [[figure]] in its study file draws one)", what, name));
}

[[noreturn]] void fail_unknown_figure(const std::vector<StudyResult>& studies, const std::string& name) {
  std::set<std::string> figures, claims;
  for (const StudyResult& study : studies) {
    const auto charts = charts_of(study, paper_letter);
    for (const Chart& chart : charts) figures.insert(chart.name);
    if (!charts.empty()) claims.insert(study.claims.begin(), study.claims.end());
  }
  if (figures.empty())
    throw support::UsageError(
        fmt::format("no figure '{}': no study in the store draws one (a [[figure]] in its study file)", name));
  std::vector<std::string> known(figures.begin(), figures.end());
  known.insert(known.end(), claims.begin(), claims.end());
  throw support::UsageError(fmt::format("unknown figure '{}' (known: {})", name, fmt::join(known, ", ")));
}

}  // namespace

FigureChoice choose_figures(const std::vector<StudyResult>& studies, const std::string& name) {
  FigureChoice named{charts_where(studies, [&](const StudyResult& s) { return may_have(s, name); }), {}};
  std::erase_if(named.chosen, [&](const Chart& c) { return c.name != name; });
  if (!named.chosen.empty()) return named;
  auto of_claim = charts_where(studies, [&](const StudyResult& s) { return has_claim(s, name); });
  if (!of_claim.empty()) return choose_of_claim(std::move(of_claim), name);
  auto of_study = charts_where(studies, [&](const StudyResult& s) { return s.name == name; });
  if (!of_study.empty()) return {std::move(of_study), {}};
  for (const StudyResult& study : studies) {
    if (study.name == name) fail_without_figure("study", name);
    if (has_claim(study, name)) fail_without_figure("claim", name);
  }
  fail_unknown_figure(studies, name);
}

}  // namespace mpmvv::reports
