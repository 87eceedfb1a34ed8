#include "reports/criteria.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reports/criterion_bar.hpp"
#include "reports/text.hpp"

namespace mpmvv::reports {

using records::ClaimPart;
using records::Found;
using records::PartVerdict;

namespace {

using namespace template_data;

/// Half of the interval of a number that was found, "0.74", as the evidence says it; empty without an interval.
std::string half_width_of(const ClaimPart& part, const Found& found) {
  const std::string start = found.what + " (±";
  const auto at = part.evidence.find(start);
  if (at == std::string::npos) return "";
  const auto from = at + start.size();
  return part.evidence.substr(from, part.evidence.find(')', from) - from);
}

double reach_of(const ClaimPart& part, const Found& found) {
  const std::string half = half_width_of(part, found);
  return half.empty() ? 0 : std::stod(half);
}

/// How far inside its bounds a number lies, relative to the bound; negative beyond one. Where an interval leaves the
/// verdict open, this is measured from the end of the interval that lies nearest to a bound or farthest beyond it.
double margin(const ClaimPart& part, const Found& found) {
  const double reach = part.verdict == PartVerdict::inconclusive ? reach_of(part, found) : 0;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](std::optional<double> bound, double inside) {
    if (bound) least = std::min(least, inside / std::max(std::abs(*bound), 1e-12));
  };
  consider(part.at_least, found.value - reach - part.at_least.value_or(0));
  consider(part.at_most, part.at_most.value_or(0) - found.value - reach);
  return least;
}

std::string found_text(double value) {
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  return brief(value);
}

/// The number nearest to a bound or farthest beyond it. The criterion must have compared one.
const Found& deciding_number(const ClaimPart& part) {
  return *std::ranges::min_element(part.found, {}, [&](const Found& found) { return margin(part, found); });
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
                 {"value", found_text(found.value) + interval_text(part, found)},
                 {"bar", criterion_bar(part, found.value, reach_of(part, found))}});
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
                 {"undecided", undecided_text(part)},
                 {"is_undecided", !part.found.empty() && part.verdict == PartVerdict::inconclusive},
                 {"asked", asked_text(part)},
                 {"found", list_of(part.found, found)},
                 {"reason", part.reason},
                 {"has_reason", !part.reason.empty()}});
}

std::size_t count(const claims::Claim& claim, PartVerdict verdict) {
  return static_cast<std::size_t>(
      std::ranges::count_if(claim.parts, [&](const auto& line) { return line.part.verdict == verdict; }));
}

}  // namespace

std::string asked_text(const ClaimPart& part) {
  if (part.at_least && part.at_least == part.at_most) return brief(*part.at_least);
  if (part.at_least && part.at_most) return fmt::format("{} to {}", brief(*part.at_least), brief(*part.at_most));
  if (part.at_least) return "at least " + brief(*part.at_least);
  return part.at_most ? "at most " + brief(*part.at_most) : "";
}

std::string interval_text(const ClaimPart& part, const Found& found) {
  const auto is_said_to_be = [&](const char* where) {
    return part.evidence.find(fmt::format("{}: {}", found.what, where)) != std::string::npos;
  };
  if (is_said_to_be("below ")) return " or less";
  if (is_said_to_be("above ")) return " or more";
  const std::string half = half_width_of(part, found);
  return half.empty() ? "" : " ± " + half;
}

std::string undecided_text(const ClaimPart& part) {
  if (part.found.empty() || part.evidence.find("an interval reaches across") == std::string::npos) return part.evidence;
  const Found& found = deciding_number(part);
  return fmt::format("An interval reaches across a bound: {} = {}{}. Other points might lie on its other side.",
                     found.what, found_text(found.value), interval_text(part, found));
}

std::string deciding_text(const claims::Claim& claim) {
  using enum PartVerdict;
  const PartVerdict decisive = count(claim, fails) > 0 ? fails : count(claim, inconclusive) > 0 ? inconclusive : holds;
  const ClaimPart* deciding = nullptr;
  const auto margin_of = [](const ClaimPart& part) { return margin(part, deciding_number(part)); };
  for (const auto& [study, part] : claim.parts)
    if (part.verdict == decisive && !part.found.empty())
      if (deciding == nullptr || margin_of(part) < margin_of(*deciding)) deciding = &part;
  if (deciding == nullptr) return "";
  const Found& found = deciding_number(*deciding);
  return fmt::format("{}: {}{} (asked: {}{})", found.what, found_text(found.value), interval_text(*deciding, found),
                     asked_text(*deciding), decisive == inconclusive ? "; inconclusive" : "");
}

std::string count_text(const claims::Claim& claim) {
  if (claim.parts.empty()) return "not judged yet";
  const std::size_t shown = count(claim, PartVerdict::shown), judged = claim.parts.size() - shown;
  if (judged == 0) return "shown in figures";
  const std::size_t holding = count(claim, PartVerdict::holds), undecided = count(claim, PartVerdict::inconclusive);
  if (judged == 1)
    return holding == 1     ? "its criterion holds"
           : undecided == 1 ? "its criterion is inconclusive"
                            : "its criterion does not hold";
  const std::string rest = undecided > 0 ? fmt::format(", {} inconclusive", undecided) : "";
  return fmt::format("{} of {} criteria hold{}", holding, judged, rest);
}

data criteria_data(const std::vector<claims::JudgedPart>& parts) {
  return list_of(parts, part_data);
}

}  // namespace mpmvv::reports
