#include "studies/plan/study_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "studies/checks/check.hpp"
#include "studies/claims/samples.hpp"
#include "studies/fits/extrapolation.hpp"
#include "studies/fits/observed_order.hpp"
#include "studies/fits/replicates.hpp"
#include "studies/plan/case_pool.hpp"
#include "studies/support/error.hpp"
#include "studies/support/parallel.hpp"
#include "studies/support/reason.hpp"

namespace mpmvv::plan {

using cases::Case;
using records::Point;
using records::Record;
using records::Series;
using records::Status;
using records::StudyResult;

namespace {

/// Thrown where a study cannot be finished, as its check or a probe of its limit failed.
struct StudyTrouble : std::runtime_error {
  using std::runtime_error::runtime_error;
};

Point point_of(double x, const Record& r) {
  Point point{x, r.status, r.reason, {}};
  const auto add = [&point](const char* name, double value) {
    if (!std::isnan(value)) point.y[name] = value;
  };
  for (const records::RunNumber& number : records::run_errors()) add(number.name, number.get(r));
  for (const records::RunNumber& number : records::run_by_products()) add(number.name, number.get(r));
  add("energy_loss", records::energy_loss(r.energy));
  return point;
}

/// The geometric mean of positive values, so that a fit to logarithms of means is one to all values; else the mean.
double mean(const std::vector<double>& values) {
  const bool positive = std::ranges::all_of(values, [](double value) { return value > 0; });
  double sum = 0;
  for (const double value : values) sum += positive ? std::log(value) : value;
  sum /= static_cast<double>(values.size());
  return positive ? std::exp(sum) : sum;
}

/// The point of one run, or the mean of replicates; a replicate that is not ok speaks for all.
Point point_of(double x, std::span<const Record> records) {
  Point point = point_of(x, records.front());
  if (records.size() == 1) return point;
  for (const Record& r : records)
    if (r.status != Status::ok) return {x, r.status, r.reason, {}};
  for (const Record& r : records)
    for (const auto& [quantity, value] : point_of(x, r).y) point.replicates[quantity].push_back(value);
  for (const auto& [quantity, values] : point.replicates) point.y[quantity] = mean(values);
  return point;
}

/// The cases of a series, those of one swept value together.
std::vector<Case> sweep_cases(const StudyPlan& plan, const SeriesPlan& series) {
  std::vector<Case> cases;
  for (const double value : plan.values)
    for (const Case& c : replicates_at(plan, series, value)) cases.push_back(c);
  return cases;
}

/// The cases of all series.
std::vector<Case> sweep_cases(const StudyPlan& plan) {
  std::vector<Case> cases;
  for (const SeriesPlan& series : plan.series)
    for (const Case& c : sweep_cases(plan, series)) cases.push_back(c);
  return cases;
}

Series swept_series(const StudyPlan& plan, const SeriesPlan& series, std::span<const Record> records) {
  Series result{series.name, {}, {}, {}};
  const std::size_t each = plan.replicates ? plan.replicates->values.size() : 1;
  for (std::size_t k = 0; k < plan.values.size(); ++k)
    result.points.push_back(point_of(plan.values[k], records.subspan(k * each, each)));
  return result;
}

/// The probe at the value that was run: a time step is made smaller than the CFL number asked for, to divide the end
/// time.
fits::Probe probe_of(const std::string& key, double asked, const Record& r) {
  if (r.status == Status::failed) throw StudyTrouble(fmt::format("a probe at {} failed: {}", asked, r.reason));
  return {key == "cfl" ? r.cfl : asked, r.status == Status::ok, r.reason};
}

fits::StabilityLimit search_limit(const fits::LimitSearch& search, const SeriesPlan& series, CasePool& pool) {
  return fits::find_limit(search, [&](const std::vector<double>& values) {
    std::vector<Case> cases;
    for (const double value : values) cases.push_back(case_at(series, search.key, value, series.where));
    const auto records = pool.get(cases);
    std::vector<fits::Probe> probes;
    for (std::size_t k = 0; k < values.size(); ++k) probes.push_back(probe_of(search.key, values[k], records[k]));
    return probes;
  });
}

fits::StabilityLimit search_limit(const StudyPlan& plan, const SeriesPlan& series, CasePool& pool) {
  std::vector<fits::StabilityLimit> limits;
  for (const SeriesPlan& one : replicates_of(plan, series))
    limits.push_back(search_limit(plan.limit->search, one, pool));
  return fits::common_limit(limits);
}

bool is_wanted(const std::vector<std::string>& names, const Series& series) {
  return names.empty() || std::find(names.begin(), names.end(), series.name) != names.end();
}

void fit(const StudyPlan& plan, StudyResult& result) {
  for (Series& series : result.series)
    for (const FitPlan& wanted : plan.fits) {
      if (!is_wanted(wanted.series, series)) continue;
      const auto samples = claims::samples_of(series, wanted.norm, result.sweep);
      fits::ObservedOrder order = fits::fit_order(samples, wanted.window.from, wanted.window.to);
      order.norm = wanted.norm;
      if (wanted.floor) order.floor = fits::fit_floor(samples, wanted.floor->from, wanted.floor->to);
      if (plan.replicates)
        order.replicates = fits::fit_replicates(claims::replicate_samples_of(series, wanted.norm, result.sweep),
                                                wanted.window.from, wanted.window.to);
      series.orders.push_back(order);
    }
}

void extrapolate_series(const StudyPlan& plan, StudyResult& result) {
  for (Series& series : result.series)
    for (const ExtrapolationPlan& wanted : plan.extrapolations) {
      if (!is_wanted(wanted.series, series)) continue;
      fits::Extrapolation extrapolation = fits::extrapolate(claims::samples_of(series, wanted.norm, result.sweep),
                                                            wanted.window.from, wanted.window.to);
      extrapolation.norm = wanted.norm;
      series.extrapolations.push_back(extrapolation);
    }
}

/// What a check measured: from the store when this digest has run the same file, else anew.
checks::CheckResult check_result(const StudyPlan& plan, const std::vector<StudyResult>& stored) {
  for (const StudyResult& s : stored)
    if (s.name == plan.name && s.text == plan.text) {
      checks::CheckResult result{s.values, s.series};
      for (Series& series : result.series) series.orders.clear(), series.extrapolations.clear();
      return result;
    }
  try {
    return checks::find_check(plan.check, plan.name).run();
  } catch (const std::exception& e) {
    throw StudyTrouble(fmt::format("its check ended early: {}", support::reason_of(e)));
  }
}

class StudyRunner {
 public:
  StudyRunner(store::Store& store, const RunnerOptions& options)
      : store_(store), options_(options), stored_(store.studies(provenance_.digest)), pool_(store, options) {}

