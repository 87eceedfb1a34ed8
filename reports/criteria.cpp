#include "reports/criteria.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "reports/criterion_bar.hpp"
#include "reports/mutation_claim.hpp"
#include "reports/text.hpp"
#include "studies/claims/found_text.hpp"

namespace mpmvv::reports {

using records::ClaimPart;
using records::Found;
using records::PartVerdict;

namespace {

using namespace template_data;

bool is_of_times(const ClaimPart& part) {
  return part.measure == "cost-ratio" || part.measure.starts_with("slope-");
}

/// How far inside its bounds a number lies, relative to the bound; negative beyond one. Where an interval leaves the
/// verdict open, this is measured from the end of the interval that lies nearest to a bound or farthest beyond it.
double margin(const ClaimPart& part, const Found& found) {
  const bool is_open = part.verdict == PartVerdict::inconclusive;
  const auto [lower, upper] = is_open ? std::pair{found.lower, found.upper} : std::pair{found.value, found.value};
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](std::optional<double> bound, double inside) {
    if (bound) least = std::min(least, inside / std::max(std::abs(*bound), 1e-12));
  };
  consider(part.at_least, lower - part.at_least.value_or(0));
  consider(part.at_most, part.at_most.value_or(0) - upper);
  return least;
}

std::string found_text(const ClaimPart& part, double value) {
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  return told_from_bounds(part, value);
}

/// The number nearest to a bound or farthest beyond it. The criterion must have compared one.
const Found& deciding_number(const ClaimPart& part) {
  return *std::ranges::min_element(part.found, {}, [&](const Found& found) { return margin(part, found); });
}

/// What might decide, where the interval of a number reaches across a bound.
std::string remedy(const ClaimPart& part, const Found& found) {
  const bool is_open = found.lower < found.upper && (found.lower == found.value || found.upper == found.value);
  if (part.is_limit() && found.remark.find(" steps at ") != std::string::npos)
    return "Longer runs (end_time) might decide: so few steps do not count.";
  if (part.is_limit())
    return is_open ? "A search beyond the values tried might decide." : "A finer search might decide.";
  if (is_of_times(part)) return "More rounds in one session might decide.";
  return fmt::format("Other {} might lie on its other side.", part.is_order() ? "points" : "replicates");
}

/// What was compared without what the row above says as well: "at cfl = 0.2" below "l2 of 'a' at cfl = 0.1".
std::string beyond(const std::string& above, const std::string& what) {
  const auto at = what.rfind(" at ");
  const bool has_place = at != std::string::npos && what.find(" = ", at) != std::string::npos;
  return has_place && above.starts_with(what.substr(0, at + 4)) ? what.substr(at + 1) : what;
}

data found_data(const ClaimPart& part, const Found& found, const std::string& above) {
  return object({{"what", beyond(above, found.what)},
                 {"asked", asked_text(part)},
                 {"value", found_text(part, found.value) + claims::interval_text(part, found)},
                 {"remark", found.remark},
                 {"has_remark", !found.remark.empty()},
                 {"bar", criterion_bar(part, found)}});
}

data part_data(const claims::JudgedPart& line) {
  const ClaimPart& part = line.part;
  std::string above;
  const auto found = [&](const Found& f) { return found_data(part, f, std::exchange(above, f.what)); };
  return object({{"study", line.study},
                 {"statement", part.statement},
                 {"verdict", to_string(part.verdict)},
                 {"evidence", part.evidence},
                 {"has_evidence", part.found.empty()},
                 {"is_awaited", part.measure == "awaited"},
                 {"undecided", undecided_text(part)},
                 {"is_undecided", !part.found.empty() && part.verdict == PartVerdict::inconclusive},
                 {"found", list_of(part.found, found)},
                 {"reason", part.reason},
                 {"has_reason", !part.reason.empty()}});
}

std::size_t count(const claims::Claim& claim, PartVerdict verdict) {
  return static_cast<std::size_t>(
      std::ranges::count_if(claim.parts, [&](const auto& line) { return line.part.verdict == verdict; }));
}

bool reaches_across_a_bound(const ClaimPart& part, const Found& found) {
  const auto holds = [&](const std::optional<double>& bound) {
    return bound && found.lower < *bound && *bound < found.upper;
  };
  return holds(part.at_least) || holds(part.at_most);
}

/// Whether the criterion's verdict hangs on a number: an interval that reaches across a bound leaves it open, a series
/// that could not be run, or a trial, is no number's doing.
bool hangs_on_a_number(const ClaimPart& part) {
  if (part.found.empty() || !part.withheld.empty()) return false;
  return part.verdict != PartVerdict::inconclusive || reaches_across_a_bound(part, deciding_number(part));
}

/// "; study w-fig3" behind what one of several studies says; else empty.
std::string study_text(const claims::Claim& claim, const claims::JudgedPart& line) {
  const bool is_only = std::ranges::all_of(claim.parts, [&](const auto& other) { return other.study == line.study; });
  return is_only ? "" : "; study " + line.study;
}

/// The first criterion of a verdict that hangs on no number.
std::string without_number(const claims::Claim& claim, PartVerdict verdict) {
  const auto line = std::ranges::find(claim.parts, verdict, [](const auto& l) { return l.part.verdict; });
  const bool says_more = line != claim.parts.end() && verdict != PartVerdict::holds;
  return says_more ? fmt::format("{}: {}{}", line->part.statement, to_string(verdict), study_text(claim, *line)) : "";
}

/// By what the criteria of a verdict are ordered, the deciding one first: how far its number lies inside its bounds. A
/// number on its bound, as a share of 1 or a count, is last: most often it can lie nowhere else.
std::pair<bool, double> rank(const ClaimPart& part) {
  const double inside = margin(part, deciding_number(part));
  return {inside == 0, inside};
}

}  // namespace

