#pragma once
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "studies/codes/code.hpp"
#include "studies/plan/progress.hpp"
#include "studies/plan/study.hpp"
#include "studies/plan/work.hpp"
#include "studies/records/result.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::plan {

struct RunnerCounts {
  std::size_t ran = 0, reused = 0;
  std::size_t unkept = 0;  ///< finished, but not in the store, because another process has locked it
};

/// The functions are called by one thread at a time, while others wait that finish a case: they should be quick.
/// `on_wait` may be called beside another one.
struct RunnerOptions {
  int jobs = 1;                                           ///< cases at once
  std::function<void(const Progress&)> progress = {};     ///< told of every case that has finished
  std::function<void(const Progress&)> more_work = {};    ///< told when more cases are asked for
  std::stop_token stop = {};                              ///< asks to stop before the end
  std::function<void(const RunnerCounts&)> on_stop = {};  ///< then ends the program, while no thread uses the store
  codes::Codes codes = {};                                ///< those of all series
  bool retries = true;                 ///< whether failed cases that are worth another try (record.hpp) are run again
  std::function<void()> on_wait = {};  ///< told once each time that another process keeps the store locked for long
};

struct StudyOutcome {
  records::StudyResult result;
  std::size_t failed = 0;  ///< cases with status `failed`
  std::string trouble;     ///< why it was not finished and not kept; else empty
};

/// Runs what the store does not hold yet: all studies' sweeps, checks and limits in one pool, then the timed cases,
/// study by study. Keeps every record as soon as it exists; the study of a check as soon as that has run, other studies
/// when the pool is empty, timed ones as soon as they are complete. Results do not depend on `jobs`. When asked to stop
/// it abandons the cases that are running; finished ones are in the store.
std::vector<StudyOutcome> run_studies(const std::vector<StudyPlan>& plans, store::Store& store,
                                      const RunnerOptions& options, RunnerCounts& counts);

/// What came of one machine's work.
struct ShardOutcome {
  std::size_t failed = 0;             ///< cases with status `failed`
  std::vector<std::string> troubles;  ///< "n-fig8: its check ended early: ...": what was not finished
};

/// Runs what the store does not hold of one machine's work, in the order of `run_studies`, and keeps its records and
/// checks. What is derived from them is made after the machines' stores have been merged: there `run_studies` finds all
/// that it asks for.
ShardOutcome run_shard(const std::vector<StudyPlan>& plans, const Work& work, store::Store& store,
                       const RunnerOptions& options, RunnerCounts& counts);

}  // namespace mpmvv::plan
