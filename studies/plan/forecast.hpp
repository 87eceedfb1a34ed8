#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "studies/plan/cost_model.hpp"
#include "studies/plan/study.hpp"
#include "studies/plan/work.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::plan {

/// What a study would run, and why.
struct StudyForecast {
  std::string study;
  std::size_t cases = 0;   ///< of its sweep, each once; without the probes of limits
  std::size_t stored = 0;  ///< those that the store has
  std::size_t shared = 0;  ///< those that a study before it runs
  std::size_t runs = 0;    ///< those that it runs
  std::size_t parts = 0;   ///< of these, runs of a part of the body
  std::size_t timed = 0;   ///< of these, runs alone on the machine, after all others
  std::size_t anew = 0;    ///< of these, cases whose times the store has, but not of the same rounds
  std::size_t probes = 0;  ///< of the scans for limits, each once, less what the store has or a sweep so far runs
  double seconds = 0;      ///< of all that it runs, one after the other on one core; a check counts `about_check`
  std::string why;         ///< in words
};

/// What `run_studies` would do, studies in the order given.
struct Forecast {
  std::vector<StudyForecast> studies;
  double core_seconds = 0;   ///< of all studies
  double timed_seconds = 0;  ///< the part of these for timed runs
  double seconds = 0;        ///< until the end, on `jobs` cores
};

/// Runs nothing and keeps nothing. `store` is null where there is none yet.
Forecast forecast(const std::vector<StudyPlan>& plans, const store::Store* store, int jobs);

/// The same for one machine's work, with other times than those of the store; studies of which it does nothing are left
/// out.
Forecast forecast(const std::vector<StudyPlan>& plans, const Work& work, const store::Store* store,
                  const CostModel& costs, int jobs);

/// A part of some work: its seconds on one core, and whether all threads may share it.
struct Load {
  double seconds = 0;
  bool can_be_shared = true;
};

/// Seconds until `jobs` workers are done, each taking the largest load that is left. All of them share those that would
/// outlast the others.
double seconds_on(int jobs, std::vector<Load> loads);

}  // namespace mpmvv::plan
