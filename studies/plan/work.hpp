#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/plan/study.hpp"
#include "studies/records/record.hpp"

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
  std::vector<std::vector<cases::Case>> timed;  ///< those that take turns: of a study, and of all that share one
};

/// All that the studies ask for; a case once for each that asks for it.
Work work_of(const std::vector<StudyPlan>& plans);

/// The cases of a series, those of one swept value together; those of all series.
std::vector<cases::Case> sweep_cases(const StudyPlan& plan, const SeriesPlan& series);
std::vector<cases::Case> sweep_cases(const StudyPlan& plan);

/// All cases that take turns with the timed cases of the study; none when it has none.
std::vector<cases::Case> timed_with(const StudyPlan& plan, const Work& work);

/// Those of the timed cases that have been timed, but must be timed anew, so that all of them take turns: one of the
/// others has never been run, or two were timed in different sessions. `find` looks up the record of a case.
std::vector<cases::Case> timed_apart(const std::vector<cases::Case>& cases,
                                     const std::function<std::optional<records::Record>(const cases::Case&)>& find);

/// Whether the study measures costs.
bool is_timed(const StudyPlan& plan);

/// The run of a replicate with which a limit's search probes a value.
cases::Case probe_case(const fits::LimitSearch& search, const SeriesPlan& replicate, double value);

/// The runs that a limit's scan asks for at most.
std::vector<cases::Case> scan_cases(const StudyPlan& plan, const SeriesPlan& replicate);
std::vector<cases::Case> scan_cases(const std::vector<StudyPlan>& plans, const LimitTask& limit);

}  // namespace mpmvv::plan
