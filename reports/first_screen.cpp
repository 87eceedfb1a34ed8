#include "reports/first_screen.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "reports/mutation_claim.hpp"
#include "reports/page_frame.hpp"
#include "reports/text.hpp"
#include "reports/verdicts.hpp"
#include "studies/claims/finding.hpp"
#include "studies/fits/median.hpp"
#include "studies/store/trial.hpp"

namespace mpmvv::reports {

using namespace template_data;
using records::Verdict;

namespace {

struct Tile {
  std::string label, address;
  std::string number, verdict;  ///< the verdict colours the number; may be empty
  std::string detail, change;
  bool is_time = false;  ///< the number is a time, of which the page says how long ago it was
};

data tile_data(const Tile& tile) {
  return object({{"label", tile.label},
                 {"address", tile.address},
                 {"number", tile.number},
                 {"verdict", tile.verdict},
                 {"detail", tile.detail},
                 {"change", tile.change},
                 {"has_change", !tile.change.empty()},
                 {"is_time", tile.is_time}});
}

/// What changed, of all that could be compared.
std::string change_text(const std::vector<std::string>& changes, std::size_t compared, std::size_t all,
                        const char* why_none) {
  if (compared == 0) return all == 0 ? "" : fmt::format("not comparable, as {}", why_none);
  const std::string text = changes.empty() ? "as before" : fmt::format("{}", fmt::join(changes, "; "));
  return compared < all ? fmt::format("{} ({} of {} compared)", text, compared, all) : text;
}

Tile gate_tile(const ReportInput& input) {
  const GateSplit split = gate_split(input);
  const auto& lines = split.judged;
  Tile tile{"Gate", "gate.html", gate_text(split), gate_word(split), "", ""};
  tile.detail = lines.empty() ? "no golden of these studies" : fmt::format("goldens: {}", gate_counts(lines));
  if (!input.earlier) return tile;
  std::vector<std::string> changes;
  for (const auto& [step, count] : input.earlier->gate_change)
    changes.push_back(
        fmt::format("{} {}, {} {}", count, to_string(step.second), count == 1 ? "was" : "were", to_string(step.first)));
  tile.change = change_text(changes, input.earlier->goldens_compared, lines.size(), "no study with goldens is in both");
  return tile;
}

std::string confirmed_text(const std::vector<claims::Claim>& claims) {
  const auto confirmed = std::ranges::count(claims, claims::Claim::Verdict::confirmed, &claims::Claim::verdict);
  return fmt::format("{} of {}", confirmed, claims.size());
}

Tile claims_tile(const ReportInput& input) {
  const auto& claims = input.claims;
  if (claims.empty()) return {"Claims", "#studies", "none", "", "no study names a claim", ""};
  Tile tile{"Claims", "#claims", confirmed_text(claims), "", claim_counts(claims), ""};
  std::vector<claims::Claim> own, of_papers;
  std::ranges::partition_copy(claims, std::back_inserter(own), std::back_inserter(of_papers), is_own);
  if (!own.empty() && !of_papers.empty()) {
    tile.number = confirmed_text(of_papers);
    tile.detail = fmt::format("claims of the papers are confirmed, {} of our own; all together: {}",
                              confirmed_text(own), claim_counts(claims));
  }
  if (!input.earlier) return tile;
  std::vector<std::string> changes;
  std::size_t compared = 0, judged = 0;
  for (const claims::Claim& claim : claims) {
    if (claim.studies.empty() || claim.id == mutants_claim) continue;
    ++judged;
    const auto then = input.earlier->claims.find(claim.id);
    if (then == input.earlier->claims.end()) continue;
    ++compared;
    if (then->second != claim.verdict)
      changes.push_back(fmt::format("{}: {}, was {}", claim.id, to_string(claim.verdict), to_string(then->second)));
  }
  tile.change = change_text(changes, compared, judged, "none is judged by the same studies in both");
  return tile;
}

/// ns per particle and step of each series that was timed alone, at its finest level; neither of trials nor of other
/// codes.
std::vector<double> costs_of(const ReportInput& input) {
  std::vector<double> costs;
  for (records::StudyResult study : input.studies) {
    if (!store::trial_of(study.text).empty()) continue;
    std::erase_if(study.series, records::is_of_another_code);
    for (const claims::Finding& finding : claims::findings_of(study))
      if (finding.kind == claims::Finding::Kind::cost && std::isfinite(finding.number)) costs.push_back(finding.number);
  }
  std::ranges::sort(costs);
  return costs;
}

/// The middle half of the ratios. One number would read as a regression, although two nights of one program may differ
/// as much.
std::string cost_change(std::vector<double> ratios) {
  std::ranges::sort(ratios);
  const std::size_t quarter = ratios.size() / 4;
  return fmt::format("{:.2f} to {:.2f} times what it was ({}{} series; another night alone makes up to 1.3)",
                     ratios[quarter], ratios[ratios.size() - 1 - quarter], quarter > 0 ? "middle half of " : "",
                     ratios.size());
}

Tile cost_tile(const ReportInput& input) {
  const auto costs = costs_of(input);
  Tile tile{"Cost", input.benchmark ? "benchmark.html" : "#studies", "not measured", "", "", ""};
  if (costs.empty()) {
    tile.detail = "no study here was timed alone (repeat = 3 or more)";
    return tile;
  }
  tile.number = three_digits(fits::median_of(costs)) + " ns";
  tile.detail = fmt::format("per particle and step: median of {} timed series, {} to {} ns", costs.size(),
                            three_digits(costs.front()), three_digits(costs.back()));
  if (input.earlier && !input.earlier->cost_ratios.empty()) tile.change = cost_change(input.earlier->cost_ratios);
  return tile;
}

Tile age_tile(const ReportInput& input) {
  const auto origins = origins_of(input.provenances);
  const std::string time = origins.empty() ? "" : origins.front().provenance.time;
  Tile tile{"Newest result", "#provenance", time, "", "", "", true};
  tile.detail = fmt::format("of {}, version {}", studies_text(input.studies.size()), versions_text(origins));
  if (input.earlier)
    tile.change = fmt::format("{} of {} results differ from {}", input.earlier->changes.differ.size(),
                              input.earlier->changes.compared, input.earlier->label);
  return tile;
}

}  // namespace

data first_screen(const ReportInput& input) {
  return list_of(std::vector{gate_tile(input), claims_tile(input), cost_tile(input), age_tile(input)}, tile_data);
}

}  // namespace mpmvv::reports
