#include "tests/mutation/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "studies/support/error.hpp"
#include "tests/mutation/operators.hpp"

namespace mpmvv::mutation {

namespace {

Candidate candidate_of(const std::string& name, Mutant::Kind kind, const std::string& what, const Edit& edit,
                       const std::string& text, const std::string& gate) {
  const std::string mutated = edited(edit, text);
  return {{.name = name,
           .kind = kind,
           .what = what,
           .file = edit.file,
           .line = line_of(text, edit.at),
           .before = lines_at(text, edit.at, edit.before.size()),
           .after = lines_at(mutated, edit.at, edit.after.size()),
           .gate = gate},
          edit};
}

std::vector<Candidate> planted_candidates(const std::vector<Mistake>& mistakes, const ScratchTree& tree,
                                          const std::string& gate) {
  std::vector<Candidate> candidates;
  for (const Mistake& mistake : mistakes) {
    const std::string file = file_of(mistake, tree.files()), text = tree.text(file);
    candidates.push_back(
        candidate_of(mistake.name, Mutant::Kind::planted, mistake.what, edit_of(mistake, file, text), text, gate));
  }
  return candidates;
}

std::vector<Candidate> random_candidates(std::uint64_t seed, const ScratchTree& tree, const std::string& gate) {
  std::vector<Edit> edits;
  for (const std::string& file : mutated_files(tree.files()))
    for (Edit& edit : mutations_of(file, tree.text(file))) edits.push_back(std::move(edit));
  std::vector<Candidate> candidates;
  for (const Edit& edit : shuffled(std::move(edits), seed)) {
    candidates.push_back(candidate_of(fmt::format("random-{}", candidates.size() + 1), Mutant::Kind::random,
                                      fmt::format("'{}' becomes '{}'", edit.before, edit.after), edit,
                                      tree.text(edit.file), gate));
    candidates.back().mutant.seed = seed;
  }
  return candidates;
}

}  // namespace

CampaignPlan plan_of(const std::vector<Mistake>& mistakes, const Draw& draw, const ScratchTree& tree,
                     const std::string& gate) {
  return {planted_candidates(mistakes, tree, gate), random_candidates(draw.seed, tree, gate), draw.count};
}

void keep_named(CampaignPlan& plan, const std::vector<std::string>& names) {
  if (names.empty()) return;
  const auto is_named = [&](const Candidate& c) { return std::ranges::find(names, c.mutant.name) != names.end(); };
  for (const std::string& name : names) {
    const auto has_name = [&](const Candidate& c) { return c.mutant.name == name; };
    if (std::ranges::none_of(plan.planted, has_name) && std::ranges::none_of(plan.draws, has_name))
      throw support::UsageError(fmt::format("no mutant '{}' (see --list, or random-1, random-2, ...)", name));
  }
  std::erase_if(plan.planted, std::not_fn(is_named));
  std::erase_if(plan.draws, std::not_fn(is_named));
  plan.random = static_cast<int>(plan.draws.size());
}

}  // namespace mpmvv::mutation
