#include "studies/plan/study_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <stdexcept>

#include "studies/settings/part.hpp"
#include "studies/support/parallel.hpp"
#include "studies/support/reason.hpp"

namespace mpmvv::plan {

using cases::Case;
using records::Record;

namespace {

/// A probe that could not be carried out.
struct ProbeFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The probe at the value that was run: a time step is made smaller than the CFL number asked for, to divide the end
/// time.
fits::Probe probe_of(const std::string& key, double asked, const Record& r) {
  if (r.status == records::Status::failed) throw ProbeFailed(fmt::format("a probe at {} failed: {}", asked, r.reason));
  return {key == "cfl" ? r.cfl : asked, r.status == records::Status::ok, r.reason};
}

/// The whole body: near its limit round-off decides, and grows otherwise in a part of it.
Case probe_case(const fits::LimitSearch& search, const SeriesPlan& series, double value) {
  return settings::as_whole(case_at(series, search.key, value, series.where));
}

fits::StabilityLimit search_limit(const fits::LimitSearch& search, const SeriesPlan& series, CasePool& pool) {
  return fits::find_limit(search, [&](const std::vector<double>& values) {
    std::vector<Case> cases;
    for (const double value : values) cases.push_back(probe_case(search, series, value));
    const auto records = pool.get(cases);
    std::vector<fits::Probe> probes;
    for (std::size_t k = 0; k < values.size(); ++k) probes.push_back(probe_of(search.key, values[k], records[k]));
    return probes;
  });
}

struct Task {
  double seconds;  ///< about
  std::function<void()> run;
};

/// The tasks of studies. Plans and inputs must outlive it.
class Tasks {
 public:
  explicit Tasks(CasePool& pool) : pool_(pool) {}

  void add_sweeps(const std::vector<StudyPlan>& plans) {
    std::vector<Case> untimed;
    for (const StudyPlan& plan : plans)
      for (const Case& c : sweep_cases(plan))
        if (c.measure.repeat == 0) untimed.push_back(c);
    const std::vector<Case> missing = pool_.missing(untimed);
    const double all = pool_.seconds(missing);
    for (const Case& c : missing) tasks_.push_back({pool_.seconds({c}), [this, c, all] { pool_.run(c, all); }});
  }

  /// Nothing is known of how long checks take; the longest take some seconds.
  void add_check(const StudyPlan& plan, StudyInputs& input, const std::function<void()>& when_done) {
    constexpr double about = 5;
    pool_.expect(about);
    tasks_.push_back({about, [this, &plan, &input, when_done] {
                        pool_.expect(-about);
                        try {
                          const auto place = pool_.place();
                          input.check = checks::find_check(plan.check, plan.name).run();
                        } catch (const std::exception& e) {
                          note(input, fmt::format("its check ended early: {}", support::reason_of(e)));
                        }
                        when_done();
                      }});
  }

  void add_limits(const StudyPlan& plan, StudyInputs& input) {
    input.limits.resize(plan.series.size());
    for (std::size_t s = 0; s < plan.series.size(); ++s) {
      if (!plan.searches(plan.series[s])) continue;
      const auto replicates = replicates_of(plan, plan.series[s]);
      input.limits[s].resize(replicates.size());
      for (std::size_t k = 0; k < replicates.size(); ++k) {
        const double about = pool_.seconds(scan_cases(plan, replicates[k]));
        pool_.expect(about);
        tasks_.push_back({about, [this, about, &plan, &input, s, k, replicate = replicates[k]] {
                            pool_.expect(-about);
                            try {
                              input.limits[s][k] = search_limit(plan.limit->search, replicate, pool_);
                            } catch (const ProbeFailed& failed) {
                              note(input, failed.what());
                            }
                          }});
      }
    }
  }

  void run(int jobs) {
    std::ranges::stable_sort(tasks_, std::greater{}, &Task::seconds);
    support::for_each_parallel(tasks_.size(), jobs, [&](std::size_t k) { tasks_[k].run(); });
  }

 private:
  void note(StudyInputs& input, const std::string& trouble) {
    const std::lock_guard lock(mutex_);
    input.trouble = trouble;
  }

  CasePool& pool_;
  std::vector<Task> tasks_;
  std::mutex mutex_;  ///< of troubles
};

}  // namespace

std::vector<Case> sweep_cases(const StudyPlan& plan, const SeriesPlan& series) {
  std::vector<Case> cases;
  for (const double value : plan.values)
    for (const Case& c : replicates_at(plan, series, value)) cases.push_back(c);
  return cases;
}

std::vector<Case> sweep_cases(const StudyPlan& plan) {
  std::vector<Case> cases;
  for (const SeriesPlan& series : plan.series)
    for (const Case& c : sweep_cases(plan, series)) cases.push_back(c);
  return cases;
}

bool is_timed(const StudyPlan& plan) {
  return std::ranges::any_of(sweep_cases(plan), [](const Case& c) { return c.measure.repeat > 0; });
}

std::vector<Case> scan_cases(const StudyPlan& plan, const SeriesPlan& replicate) {
  std::vector<Case> cases;
  for (const double value : fits::scan_values(plan.limit->search))
    cases.push_back(probe_case(plan.limit->search, replicate, value));
  return cases;
}

std::optional<checks::CheckResult> stored_check(const StudyPlan& plan,
                                                const std::vector<records::StudyResult>& stored) {
  for (const records::StudyResult& s : stored)
    if (s.name == plan.name && s.text == plan.text) {
      checks::CheckResult result{s.values, s.series};
      for (records::Series& series : result.series) series.orders.clear(), series.extrapolations.clear();
      return result;
    }
  return std::nullopt;
}

std::vector<StudyInputs> run_beside_each_other(const std::vector<StudyPlan>& plans,
                                               const std::vector<records::StudyResult>& stored, CasePool& pool,
                                               int jobs,
                                               const std::function<void(std::size_t, const StudyInputs&)>& checked) {
  auto inputs = std::vector<StudyInputs>(plans.size());
  Tasks tasks(pool);
  tasks.add_sweeps(plans);
  for (std::size_t k = 0; k < plans.size(); ++k) {
    if (!plans[k].check.empty()) inputs[k].check = stored_check(plans[k], stored);
    if (!plans[k].check.empty() && !inputs[k].check)
      tasks.add_check(plans[k], inputs[k], [&, k] { checked(k, inputs[k]); });
    if (plans[k].limit) tasks.add_limits(plans[k], inputs[k]);
  }
  tasks.run(jobs);
  return inputs;
}

}  // namespace mpmvv::plan