std::string asked_text(const ClaimPart& part) {
  if (part.measure == "awaited") return "awaited";
  return claims::bounds_text(part);
}

std::string told_from_bounds(const ClaimPart& part, double value) {
  return std::isnan(value) ? brief(value) : claims::told_from_bounds(part, value);
}

/// An older store has no intervals, so the evidence has to do.
std::string undecided_text(const ClaimPart& part) {
  if (!part.withheld.empty()) return part.withheld;
  if (part.found.empty() || part.evidence.find("an interval reaches across") == std::string::npos) return part.evidence;
  const Found& found = deciding_number(part);
  if (!claims::has_interval(found)) return part.evidence;
  return fmt::format("An interval reaches across a bound: {} = {}{}. {}", found.what, found_text(part, found.value),
                     claims::interval_and_remark(part, found), remedy(part, found));
}

std::string deciding_text(const claims::Claim& claim) {
  using enum PartVerdict;
  const PartVerdict decisive = count(claim, fails) > 0 ? fails : count(claim, inconclusive) > 0 ? inconclusive : holds;
  const claims::JudgedPart* deciding = nullptr;
  for (const claims::JudgedPart& line : claim.parts)
    if (line.part.verdict == decisive && hangs_on_a_number(line.part))
      if (deciding == nullptr || rank(line.part) < rank(deciding->part)) deciding = &line;
  if (deciding == nullptr) return without_number(claim, decisive);
  const ClaimPart& part = deciding->part;
  const Found& found = deciding_number(part);
  const std::string subject = part.measure == "value" ? part.statement + ": " : "";
  return fmt::format("{}{}: {}{} (asked: {}{}{})", subject, found.what, found_text(part, found.value),
                     claims::interval_and_remark(part, found), asked_text(part),
                     decisive == inconclusive ? "; inconclusive" : "", study_text(claim, *deciding));
}

namespace {

/// How many criteria were asked, or had their bounds set, when their numbers were known: their statements say so.
std::string late_text(const claims::Claim& claim) {
  const auto is_judged = [](const auto& line) { return line.part.verdict != PartVerdict::shown; };
  const auto is_late = [&](const auto& line) {
    return is_judged(line) && line.part.statement.ends_with(" after a run)");
  };
  const auto judged = std::ranges::count_if(claim.parts, is_judged), late = std::ranges::count_if(claim.parts, is_late);
  if (late == 0) return "";
  return late < judged ? fmt::format("; {} of them set after a run", late)
                       : fmt::format(", {}set after a run", judged > 1 ? "all " : "");
}

std::string criteria_text(const claims::Claim& claim) {
  if (claim.parts.empty())
    return claim.id == mutants_claim ? "not judged yet for this version of the program" : "not judged yet";
  const std::size_t shown = count(claim, PartVerdict::shown), judged = claim.parts.size() - shown;
  if (judged == 0) return "shown in figures";
  const std::size_t holding = count(claim, PartVerdict::holds), undecided = count(claim, PartVerdict::inconclusive);
  const std::string late = late_text(claim);
  if (judged == 1)
    return (holding == 1     ? "its criterion holds"
            : undecided == 1 ? "its criterion is inconclusive"
                             : "its criterion does not hold") +
           late;
  const std::string rest = undecided > 0 ? fmt::format(", {} inconclusive", undecided) : "";
  return fmt::format("{} of {} criteria hold{}{}", holding, judged, rest, late);
}

}  // namespace

std::string count_text(const claims::Claim& claim) {
  if (claim.not_run.empty()) return criteria_text(claim);
  return fmt::format("{}; {} of its {} studies {} not run", criteria_text(claim), claim.not_run.size(),
                     claim.studies.size() + claim.not_run.size(), claim.not_run.size() == 1 ? "was" : "were");
}

data criteria_data(const std::vector<claims::JudgedPart>& parts) {
  return list_of(parts, part_data);
}

}  // namespace mpmvv::reports
