#include "goldens/gate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "goldens/judgement.hpp"
#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::goldens {

using records::Series;
using records::StudyResult;

namespace {

template <class Element, class Wanted, class Projection>
const Element* find(const std::vector<Element>& elements, const Wanted& wanted, Projection projection) {
  const auto found = std::ranges::find(elements, wanted, projection);
  return found == elements.end() ? nullptr : &*found;
}

Judgement judge(const ErrorGolden& golden, const Series& series) {
  if (const auto lack = lacking(series, golden.norm, golden.at)) return *lack;
  const double error = find_point(series, golden.at)->y.at(golden.norm);
  const std::string measured = fmt::format("{:.6g}", error);
  if (error > golden.expected * (1 + golden.band)) return fail(measured, "error larger than the golden's band");
  if (error < 0) return fail(measured, "below 0: of the other sign than the golden, so not better");
  if (error < golden.expected * (1 - golden.band))
    return fail_as_better(measured, "better than the golden: if that was meant, propose a new one");
  return pass(measured);
}

struct Band {
  double lower, upper;
  bool contains(double x) const { return lower <= x && x <= upper; }
};

std::string measured_text(const fits::StabilityLimit& limit, const fits::LimitRange& range) {
  if (range.is_open())
    return range.lower == 0 ? fmt::format("below {:.6g}", range.upper) : fmt::format("above {:.6g}", range.lower);
  return fmt::format("{:.6g} in [{:.6g}, {:.6g}]{}", limit.value(), range.lower, range.upper,
                     limit.monotone ? "" : ", not monotone");
}

/// Where one end of the limit alone is known, it may still lie wholly outside of the band.
Judgement judge(const LimitGolden& golden, const Series& series) {
  if (!series.limit) return missing(fmt::format("no limit of '{}'", golden.series));
  const fits::StabilityLimit& limit = *series.limit;
  const auto range = fits::range_of(limit);
  if (!range) return inconclusive("", "limit not found: " + text_without_limit(limit));
  const Band band{golden.expected * (1 - golden.band), golden.expected * (1 + golden.band)};
  const std::string measured = measured_text(limit, *range);
  if (range->upper < band.lower)
    return {Verdict::fail, measured, "limit below the golden's band", !range->stable_below};
  if (range->lower > band.upper) return {Verdict::fail, measured, "limit above the golden's band", range->stable_below};
  if (range->is_open()) return inconclusive(measured, "limit not found: " + text_without_limit(limit));
  if (range->upper - range->lower > band.upper - band.lower)
    return inconclusive(measured, "the bracket is wider than the band");
  if (!band.contains(limit.value())) return inconclusive(measured, "the bracket straddles the edge of the band");
  return pass(measured);
}

Judgement judge(const StatusGolden& golden, const Series& series) {
  const records::Point* point = find_point(series, golden.at);
  if (!point) return missing(fmt::format("no point of '{}' at {}", golden.series, golden.at));
  const std::string measured = status_text(*point);
  if (point->status == golden.expected) return pass(measured);
  return {Verdict::fail, measured, "another status than the golden's", point->status == records::Status::ok};
}

Judgement judge(const ValueGolden& golden, const StudyResult& study) {
  const records::Value* value = find(study.values, golden.name, &records::Value::name);
  if (!value) return missing(fmt::format("no value '{}'", golden.name));
  if (std::isnan(value->value)) return inconclusive("", "the value was not measured");
  const std::string measured = fmt::format("{:.6g}", value->value);
  if (std::isinf(value->value)) return fail(measured, "the value is infinite: the check has diverged");
  if (value->value > golden.upper) return fail(measured, "value above the golden's bound");
  if (value->value < golden.lower) return fail(measured, "value below the golden's bound");
  return pass(measured);
}

template <class OfSeries>
Judgement judge(const OfSeries& golden, const StudyResult& study) {
  const Series* series = find(study.series, golden.series, &Series::name);
  return series ? judge(golden, *series) : missing(fmt::format("no series '{}'", golden.series));
}

/// Results of a trial (`study --set`) and old ones are inconclusive, and a golden that nobody has reviewed cannot pass.
Judgement judge(const Golden& golden, const StudyResult& study, const GateScope& scope) {
  Judgement found = std::visit([&](const auto& expectation) { return judge(expectation, study); }, golden.expectation);
  const std::string trial = scope.trials == Trials::judged ? "" : store::trial_of(study.text);
  if (!trial.empty()) return inconclusive(found.measured, fmt::format("made with --set: {}", trial));
  if (const auto old = scope.outdated.find(study.name); old != scope.outdated.end())
    return inconclusive(found.measured, old->second);
  if (found.verdict == Verdict::pass && !golden.reviewed)
    return inconclusive(found.measured, "not reviewed: its file has no reviewed = \"DATE: who and on what grounds\"");
  return found;
}

GateResult judge(const Golden& golden, const std::vector<StudyResult>& studies, const GateScope& scope) {
  const StudyResult* study = find(studies, golden.study, &StudyResult::name);
  Judgement judgement =
      study ? judge(golden, *study, scope) : missing(fmt::format("no study '{}' in the store", golden.study));
  return {golden.study,
          subject(golden),
          judgement.verdict,
          expected_text(golden),
          std::move(judgement.measured),
          std::move(judgement.reason),
          golden.where,
          judgement.better,
          study == nullptr,
          std::move(judgement.cause)};
}

}  // namespace

std::string measured_text(const GateResult& result) {
  if (!result.measured.empty()) return ", measured " + result.measured;
  return result.verdict == Verdict::fail ? ", not measured" : "";
}

int GateReport::count(Verdict v) const {
  return static_cast<int>(std::ranges::count(results, v, &GateResult::verdict));
}

int GateReport::exit_code() const {
  if (count(Verdict::fail) > 0) return 1;
  return count(Verdict::inconclusive) > 0 ? 3 : 0;
}

GateReport run_gate(const std::vector<Golden>& goldens, const std::vector<StudyResult>& studies,
                    const GateScope& scope) {
  if (goldens.empty()) throw support::UsageError("no golden to judge (at least one)");
  std::set<std::string> known;
  for (const Golden& golden : goldens) known.insert(golden.study);
  for (const std::string& study : scope.only)
    if (!known.contains(study))
      throw support::UsageError(fmt::format("unknown study '{}' in the goldens (known: {})", study,
                                            support::listed({known.begin(), known.end()})));
  GateReport report;
  for (const Golden& golden : goldens) {
    if (scope.only.empty() || std::ranges::count(scope.only, golden.study) > 0)
      report.results.push_back(judge(golden, studies, scope));
  }
  return report;
}

}  // namespace mpmvv::goldens
