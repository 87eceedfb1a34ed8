#include "tests/mutation/campaign.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>
#include <span>
#include <utility>

#include "studies/support/error.hpp"

namespace mpmvv::mutation {

using support::UsageError;

namespace {

using std::chrono::seconds;

class Campaign {
 public:
  Campaign(const CampaignPlan& plan, const std::string& gate, Bench& bench, const CampaignStore& store)
      : plan_(plan), bench_(bench), store_(store) {
    baseline_.name = "baseline";
    baseline_.kind = Mutant::Kind::baseline;
    baseline_.gate = gate;
    if (const auto known = store_.find(baseline_)) baseline_.trials = known->trials;
    // A stage that the tree without a mistake did not pass is tried again.
    std::erase_if(baseline_.trials, [](const Trial& trial) { return trial.caught; });
  }

  std::vector<Mutant> run() {
    for (const Candidate& candidate : plan_.planted) {
      progress_ = fmt::format("{}/{} ", results_.size() + 1, plan_.planted.size());
      try_through(begin(candidate), candidate.edit, {GateStage::unit_tests, GateStage::quick}, false);
    }
    draw();
    for (std::size_t k = 0; k < results_.size(); ++k) {
      progress_ = "";
      if (!results_[k].caught() && results_[k].reason.empty())
        try_through(results_[k], *edits_[k], {GateStage::nightly}, false);
    }
    if (!baseline_.trials.empty()) results_.insert(results_.begin(), baseline_);
    return std::move(results_);
  }

 private:
  /// The result so far of a candidate, which is added to those of the campaign.
  Mutant& begin(const Candidate& candidate) {
    edits_.push_back(&candidate.edit);
    Mutant& mutant = results_.emplace_back(store_.find(candidate.mutant).value_or(candidate.mutant));
    mutant.reason = candidate.mutant.reason;
    return mutant;
  }

  void draw() {
    int drawn = 0;
    for (const Candidate& candidate : plan_.draws) {
      if (drawn == plan_.random) return;
      progress_ = fmt::format("{}/{} ", drawn + 1, plan_.random);
      Mutant& mutant = begin(candidate);
      try_through(mutant, candidate.edit, {GateStage::quick, GateStage::unit_tests}, true);
      drawn += mutant.builds ? 1 : 0;
    }
  }

  /// Takes a mutant through the stages that it has not met, in this order; where one catch is enough, only until it is
  /// caught.
  void try_through(Mutant& mutant, const Edit& edit, std::initializer_list<GateStage> stages, bool one_is_enough) {
    const auto is_done = [&] { return !mutant.builds || (one_is_enough && mutant.caught()); };
    for (const GateStage stage : stages)
      if (!is_done() && !mutant.trial(stage)) limit_of(stage);  // may build without the edit, so it comes first
    for (const GateStage stage : stages)
      if (!is_done() && !mutant.trial(stage)) meet(mutant, &edit, stage, limit_of(stage));
  }

  void meet(Mutant& mutant, const Edit* edit, GateStage stage, seconds limit) {
    const auto start = std::chrono::steady_clock::now();
    mutant.gate = baseline_.gate;
    mutant.builds = bench_.build(edit);
    const double build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (mutant.builds) mutant.trials.push_back(bench_.meet(stage, limit));
    store_.keep(mutant);
    store_.tell(line(mutant, build_seconds));
  }

  std::string line(const Mutant& mutant, double build_seconds) const {
    const std::string place = mutant.file.empty() ? "" : fmt::format(" ({}:{})", mutant.file, mutant.line);
    const std::string start = progress_ + mutant.name + place;
    if (!mutant.builds) return start + ": does not compile";
    const Trial& trial = mutant.trials.back();
    const std::string more = trial.by.size() > 1 ? fmt::format(" and {} more", trial.by.size() - 1) : "";
    const std::string by = trial.caught ? fmt::format("caught by {}{}", trial.by.front(), more) : "passes";
    return fmt::format("{}: built in {:.0f} s, {} in {:.0f} s: {}", start, build_seconds, to_string(trial.stage),
                       trial.seconds, by);
  }

  /// The time limit of a stage: several times what the tree without a mistake takes, which therefore meets the stage
  /// first.
  seconds limit_of(GateStage stage) {
    if (!baseline_.trial(stage)) {
      meet(baseline_, nullptr, stage, std::chrono::hours(12));
      if (!baseline_.builds)
        throw support::UsageError(fmt::format("the tree does not build (one that does): {}", bench_.complaint()));
    }
    const Trial& trial = *baseline_.trial(stage);
    if (trial.caught)
      throw support::UsageError(fmt::format("the tree does not pass its {}: {} (one that does)", to_string(stage),
                                            fmt::join(trial.by, ", ")));
    return seconds(std::lround(120 + 5 * trial.seconds));
  }

  const CampaignPlan& plan_;
  Bench& bench_;
  const CampaignStore& store_;
  Mutant baseline_;
  std::vector<Mutant> results_;
  std::vector<const Edit*> edits_;  ///< of the results
  std::string progress_;
};

std::string sources_of(const std::string& gate) {
  return gate.substr(0, gate.find('/'));
}

}  // namespace

std::optional<Mutant> known_result(const std::vector<Mutant>& kept, const Mutant& wanted) {
  if (const Mutant* same = find_mutant(kept, wanted)) return *same;
  for (const Mutant& earlier : kept | std::views::reverse) {
    Mutant moved = earlier;
    moved.gate = wanted.gate;
    if (sources_of(earlier.gate) != sources_of(wanted.gate) || !find_mutant({moved}, wanted)) continue;
    moved.gate = earlier.gate;
    std::erase_if(moved.trials, [](const Trial& trial) { return !trial.caught; });
    return moved;
  }
  return std::nullopt;
}

std::vector<Edit> edits_to_try(const CampaignPlan& plan,
                               const std::function<std::optional<Mutant>(const Mutant&)>& find) {
  std::vector<Edit> edits;
  const auto add = [&](const Candidate& candidate, bool one_is_enough) {
    const Mutant known = find(candidate.mutant).value_or(candidate.mutant);
    const bool met_both = known.trial(GateStage::unit_tests) && known.trial(GateStage::quick);
    if (known.builds && !met_both && !(one_is_enough && known.caught())) edits.push_back(candidate.edit);
  };
  for (const Candidate& candidate : plan.planted) add(candidate, false);
  const auto draws = std::min(plan.draws.size(), static_cast<std::size_t>(plan.random));
  for (const Candidate& candidate : std::span(plan.draws).first(draws)) add(candidate, true);
  return edits;
}

std::vector<Mutant> run_campaign(const CampaignPlan& plan, const std::string& gate, Bench& bench,
                                 const CampaignStore& store) {
  return Campaign(plan, gate, bench, store).run();
}

}  // namespace mpmvv::mutation
