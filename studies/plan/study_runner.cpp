#include "studies/plan/study_runner.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "studies/checks/check.hpp"
#include "studies/claims/samples.hpp"
#include "studies/fits/extrapolation.hpp"
#include "studies/fits/observed_order.hpp"
#include "studies/fits/replicates.hpp"
#include "studies/plan/case_pool.hpp"
#include "studies/plan/study_inputs.hpp"

namespace mpmvv::plan {

using cases::Case;
using records::Point;
using records::Record;
using records::Series;
using records::Status;
using records::StudyResult;

namespace {

Point point_of(double x, const Record& r) {
  Point point{x, r.status, r.reason, {}};
  const auto add = [&point](const char* name, double value) {
    if (!std::isnan(value)) point.y[name] = value;
  };
  for (const records::RunNumber& number : records::run_errors()) add(number.name, number.get(r));
  for (const records::RunNumber& number : records::run_by_products()) add(number.name, number.get(r));
  add("energy_loss", records::energy_loss(r.energy));
  point.particle_errors = r.particle_errors;
  point.rounds = r.cost.rounds;
  return point;
}

/// The point of one run, or the mean of replicates; a replicate that is not ok speaks for all.
Point point_of(double x, std::span<const Record> records) {
  Point point = point_of(x, records.front());
  if (records.size() == 1) return point;
  point.rounds = {};
  for (const Record& r : records)
    if (r.status != Status::ok) return {x, r.status, r.reason, {}};
  for (const Record& r : records)
    for (const auto& [quantity, value] : point_of(x, r).y) point.replicates[quantity].push_back(value);
  for (const auto& [quantity, values] : point.replicates) point.y[quantity] = fits::mean_of_replicates(values).value;
  // Some replicates may run a part of the body, others all of it: their numbers of images have no mean.
  const std::vector<double>& images = point.replicates.at("images");
  if (std::ranges::count(images, images.front()) < std::ssize(images))
    point.y.erase("images"), point.replicates.erase("images");
  return point;
}

Series swept_series(const StudyPlan& plan, const SeriesPlan& series, std::span<const Record> records) {
  Series result{series.name, {}, {}, {}};
  const std::size_t each = plan.replicates ? plan.replicates->values.size() : 1;
  for (std::size_t k = 0; k < plan.values.size(); ++k)
    result.points.push_back(point_of(plan.values[k], records.subspan(k * each, each)));
  return result;
}

/// The other code that the series' settings choose, which complete_series has completed; none for our own solver.
std::optional<records::OtherCode> other_code(const SeriesPlan& series) {
  const auto word = [&](const char* key) {
    const settings::Setting* setting = series.setting(key);
    return setting ? setting->value : "";
  };
  if (!series.setting("code")) return std::nullopt;
  const std::string form = word("force_form");
  return records::OtherCode{word("code"), word("code_version"), word("variant"),
                            form.empty() ? support::to_string(cases::Scheme{}.force_form) : form, word("adapter")};
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

class StudyRunner {
 public:
  StudyRunner(store::Store& store, const RunnerOptions& options)
      : store_(store), options_(options), pool_(store, options) {}

  /// Timed cases come last, study by study, when nothing else waits: they have the machine to themselves.
  std::vector<StudyOutcome> run(const std::vector<StudyPlan>& plans) {
    std::vector<StudyOutcome> outcomes(plans.size());
    std::vector<char> is_done(plans.size(), 0);
    const auto finish = [&](std::size_t k, const StudyInputs& inputs) {
      outcomes[k] = outcome_of(plans[k], inputs);
      is_done[k] = 1;
    };
    const Work work = work_of(plans);
    const std::vector<StudyInputs> all_inputs =
        run_beside_each_other(plans, work, store_.studies(provenance_.digest), pool_, options_.jobs, finish);
    for (const bool timed : {false, true})
      for (std::size_t k = 0; k < plans.size(); ++k) {
        if (is_done[k] || is_timed(plans[k]) != timed) continue;
        if (timed) pool_.get(timed_with(plans[k], work));
        finish(k, all_inputs[k]);
      }
    return outcomes;
  }

  ShardOutcome run(const std::vector<StudyPlan>& plans, const Work& work) {
    ShardOutcome outcome;
    const auto keep_check = [&](std::size_t k, const StudyInputs& inputs) { outcome_of(plans[k], inputs); };
    const std::vector<StudyInputs> all_inputs =
        run_beside_each_other(plans, work, store_.studies(provenance_.digest), pool_, options_.jobs, keep_check);
    for (std::size_t k = 0; k < plans.size(); ++k)
      if (!all_inputs[k].trouble.empty()) outcome.troubles.push_back(plans[k].name + ": " + all_inputs[k].trouble);
    std::vector<std::vector<Case>> all_cases = work.timed;
    all_cases.push_back(work.runs);
    for (const std::vector<Case>& cases : all_cases)
      outcome.failed += static_cast<std::size_t>(std::ranges::count(pool_.get(cases), Status::failed, &Record::status));
    return outcome;
  }

  RunnerCounts counts() const { return pool_.counts(); }

 private:
  StudyOutcome outcome_of(const StudyPlan& plan, const StudyInputs& inputs) {
    StudyOutcome outcome;
    StudyResult& result = outcome.result;
    result = {plan.name, plan.title, plan.kind(), plan.sweep, plan.text, plan.claims, {}, {}, plan.figures, {}};
    for (const StatedClaim& claim : plan.statements) result.statements.push_back(claim.text);
    const auto cases = measure(plan, inputs, outcome);
    outcome.trouble = inputs.trouble;
    if (!outcome.trouble.empty()) return outcome;
    fit(plan, result);
    extrapolate_series(plan, result);
    for (const claims::Criterion& criterion : plan.criteria) result.parts.push_back(claims::judge(criterion, result));
    pool_.with_store([&] { store_.keep_study(result, cases, store::with_present_time(provenance_)); });
    return outcome;
  }

  /// Fills in the series and values of the outcome; returns the cases of each series.
  std::vector<std::vector<Case>> measure(const StudyPlan& plan, const StudyInputs& inputs, StudyOutcome& outcome) {
    StudyResult& result = outcome.result;
    if (inputs.check) {
      result.sweep = checks::find_check(plan.check, plan.name).abscissa;
      result.values = inputs.check->values;
      result.series = inputs.check->series;
    }
    std::vector<std::vector<Case>> cases(result.series.size());
    pool_.get(sweep_cases(plan));  // all series at once, so that timed cases take turns
    for (std::size_t s = 0; s < plan.series.size(); ++s) {
      const std::vector<Case> own = sweep_cases(plan, plan.series[s]);
      const std::vector<Record> records = pool_.get(own);
      outcome.failed += static_cast<std::size_t>(std::ranges::count(records, Status::failed, &Record::status));
      result.series.push_back(swept_series(plan, plan.series[s], records));
      result.series.back().code = other_code(plan.series[s]);
      cases.push_back(plan.replicates ? std::vector<Case>{} : own);
      if (plan.searches(plan.series[s]) && inputs.trouble.empty())
        result.series.back().limit = fits::common_limit(inputs.limits[s], plan.limit->search.stable_below);
    }
    return cases;
  }

  store::Store& store_;
  const RunnerOptions& options_;
  const store::Provenance provenance_ = store::current_provenance();
  CasePool pool_;
};

}  // namespace

std::vector<StudyOutcome> run_studies(const std::vector<StudyPlan>& plans, store::Store& store,
                                      const RunnerOptions& options, RunnerCounts& counts) {
  StudyRunner runner(store, options);
  std::vector<StudyOutcome> outcomes = runner.run(plans);
  counts = runner.counts();
  return outcomes;
}

ShardOutcome run_shard(const std::vector<StudyPlan>& plans, const Work& work, store::Store& store,
                       const RunnerOptions& options, RunnerCounts& counts) {
  StudyRunner runner(store, options);
  ShardOutcome outcome = runner.run(plans, work);
  counts = runner.counts();
  return outcome;
}

}  // namespace mpmvv::plan
