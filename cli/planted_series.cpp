#include "cli/planted_series.hpp"

#include <algorithm>

#include "studies/codes/planted.hpp"
#include "studies/plan/study.hpp"
#include "studies/plan/work.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

namespace {

/// One of the series' cases.
cases::Case one_case(const plan::StudyPlan& plan, const plan::SeriesPlan& series) {
  if (!plan.sweep.empty()) return plan::sweep_cases(plan, series).front();
  return plan::scan_cases(plan, plan::replicates_of(plan, series).front()).front();
}

}  // namespace

std::set<std::string> planted_series(const records::StudyResult& study) {
  std::set<std::string> planted;
  if (std::ranges::none_of(study.series, [](const records::Series& series) { return series.code.has_value(); }))
    return planted;
  try {
    const plan::StudyPlan plan = plan::parse_study(study.text, study.name + ".toml");
    for (const plan::SeriesPlan& series : plan.series)
      if (codes::is_planted(one_case(plan, series))) planted.insert(series.name);
  } catch (const support::UsageError&) {
    return {};
  }
  return planted;
}

}  // namespace mpmvv::cli
