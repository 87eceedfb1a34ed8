#include "studies/plan/cost_model.hpp"

#include "studies/plan/estimates.hpp"
#include "studies/problems/problem.hpp"
#include "studies/settings/part.hpp"

namespace mpmvv::plan {

namespace {

/// Seconds per particle and step when nothing is known: for our solver, what the usual bases take on a core of 2023;
/// for another code, what a slow one takes.
double guessed_cost(const cases::Case& c) {
  constexpr double another_code = 1e-5;
  if (!c.scheme.code.empty()) return another_code;
  constexpr double by_dimension[]{5e-8, 5e-8, 1.5e-7};
  return by_dimension[problems::find_problem(c.problem.name, "the case").dimension() - 1];
}

}  // namespace

CostModel::CostModel(const store::Store* store)
    : store_(store), costs_(store ? store->step_costs() : store::StepCosts{}) {}

CostModel::Time CostModel::time(const cases::Case& c) const {
  const int runs = 1 + c.measure.repeat;
  if (const auto last = store_ ? store_->last_seconds(c) : std::nullopt) return {runs * *last, Source::same_case};
  const auto part = settings::part_of(c).value_or(settings::Part{c});
  const double work = runs * work_estimate(part.body) / solver::count(part.images);
  const auto [basis, integrator, velocity_update] = cases::method_of(c.scheme);
  if (const auto known = costs_.find({c.problem.name, basis, integrator, velocity_update}); known != costs_.end())
    return {known->second * work, Source::like_cases};
  return {guessed_cost(c) * work, Source::guess};
}

}  // namespace mpmvv::plan
