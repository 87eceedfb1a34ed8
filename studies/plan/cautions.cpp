#include "studies/plan/cautions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "studies/codes/score.hpp"

namespace mpmvv::plan {

namespace {

/// The texts for a series, which follow from its problem alone, not from how finely that is resolved.
std::set<std::string> texts_for(const StudyPlan& plan, const SeriesPlan& series) {
  const bool sweeps = !plan.values.empty();
  std::set<cases::ProblemChoice> problems;
  std::set<std::string> texts;
  for (const double value : sweeps ? plan.values : std::vector{plan.limit->search.from}) {
    const cases::Case c = case_at(series, sweeps ? plan.sweep : plan.limit->search.key, value, plan.sweep_where);
    if (problems.insert(c.problem).second) texts.insert(codes::caution(c));
  }
  texts.erase("");
  return texts;
}

}  // namespace

std::vector<Caution> cautions(const StudyPlan& plan) {
  std::vector<Caution> all;
  for (const SeriesPlan& series : plan.series) {
    if (!series.setting("code")) continue;
    for (const std::string& text : texts_for(plan, series)) {
      auto caution = std::ranges::find(all, text, &Caution::text);
      if (caution == all.end()) caution = all.insert(caution, {text, {}});
      caution->series.push_back(series.name);
    }
  }
  return all;
}

std::string caution_text(const std::string& study, const Caution& caution) {
  return fmt::format("{}, '{}': {}", study, fmt::join(caution.series, "', '"), caution.text);
}

}  // namespace mpmvv::plan
