#include "cli/planted_series.hpp"

#include <algorithm>

#include "studies/codes/expressions.hpp"
#include "studies/plan/study.hpp"
#include "studies/plan/work.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using cases::ForceForm;

namespace {

/// Whether the body force is anywhere other than 0. A problem that has it only as a function of x has one.
bool has_body_force(const cases::ProblemChoice& problem) {
  const codes::Dialect& dialect = codes::dialect_named("c", "the solution");
  const auto force = [&](ForceForm form) { return codes::expressions(problem, form, dialect).b; };
  try {
    return force(ForceForm::reference) != force(ForceForm::none);
  } catch (const support::UsageError&) {
    return true;
  }
}

/// One of the series' cases.
cases::Case one_case(const plan::StudyPlan& plan, const plan::SeriesPlan& series) {
  if (!plan.sweep.empty()) return plan::sweep_cases(plan, series).front();
  return plan::scan_cases(plan, plan::replicates_of(plan, series).front()).front();
}

bool is_planted(const cases::Case& c) {
  const ForceForm form = c.scheme.force_form;
  return !c.scheme.code.empty() && (form == ForceForm::misplaced || form == ForceForm::none) &&
         has_body_force(c.problem);
}

}  // namespace

std::set<std::string> planted_series(const records::StudyResult& study) {
  std::set<std::string> planted;
  if (std::ranges::none_of(study.series, [](const records::Series& series) { return series.code.has_value(); }))
    return planted;
  try {
    const plan::StudyPlan plan = plan::parse_study(study.text, study.name + ".toml");
    for (const plan::SeriesPlan& series : plan.series)
      if (is_planted(one_case(plan, series))) planted.insert(series.name);
  } catch (const support::UsageError&) {
    return {};
  }
  return planted;
}

}  // namespace mpmvv::cli
