#include "studies/study_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "studies/check.hpp"
#include "studies/error.hpp"
#include "studies/extrapolation.hpp"
#include "studies/observed_order.hpp"
#include "studies/replicates.hpp"
#include "studies/run/case_pool.hpp"
#include "studies/run/parallel.hpp"
#include "studies/run/samples.hpp"

namespace mpmvv {

namespace {

Point point_of(double x, const Record& r) {
  Point point{x, r.status, r.reason, {}};
  const auto add = [&point](const char* name, double value) {
    if (!std::isnan(value)) point.y[name] = value;
  };
  add("l1", r.error.l1);
  add("l2", r.error.l2);
  add("linf", r.error.linf);
  add("l1_all_steps", r.error.l1_all_steps);
  add("l2_all_steps", r.error.l2_all_steps);
  add("linf_all_steps", r.error.linf_all_steps);
  add("energy_loss", energy_loss(r.energy));
  add("nodal_l1", r.error.nodal_l1);
  add("nodal_l2", r.error.nodal_l2);
  add("nodal_linf", r.error.nodal_linf);
  add("velocity_error", r.error.velocity);
  add("stress_error", r.error.stress);
  add("mass_change", r.balance.mass);
  add("momentum_change", r.balance.momentum);
  add("angular_momentum_change", r.balance.angular_momentum);
  add("wall_seconds", r.wall_seconds);
  add("ns_per_particle_step", r.ns_per_particle_step);
  add("step_seconds", r.cost.step_seconds);
  add("step_seconds_spread", r.cost.spread);
  return point;
}

/// The geometric mean of what is positive, with which a line through logarithms goes through them all; else the mean.
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

/// Those of all series.
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

Probe probe_of(double value, const Record& r) {
  if (r.status == Status::failed) throw std::runtime_error(fmt::format("a probe at {} failed: {}", value, r.reason));
  return {value, r.status == Status::ok, r.reason};
}

StabilityLimit search_limit(const LimitSearch& search, const SeriesPlan& series, CasePool& pool) {
  return find_limit(search, [&](const std::vector<double>& values) {
    std::vector<Case> cases;
    for (const double value : values) cases.push_back(case_at(series, search.key, value, series.where));
    const auto records = pool.get(cases);
    std::vector<Probe> probes;
    for (std::size_t k = 0; k < values.size(); ++k) probes.push_back(probe_of(values[k], records[k]));
    return probes;
  });
}

bool is_wanted(const std::vector<std::string>& names, const Series& series) {
  return names.empty() || std::find(names.begin(), names.end(), series.name) != names.end();
}

void fit(const StudyPlan& plan, StudyResult& result) {
  for (Series& series : result.series)
    for (const FitPlan& wanted : plan.fits) {
      if (!is_wanted(wanted.series, series)) continue;
      const auto samples = samples_of(series, wanted.norm, result.sweep);
      ObservedOrder order = fit_order(samples, wanted.window.from, wanted.window.to);
      order.norm = wanted.norm;
      if (wanted.floor) order.floor = fit_floor(samples, wanted.floor->from, wanted.floor->to);
      if (plan.replicates)
        order.replicates = fit_replicates(replicate_samples_of(series, wanted.norm, result.sweep), wanted.window.from,
                                          wanted.window.to);
      series.orders.push_back(order);
    }
}

void extrapolate_series(const StudyPlan& plan, StudyResult& result) {
  for (Series& series : result.series)
    for (const ExtrapolationPlan& wanted : plan.extrapolations) {
      if (!is_wanted(wanted.series, series)) continue;
      Extrapolation extrapolation =
          extrapolate(samples_of(series, wanted.norm, result.sweep), wanted.window.from, wanted.window.to);
      extrapolation.norm = wanted.norm;
      series.extrapolations.push_back(extrapolation);
    }
}

/// What a check measured: from the store when this digest has run the same file, else anew.
CheckResult check_result(const StudyPlan& plan, const std::vector<StudyResult>& stored) {
  for (const StudyResult& s : stored)
    if (s.name == plan.name && s.text == plan.text) {
      CheckResult result{s.values, s.series};
      for (Series& series : result.series) series.orders.clear(), series.extrapolations.clear();
      return result;
    }
  return find_check(plan.check, plan.name).run();
}

}  // namespace

std::vector<StudyOutcome> run_studies(const std::vector<StudyPlan>& plans, Store& store, const RunnerOptions& options,
                                      RunnerCounts& counts) {
  const Provenance provenance = current_provenance();
  const auto stored = store.studies(provenance.digest);
  CasePool pool(store, options);
  std::vector<Case> untimed;
  for (const StudyPlan& plan : plans)
    for (const Case& c : sweep_cases(plan))
      if (c.measure.repeat == 0) untimed.push_back(c);
  pool.get(untimed);

  std::vector<StudyOutcome> outcomes;
  for (const StudyPlan& plan : plans) {
    StudyOutcome outcome;
    StudyResult& result = outcome.result;
    result = {plan.name, plan.title, plan.kind(), plan.sweep, plan.text, plan.claims, {}, {}, plan.figures, {}};
    std::vector<std::vector<Case>> cases;
    if (!plan.check.empty()) {
      const CheckResult checked = check_result(plan, stored);
      result.sweep = find_check(plan.check, plan.name).abscissa;
      result.values = checked.values;
      result.series = checked.series;
      cases.resize(result.series.size());
    }
    pool.get(sweep_cases(plan));  // what is timed takes turns within its study
    for (const SeriesPlan& series : plan.series) {
      const std::vector<Case> own = sweep_cases(plan, series);
      const std::vector<Record> records = pool.get(own);
      outcome.failed += static_cast<std::size_t>(std::ranges::count(records, Status::failed, &Record::status));
      result.series.push_back(swept_series(plan, series, records));
      cases.push_back(plan.replicates ? std::vector<Case>{} : own);
    }
    if (plan.limit)
      for_each_parallel(plan.series.size(), options.jobs, [&](std::size_t k) {
        result.series[k].limit = search_limit(*plan.limit, plan.series[k], pool);
      });
    fit(plan, result);
    extrapolate_series(plan, result);
    for (const Criterion& criterion : plan.criteria) result.parts.push_back(judge(criterion, result));
    store.keep_study(result, cases, provenance);
    outcomes.push_back(outcome);
  }
  counts = pool.counts();
  return outcomes;
}

}  // namespace mpmvv
