#pragma once
#include <cstddef>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/plan/study.hpp"

namespace mpmvv::plan {

/// The search of a limit: of which study, series and replicate, by their indices.
struct LimitTask {
  std::size_t plan = 0, series = 0, replicate = 0;

  auto operator<=>(const LimitTask&) const = default;
};

/// What studies ask for, as far as it is known before it runs.
struct Work {
  std::vector<cases::Case> runs;                ///< of sweeps, but for what is timed
  std::vector<std::size_t> checks;              ///< indices of their studies
  std::vector<LimitTask> limits;                ///< which cases they probe shows as they go on
  std::vector<std::vector<cases::Case>> timed;  ///< by study; those of one study take turns
};

/// All that the studies ask for; a case once for each that asks for it.
Work work_of(const std::vector<StudyPlan>& plans);

/// The cases of a series, those of one swept value together; those of all series.
std::vector<cases::Case> sweep_cases(const StudyPlan& plan, const SeriesPlan& series);
std::vector<cases::Case> sweep_cases(const StudyPlan& plan);

/// Whether the study measures costs.
bool is_timed(const StudyPlan& plan);

/// The run of a replicate with which a limit's search probes a value.
cases::Case probe_case(const fits::LimitSearch& search, const SeriesPlan& replicate, double value);

/// The runs that a limit's scan asks for at most.
std::vector<cases::Case> scan_cases(const StudyPlan& plan, const SeriesPlan& replicate);
std::vector<cases::Case> scan_cases(const std::vector<StudyPlan>& plans, const LimitTask& limit);

}  // namespace mpmvv::plan
