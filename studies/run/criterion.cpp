#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "studies/run/measured.hpp"

namespace mpmvv {

namespace {

std::string bounds_text(const Criterion& c) {
  if (c.at_least && c.at_most) return fmt::format("asked: {} to {}", *c.at_least, *c.at_most);
  return c.at_least ? fmt::format("asked: at least {}", *c.at_least) : fmt::format("asked: at most {}", *c.at_most);
}

bool holds(const Criterion& c, double value) {
  return (!c.at_least || value >= *c.at_least) && (!c.at_most || value <= *c.at_most);
}

}  // namespace

ClaimPart judge(const Criterion& criterion, const StudyResult& result) {
  ClaimPart part{criterion.claim, criterion.statement, PartVerdict::shown, "", ""};
  if (criterion.kind == Criterion::Kind::shown) {
    part.evidence = "shown in the figure";
    return part;
  }
  if (criterion.kind == Criterion::Kind::awaited) {
    part.verdict = PartVerdict::inconclusive;
    part.evidence = "not run yet";
    return part;
  }
  const Measured measured = measure(criterion, result);
  std::vector<std::string> texts;
  bool all_hold = true, all_known = measured.missing.empty() && !measured.numbers.empty();
  for (const auto& [label, value, words] : measured.numbers) {
    texts.push_back(words.empty() ? fmt::format("{} = {:.4g}", label, value) : fmt::format("{}: {}", label, words));
    all_hold = all_hold && holds(criterion, value);
    all_known = all_known && !std::isnan(value);
  }
  if (!measured.missing.empty()) texts.push_back(measured.missing);
  part.evidence = fmt::format("{} ({})", fmt::join(texts, "; "), bounds_text(criterion));
  part.verdict = !all_known ? PartVerdict::inconclusive : all_hold ? PartVerdict::holds : PartVerdict::fails;
  if (part.verdict == PartVerdict::fails) part.reason = criterion.reason;
  return part;
}

}  // namespace mpmvv