  void run_untimed(const std::vector<StudyPlan>& plans) {
    std::vector<Case> untimed;
    for (const StudyPlan& plan : plans)
      for (const Case& c : sweep_cases(plan))
        if (c.measure.repeat == 0) untimed.push_back(c);
    pool_.get(untimed);
  }

  StudyOutcome run(const StudyPlan& plan) {
    StudyOutcome outcome;
    StudyResult& result = outcome.result;
    result = {plan.name, plan.title, plan.kind(), plan.sweep, plan.text, plan.claims, {}, {}, plan.figures, {}};
    try {
      const auto cases = measure(plan, outcome);
      fit(plan, result);
      extrapolate_series(plan, result);
      for (const claims::Criterion& criterion : plan.criteria) result.parts.push_back(claims::judge(criterion, result));
      store_.keep_study(result, cases, provenance_);
    } catch (const StudyTrouble& trouble) {
      outcome.trouble = trouble.what();
    }
    return outcome;
  }

  RunnerCounts counts() const { return pool_.counts(); }

 private:
  /// Series and values of the outcome; the cases of each series.
  std::vector<std::vector<Case>> measure(const StudyPlan& plan, StudyOutcome& outcome) {
    StudyResult& result = outcome.result;
    if (!plan.check.empty()) {
      const checks::CheckResult checked = check_result(plan, stored_);
      result.sweep = checks::find_check(plan.check, plan.name).abscissa;
      result.values = checked.values;
      result.series = checked.series;
    }
    std::vector<std::vector<Case>> cases(result.series.size());
    pool_.get(sweep_cases(plan));  // what is timed takes turns within its study
    for (const SeriesPlan& series : plan.series) {
      const std::vector<Case> own = sweep_cases(plan, series);
      const std::vector<Record> records = pool_.get(own);
      outcome.failed += static_cast<std::size_t>(std::ranges::count(records, Status::failed, &Record::status));
      result.series.push_back(swept_series(plan, series, records));
      cases.push_back(plan.replicates ? std::vector<Case>{} : own);
    }
    support::for_each_parallel(plan.series.size(), options_.jobs, [&](std::size_t k) {
      if (plan.searches(plan.series[k])) result.series[k].limit = search_limit(plan, plan.series[k], pool_);
    });
    return cases;
  }

  store::Store& store_;
  const RunnerOptions& options_;
  const store::Provenance provenance_ = store::current_provenance();
  const std::vector<StudyResult> stored_;
  CasePool pool_;
};

}  // namespace

std::vector<StudyOutcome> run_studies(const std::vector<StudyPlan>& plans, store::Store& store,
                                      const RunnerOptions& options, RunnerCounts& counts) {
  StudyRunner runner(store, options);
  runner.run_untimed(plans);
  std::vector<StudyOutcome> outcomes;
  for (const StudyPlan& plan : plans) outcomes.push_back(runner.run(plan));
  counts = runner.counts();
  return outcomes;
}

}  // namespace mpmvv::plan
