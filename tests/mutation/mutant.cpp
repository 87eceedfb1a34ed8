#include "tests/mutation/mutant.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <tuple>

namespace mpmvv::mutation {

namespace {

constexpr std::array stage_words{"unit tests", "quick", "nightly"};
constexpr std::array mutant_kind_words{"baseline", "planted", "random"};

}  // namespace

std::string to_string(GateStage stage) {
  return stage_words[static_cast<std::size_t>(stage)];
}

std::string to_string(Mutant::Kind kind) {
  return mutant_kind_words[static_cast<std::size_t>(kind)];
}

Mutant::Kind mutant_kind_from(const std::string& word) {
  const auto found = std::ranges::find(mutant_kind_words, word);
  if (found == mutant_kind_words.end()) throw std::invalid_argument("unknown word '" + word + "'");
  return static_cast<Mutant::Kind>(found - mutant_kind_words.begin());
}

const Trial* Mutant::trial(GateStage stage) const {
  const auto found = std::ranges::find(trials, stage, &Trial::stage);
  return found == trials.end() ? nullptr : &*found;
}

bool Mutant::caught() const {
  return std::ranges::any_of(trials, &Trial::caught);
}

bool Mutant::open() const {
  constexpr std::array all{GateStage::unit_tests, GateStage::quick, GateStage::nightly};
  return builds && !caught() && std::ranges::any_of(all, [this](GateStage stage) { return !trial(stage); });
}

bool Mutant::caught_by(GateStage stage) const {
  const Trial* met = trial(stage);
  return met && met->caught;
}

const Mutant* find_mutant(const std::vector<Mutant>& mutants, const Mutant& wanted) {
  const auto identity = [](const Mutant& m) { return std::tie(m.name, m.gate, m.file, m.line, m.before, m.after); };
  const auto found = std::ranges::find_if(mutants, [&](const Mutant& m) { return identity(m) == identity(wanted); });
  return found == mutants.end() ? nullptr : &*found;
}

}  // namespace mpmvv::mutation
