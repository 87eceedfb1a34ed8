#include "studies/plan/forecast.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

#include "studies/plan/estimates.hpp"
#include "studies/plan/study_inputs.hpp"
#include "studies/records/record.hpp"
#include "studies/settings/part.hpp"
#include "studies/store/provenance.hpp"

namespace mpmvv::plan {

using cases::Case;

namespace {

class Forecaster {
 public:
  Forecaster(const Work& work, const store::Store* store, const CostModel& costs, int jobs)
      : cases_(work.runs.begin(), work.runs.end()),
        checks_(work.checks.begin(), work.checks.end()),
        store_(store),
        jobs_(jobs),
        costs_(costs) {
    for (const std::vector<Case>& timed : work.timed) {
      cases_.insert(timed.begin(), timed.end());
      for (const Case& c : timed_apart(timed, [this](const Case& one) { return stored(one); })) timed_anew_.insert(c);
    }
    for (const LimitTask& limit : work.limits) limits_[limit.plan].push_back(limit);
    if (store) stored_studies_ = store->studies(digest_);
  }

  Forecast of(const std::vector<StudyPlan>& plans) {
    for (std::size_t k = 0; k < plans.size(); ++k) add_study(plans, k);
    for (const StudyForecast& study : result_.studies) result_.core_seconds += study.seconds;
    result_.seconds = seconds_on(jobs_, loads_) + result_.timed_seconds;
    return result_;
  }

 private:
  std::optional<records::Record> stored(const Case& c) const {
    return store_ ? store_->find(c, digest_) : std::nullopt;
  }

  bool is_stored(const Case& c) const {
    const auto record = stored(c);
    return record && !records::is_worth_another_try(*record) && !timed_anew_.contains(c);
  }

  void add_study(const std::vector<StudyPlan>& plans, std::size_t k) {
    const StudyPlan& plan = plans[k];
    StudyForecast study{.study = plan.name, .why = {}};
    sources_ = {};
    longest_ = {};
    std::set<Case> cases;
    for (const Case& c : sweep_cases(plan))
      if (cases_.contains(c)) cases.insert(c);
    if (cases.empty() && !checks_.contains(k) && !limits_.contains(k)) return;
    study.cases = cases.size();
    for (const Case& c : cases) add_case(c, study);
    for (const LimitTask& limit : limits_[k]) add_scan(scan_cases(plans, limit), study);
    if (checks_.contains(k) && !stored_check(plan, stored_studies_)) add_check(study);
    study.why = why(plan, study);
    result_.studies.push_back(study);
  }

  void add_case(const Case& c, StudyForecast& study) {
    if (is_stored(c)) {
      ++study.stored;
    } else if (!run_.insert(c).second) {
      ++study.shared;
    } else {
      ++study.runs;
      if (settings::part_of(c)) ++study.parts;
      const double seconds = add_time(c, study);
      const bool is_timed = c.measure.repeat > 0;
      study.timed += is_timed ? 1 : 0;
      study.anew += timed_anew_.count(c);
      result_.timed_seconds += share_alone(c) * seconds;
      loads_.push_back({(1 - share_alone(c)) * seconds, !is_timed && can_be_shared(c)});
    }
  }

  void add_check(StudyForecast& study) {
    study.seconds += about_check;
    loads_.push_back({about_check, false});
  }

  /// The probes of a scan count as one load: what comes after them is not known yet. Several of its values may lead to
  /// the same run, which a sweep or another search may ask for, too.
  void add_scan(const std::vector<Case>& scan, StudyForecast& study) {
    double seconds = 0;
    for (const Case& c : scan) {
      if (is_stored(c) || !run_.insert(c).second) continue;
      ++study.probes;
      seconds += add_time(c, study);
    }
    loads_.push_back({seconds});
  }

  double add_time(const Case& c, StudyForecast& study) {
    const CostModel::Time time = costs_.time(c);
    ++sources_[static_cast<std::size_t>(time.source)];
    study.seconds += time.seconds;
    longest_ = std::max(longest_, {time.seconds, cases::method_of(c.scheme)[0], c.resolution.cells});
    return time.seconds;
  }

  std::string why(const StudyPlan& plan, const StudyForecast& study) const {
    std::vector<std::string> reasons;
    const auto add = [&reasons]<class... T>(bool is_so, const char* format, const T&... values) {
      if (is_so) reasons.push_back(fmt::format(fmt::runtime(format), values...));
    };
    if (!plan.check.empty())
      reasons.push_back(stored_check(plan, stored_studies_)
                            ? "its check is in the store"
                            : fmt::format("its check has no whole result of this program in the store, and counts {} s",
                                          about_check));
    const std::size_t all = study.runs + study.probes;
    add(all > study.anew, "{} not in the store for this program", all - study.anew);
    add(study.anew > 0, "{} in the store timed anew, in the same rounds as the others", study.anew);
    add(plan.check.empty() && all == 0, "all there");
    add(study.parts > 0, "{} on a part of the body that its images complete", study.parts);
    add(study.timed > 0, "{} timed, alone at the end", study.timed);
    add(all > 0, "longest {:.3g} s ({}, {} cells)", std::get<0>(longest_), std::get<1>(longest_),
        std::get<2>(longest_));
    add(all > 0, "times: {} known of the same case, {} of like cases, {} guessed", sources_[0], sources_[1],
        sources_[2]);
    return fmt::format("{}", fmt::join(reasons, "; "));
  }

  std::set<Case> cases_;  ///< of sweeps
  std::set<Case> timed_anew_;
  std::set<std::size_t> checks_;
  std::map<std::size_t, std::vector<LimitTask>> limits_;  ///< by study
  const store::Store* store_;
  const int jobs_;
  const CostModel& costs_;
  const std::string digest_ = store::current_provenance().digest;
  std::vector<records::StudyResult> stored_studies_;
  std::set<Case> run_;       ///< cases that some study so far runs, probes included
  std::vector<Load> loads_;  ///< those that run in parallel
  Forecast result_;
  std::array<std::size_t, 3> sources_{};               ///< of the present study's times
  std::tuple<double, std::string, int> longest_ = {};  ///< of its cases: seconds, basis or code, cells
};

}  // namespace

Forecast forecast(const std::vector<StudyPlan>& plans, const store::Store* store, int jobs) {
  return forecast(plans, work_of(plans), store, CostModel(store), jobs);
}

Forecast forecast(const std::vector<StudyPlan>& plans, const Work& work, const store::Store* store,
                  const CostModel& costs, int jobs) {
  return Forecaster(work, store, costs, jobs).of(plans);
}

double seconds_on(int jobs, std::vector<Load> loads) {
  std::ranges::sort(loads, std::greater{}, &Load::seconds);
  double all = 0, shared = 0;
  for (const Load& load : loads) all += load.seconds;
  std::vector<double> busy(static_cast<std::size_t>(jobs), 0.0);
  for (const auto& [seconds, can_be_shared] : loads)
    (can_be_shared && outlasts_others(seconds, all, jobs) ? shared : *std::ranges::min_element(busy)) += seconds;
  return shared / jobs + std::ranges::max(busy);
}

}  // namespace mpmvv::plan
