#include "studies/plan/study_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <stdexcept>

#include "studies/plan/estimates.hpp"
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

/// How a probe of another code that fails where it would blow up becomes unstable; empty for other failures.
std::string remedy(const Record& r) {
  const std::string& code = r.the_case.scheme.code;
  if (code.empty() || r.failure != records::Failure::of_case) return "";
  return fmt::format(
      " (if this is how '{}' says that the motion blew up: put words of it into `unstable` of [command] in its "
      "adapter)",
      code);
}

/// The probe, at the value that was really run: the time step is made smaller than the CFL number asks for, so that it
/// divides the end time.
fits::Probe probe_of(const std::string& key, double asked, const Record& r) {
  if (r.status == records::Status::failed)
    throw ProbeFailed(fmt::format("a probe at {} failed: {}{}", asked, r.reason, remedy(r)));
  return {key == "cfl" ? r.cfl : asked, r.status == records::Status::ok, r.reason, r.steps};
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

  void add_runs(const std::vector<Case>& cases) {
    const std::vector<Case> missing = pool_.missing(cases);
    const double all = pool_.seconds(missing);
    for (const Case& c : missing) tasks_.push_back({pool_.seconds({c}), [this, c, all] { pool_.run(c, all); }});
  }

  void add_check(const StudyPlan& plan, StudyInputs& input, const std::function<void()>& when_done) {
    constexpr double about = about_check;
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

  void add_limit(const StudyPlan& plan, const LimitTask& limit, StudyInputs& input) {
    const auto replicates = replicates_of(plan, plan.series[limit.series]);
    input.limits.resize(plan.series.size());
    input.limits[limit.series].resize(replicates.size());
    const double about = pool_.seconds(scan_cases(plan, replicates[limit.replicate]));
    pool_.expect(about);
    tasks_.push_back({about, [this, about, &plan, &input, limit, replicate = replicates[limit.replicate]] {
                        pool_.expect(-about);
                        try {
                          input.limits[limit.series][limit.replicate] =
                              search_limit(plan.limit->search, replicate, pool_);
                        } catch (const ProbeFailed& failed) {
                          note(input, failed.what());
                        }
                      }});
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
  std::mutex mutex_;  ///< guards the inputs' troubles
};

bool is_measured(const records::Value& value) {
  return !std::isnan(value.value);
}

}  // namespace

std::optional<checks::CheckResult> stored_check(const StudyPlan& plan,
                                                const std::vector<records::StudyResult>& stored) {
  for (const records::StudyResult& s : stored)
    if (s.name == plan.name && s.text == plan.text && std::ranges::all_of(s.values, is_measured)) {
      checks::CheckResult result{s.values, s.series};
      for (records::Series& series : result.series) series.orders.clear(), series.extrapolations.clear();
      return result;
    }
  return std::nullopt;
}

std::vector<StudyInputs> run_beside_each_other(const std::vector<StudyPlan>& plans, const Work& work,
                                               const std::vector<records::StudyResult>& stored, CasePool& pool,
                                               int jobs,
                                               const std::function<void(std::size_t, const StudyInputs&)>& checked) {
  auto inputs = std::vector<StudyInputs>(plans.size());
  Tasks tasks(pool);
  tasks.add_runs(work.runs);
  for (const std::size_t k : work.checks) {
    inputs[k].check = stored_check(plans[k], stored);
    if (!inputs[k].check) tasks.add_check(plans[k], inputs[k], [&, k] { checked(k, inputs[k]); });
  }
  for (const LimitTask& limit : work.limits) tasks.add_limit(plans[limit.plan], limit, inputs[limit.plan]);
  tasks.run(jobs);
  return inputs;
}

}  // namespace mpmvv::plan
