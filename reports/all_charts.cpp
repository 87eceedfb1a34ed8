#include <fmt/format.h>

#include <map>

#include "reports/chart.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::reports {

using records::StudyResult;

namespace {

/// UsageError where a name of a study or figure cannot be the name of a file.
void check_names(const std::vector<StudyResult>& studies, const std::vector<std::vector<Chart>>& charts) {
  const auto check = [](const std::string& what, const std::string& name) {
    if (!support::is_file_stem(name))
      throw support::UsageError(
          fmt::format("{} '{}' cannot name a file (use letters, digits, '.', '_', '+' and '-')", what, name));
  };
  for (std::size_t i = 0; i < studies.size(); ++i) {
    check("study", studies[i].name);
    for (const auto& chart : charts[i]) check(fmt::format("study '{}': figure", studies[i].name), chart.name);
  }
}

/// Where studies share a figure's name, the study's name and a sign that no name holds are put before it.
void tell_figures_apart(const std::vector<StudyResult>& studies, std::vector<std::vector<Chart>>& charts) {
  std::map<std::string, int> count;
  for (const auto& of_study : charts)
    for (const auto& chart : of_study) ++count[chart.name];
  for (std::size_t i = 0; i < studies.size(); ++i)
    for (auto& chart : charts[i])
      if (count.at(chart.name) > 1) chart.name = studies[i].name + "~" + chart.name;
}

}  // namespace

std::vector<std::vector<Chart>> charts_of_all(const std::vector<StudyResult>& studies, double letter) {
  std::vector<std::vector<Chart>> charts;
  for (const auto& study : studies) charts.push_back(charts_of(study, letter));
  check_names(studies, charts);
  tell_figures_apart(studies, charts);
  return charts;
}

}  // namespace mpmvv::reports
