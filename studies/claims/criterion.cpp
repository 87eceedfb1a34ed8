#include "studies/claims/criterion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "studies/claims/found_text.hpp"
#include "studies/claims/measured.hpp"

namespace mpmvv::claims {

using records::Found;
using records::PartVerdict;

namespace {

/// Whether the whole interval is inside the bounds, wholly outside, or reaches across one of them.
PartVerdict verdict_on(const Criterion& c, const Found& found) {
  if ((c.at_least && found.upper < *c.at_least) || (c.at_most && found.lower > *c.at_most)) return PartVerdict::fails;
  const bool inside = (!c.at_least || found.lower >= *c.at_least) && (!c.at_most || found.upper <= *c.at_most);
  return inside ? PartVerdict::holds : PartVerdict::inconclusive;
}

std::string measured_text(const records::ClaimPart& part, const Found& found) {
  const std::string text = std::isnan(found.value) ? " is not known" : " = " + told_from_bounds(part, found.value);
  return found.what + text + interval_and_remark(part, found);
}

/// What was found; of a part that fails without the numbers that decided nothing, and with what is missing in their
/// place.
std::vector<Found> found_of(const Measured& measured, PartVerdict verdict) {
  const bool fails = verdict == PartVerdict::fails;
  std::vector<Found> found;
  for (const Measured::Number& number : measured.numbers)
    if (!fails || (number.is_sure && !std::isnan(number.found.value))) found.push_back(number.found);
  if (fails && !measured.missing.empty()) found.push_back({measured.missing, support::not_measured});
  return found;
}

}  // namespace

/// Each number is held against the bounds together with its interval. The interval can only withhold a verdict, never
/// make one: residuals of a deterministic method are bias, so an interval that contains the claimed order is no
/// evidence for it, but one that reaches across a bound shows that other points might lie on the other side. A number
/// that fails decides even where others are missing.
records::ClaimPart judge(const Criterion& criterion, const records::StudyResult& result) {
  records::ClaimPart part{criterion.claim, criterion.statement, PartVerdict::shown, "", ""};
  part.measure = support::to_string(criterion.kind), part.at_least = criterion.at_least,
  part.at_most = criterion.at_most;
  if (criterion.kind == Criterion::Kind::shown) {
    part.evidence = "shown in the figure";
    return part;
  }
  if (criterion.kind == Criterion::Kind::awaited) {
    part.verdict = PartVerdict::inconclusive;
    part.evidence = criterion.reason.empty() ? "no study judges it" : criterion.reason;
    return part;
  }
  part.verdict = PartVerdict::inconclusive;
  const Measured measured = measure(criterion, result);
  std::vector<std::string> texts;
  bool all_hold = true, one_fails = false, all_known = measured.missing.empty() && !measured.numbers.empty();
  for (const Measured::Number& number : measured.numbers) {
    texts.push_back(measured_text(part, number.found));
    const PartVerdict verdict = verdict_on(criterion, number.found);
    all_hold = all_hold && verdict == PartVerdict::holds;
    one_fails = one_fails || (number.is_sure && verdict == PartVerdict::fails);
    all_known = all_known && !std::isnan(number.found.value);
  }
  if (!measured.missing.empty()) texts.push_back(measured.missing);
  if (one_fails || (all_known && all_hold)) part.verdict = one_fails ? PartVerdict::fails : PartVerdict::holds;
  const bool reaches_across = all_known && part.verdict == PartVerdict::inconclusive;
  part.evidence = fmt::format("{} (asked: {}{})", fmt::join(texts, "; "), bounds_text(part),
                              reaches_across ? ", but an interval reaches across" : "");
  part.found = found_of(measured, part.verdict);
  if (part.verdict == PartVerdict::fails) part.reason = criterion.reason;
  return part;
}

}  // namespace mpmvv::claims
