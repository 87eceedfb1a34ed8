#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "studies/support/words.hpp"

namespace mpmvv::mutation {

using support::to_string;

/// A part of the gate: the fast tests; the studies of `studies/quick.txt` against their goldens; the other studies with
/// goldens.
enum class GateStage { unit_tests, quick, nightly };
constexpr std::array<const char*, 3> words_of(GateStage) {
  return {"unit tests", "quick", "nightly"};
}

/// How one stage took a mutant.
struct Trial {
  GateStage stage = GateStage::unit_tests;
  bool caught = false;
  std::vector<std::string> by = {};  ///< the first test or all goldens that do not pass, or how else the stage ended
  double seconds = 0;
};

/// A variant of the program with one mistake, and how the gate took it.
struct Mutant {
  enum class Kind {
    baseline,  ///< no mistake: what the gate must let pass
    planted,   ///< a mistake that someone has chosen
    random     ///< an operator, operand or constant changed at a place that was drawn
  };

  std::string name;
  Kind kind = Kind::planted;
  std::string what;                     ///< the mistake in one sentence
  std::string file;                     ///< from the top of the tree
  int line = 0;                         ///< the first one changed
  std::string before = {}, after = {};  ///< its text, without and with the mistake
  std::string gate = {};                ///< digest of the sources, tests, studies and goldens
  bool builds = true;
  std::vector<Trial> trials = {};
  std::string reason = {};  ///< why nothing shows it, as someone explains
  std::uint64_t seed = 0;   ///< of the draw of a random one

  const Trial* trial(GateStage stage) const;  ///< null when it has not met this stage
  bool caught() const;                        ///< by any
  bool open() const;                          ///< not caught, and some stage has not been met
  bool caught_by(GateStage stage) const;
};

constexpr std::array<const char*, 3> words_of(Mutant::Kind) {
  return {"baseline", "planted", "random"};
}

/// The mutant with the same name, gate and edited code; null when there is none. The line of the edit, its layout and
/// comments do not count.
const Mutant* find_mutant(const std::vector<Mutant>& mutants, const Mutant& wanted);

}  // namespace mpmvv::mutation
