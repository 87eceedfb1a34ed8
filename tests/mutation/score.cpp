#include "tests/mutation/score.hpp"

namespace mpmvv::mutation {

namespace {

void count(Catches& catches, const Mutant& mutant) {
  catches.unit_tests += mutant.caught_by(GateStage::unit_tests);
  catches.quick += mutant.caught_by(GateStage::quick);
  catches.nightly += mutant.caught_by(GateStage::nightly);
  catches.any += mutant.caught();
}

void count_planted(Score& score, const Mutant& mutant) {
  if (!mutant.reason.empty()) {
    ++score.equivalent;
    return;
  }
  ++score.planted;
  count(score.planted_catches, mutant);
  score.untried += mutant.builds && mutant.trials.empty();
  score.open += mutant.open();
  if (!mutant.caught() && !mutant.open()) score.missed.push_back(mutant.name);
}

void count_random(Score& score, const Mutant& mutant) {
  if (!mutant.builds) return;
  ++score.random;
  count(score.random_catches, mutant);
  if (mutant.caught()) return;
  if (!mutant.reason.empty())
    ++score.random_explained;
  else if (!mutant.open())
    score.unexplained.push_back(mutant.name);
}

}  // namespace

Score score_of(const std::vector<Mutant>& mutants) {
  Score score;
  for (const Mutant& mutant : mutants) {
    if (mutant.kind == Mutant::Kind::planted) count_planted(score, mutant);
    if (mutant.kind == Mutant::Kind::random) count_random(score, mutant);
    if (mutant.kind != Mutant::Kind::baseline) continue;
    score.has_baseline = true;
    score.passes_baseline = score.passes_baseline && !mutant.caught();
  }
  return score;
}

}  // namespace mpmvv::mutation
