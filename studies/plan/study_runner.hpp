#pragma once
#include <functional>
#include <string>
#include <vector>

#include "studies/plan/study.hpp"
#include "studies/records/result.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::plan {

/// How far a study run has come; called after every finished case, from one thread at a time.
struct Progress {
  std::size_t done = 0, total = 0;  ///< cases of the present batch
  std::string label;                ///< the case that has just finished
};

struct RunnerOptions {
  int jobs = 1;  ///< cases at once
  std::function<void(const Progress&)> progress;
};

struct StudyOutcome {
  records::StudyResult result;
  std::size_t failed = 0;  ///< cases with status `failed`
  std::string trouble;     ///< why it could not be brought to its end and was not kept; else empty
};

struct RunnerCounts {
  std::size_t ran = 0, reused = 0;
};

/// Runs what the store does not hold yet: all studies' sweeps, checks and limits in one pool, what is timed after them,
/// study by study. Keeps every record as soon as it is there, studies when the pool is empty, timed ones as soon as
/// they are whole. Results do not depend on `jobs`.
std::vector<StudyOutcome> run_studies(const std::vector<StudyPlan>& plans, store::Store& store,
                                      const RunnerOptions& options, RunnerCounts& counts);

}  // namespace mpmvv::plan
