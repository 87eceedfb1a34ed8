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

/// A list of figures for each of the studies.
using ChartsByStudy = std::vector<std::vector<Chart>>;

/// The name of a figure in its own study: "errors" of "bar~errors".
std::string own_name(const Chart& chart) {
  return chart.name.substr(chart.name.find('~') + 1);
}

template <class Belongs>
std::vector<Chart> charts_where(const std::vector<StudyResult>& studies, const ChartsByStudy& charts,
                                const Belongs& belongs) {
  std::vector<Chart> chosen;
  for (std::size_t i = 0; i < studies.size(); ++i)
    std::ranges::copy_if(charts[i], std::back_inserter(chosen),
                         [&](const Chart& chart) { return belongs(studies[i], chart); });
  return chosen;
}

/// "s-fig9a" of "s-fig9".
bool is_panel(const std::string& figure, const std::string& name) {
  return figure.size() == name.size() + 1 && figure.starts_with(name) &&
         std::isalpha(static_cast<unsigned char>(figure.back())) != 0;
}

/// The figure of the claim's own name, or its panels, and the rest.
FigureChoice choose_of_claim(std::vector<Chart> charts, const std::string& id) {
  const std::string name = lower_case(id);
  const auto same = [&](const Chart& c) { return own_name(c) == name; };
  const auto panel = [&](const Chart& c) { return is_panel(own_name(c), name); };
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

[[noreturn]] void fail_unknown_figure(const std::vector<StudyResult>& studies, const ChartsByStudy& charts,
                                      const std::string& name) {
  std::set<std::string> figures, claims;
  for (std::size_t i = 0; i < studies.size(); ++i) {
    for (const Chart& chart : charts[i]) figures.insert(chart.name);
    if (!charts[i].empty()) claims.insert(studies[i].claims.begin(), studies[i].claims.end());
  }
  if (figures.empty())
    throw support::UsageError(
        fmt::format("no figure '{}': no study in the store draws one (a [[figure]] in its study file)", name));
  std::vector<std::string> known(figures.begin(), figures.end());
  known.insert(known.end(), claims.begin(), claims.end());
  throw support::UsageError(fmt::format("unknown figure '{}' (known: {})", name, fmt::join(known, ", ")));
}

}  // namespace

FigureChoice choose_figures(const std::vector<StudyResult>& studies, const std::string& name, double letter) {
  const ChartsByStudy charts = charts_of_all(studies, letter);
  auto named = charts_where(studies, charts, [&](const StudyResult&, const Chart& chart) {
    return chart.name == name || own_name(chart) == name;
  });
  if (!named.empty()) return {std::move(named), {}};
  auto of_claim = charts_where(studies, charts, [&](const StudyResult& s, const Chart&) { return has_claim(s, name); });
  if (!of_claim.empty()) return choose_of_claim(std::move(of_claim), name);
  auto of_study = charts_where(studies, charts, [&](const StudyResult& s, const Chart&) { return s.name == name; });
  if (!of_study.empty()) return {std::move(of_study), {}};
  for (const StudyResult& study : studies) {
    if (study.name == name) fail_without_figure("study", name);
    if (has_claim(study, name)) fail_without_figure("claim", name);
  }
  fail_unknown_figure(studies, charts, name);
}

}  // namespace mpmvv::reports
