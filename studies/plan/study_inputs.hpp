#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/checks/check.hpp"
#include "studies/fits/stability_limit.hpp"
#include "studies/plan/case_pool.hpp"
#include "studies/plan/study.hpp"
#include "studies/plan/work.hpp"

namespace mpmvv::plan {

/// What a study is made from beside the runs of its sweep.
struct StudyInputs {
  std::optional<checks::CheckResult> check;
  std::vector<std::vector<fits::StabilityLimit>> limits;  ///< by series, of its replicates; empty: not searched
  std::string trouble;                                    ///< why some of it is missing; else empty
};

/// What the check measured when this digest last ran the same file; none otherwise, nor where a value of it is NaN.
std::optional<checks::CheckResult> stored_check(const StudyPlan& plan, const std::vector<records::StudyResult>& stored);

/// Runs sweeps (but for what is timed), checks and searches of limits beside each other, what takes longest first.
/// Inputs by plan; `checked` takes those of a study as soon as its check has run, on any thread.
std::vector<StudyInputs> run_beside_each_other(const std::vector<StudyPlan>& plans, const Work& work,
                                               const std::vector<records::StudyResult>& stored, CasePool& pool,
                                               int jobs,
                                               const std::function<void(std::size_t, const StudyInputs&)>& checked);

}  // namespace mpmvv::plan
