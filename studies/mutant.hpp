#pragma once
#include <string>
#include <vector>

#include "studies/alarms.hpp"
#include "studies/records/result.hpp"

namespace mpmvv {

/// A part of the gate: the fast tests; the studies of `studies/quick.txt` against their goldens; the other studies with
/// goldens.
enum class GateStage { unit_tests, quick, nightly };

std::string to_string(GateStage stage);
GateStage gate_stage_from(const std::string& word);

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
  std::string reason = {};  ///< why nothing shows it, as someone explains; not kept in a store

  const Trial* trial(GateStage stage) const;  ///< null when it has not met this stage
  bool caught() const;                        ///< by any
  bool open() const;                          ///< not caught, and some stage has not been met
  bool caught_by(GateStage stage) const;
};

std::string to_string(Mutant::Kind kind);
Mutant::Kind mutant_kind_from(const std::string& word);

/// The one with the same name, gate and edit; null when there is none.
const Mutant* find_mutant(const std::vector<Mutant>& mutants, const Mutant& wanted);

/// Of several results under one name the last.
std::vector<Mutant> newest(const std::vector<Mutant>& mutants);

/// Of the planted mistakes those without a `reason` should show; what does not compile is no mutant. One that nothing
/// has caught is open until it has met every stage.
struct MutantScore {
  int planted = 0, silent = 0, open = 0;                            ///< that should show; that nothing can show; open
  int by_unit_tests = 0, by_quick = 0, by_nightly = 0, by_any = 0;  ///< of those that should show
  int random = 0, random_caught = 0, random_explained = 0;          ///< explained: survivors with a reason
  std::vector<std::string> missed, unexplained;                     ///< names of planted and of random ones
  bool has_baseline = false, passes_baseline = true;                ///< the tree without a mistake
};

MutantScore score_of(const std::vector<Mutant>& mutants);

/// What they and the runs without a mistake say on claim X-mutants, as the parts of a study; without parts when there
/// are no planted ones.
records::StudyResult mutant_study(const std::vector<Mutant>& mutants, const std::vector<AlarmRun>& runs);

}  // namespace mpmvv
