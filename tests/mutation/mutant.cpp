#include "tests/mutation/mutant.hpp"

#include <algorithm>
#include <array>

#include "tests/mutation/anchor.hpp"

namespace mpmvv::mutation {

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
  const auto found = std::ranges::find_if(mutants, [&](const Mutant& m) {
    return m.name == wanted.name && m.gate == wanted.gate && m.file == wanted.file &&
           is_same_code(m.before, wanted.before) && is_same_code(m.after, wanted.after);
  });
  return found == mutants.end() ? nullptr : &*found;
}

}  // namespace mpmvv::mutation
