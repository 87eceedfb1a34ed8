#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "tests/mutation/mutant.hpp"
#include "tests/mutation/mutant_schemata.hpp"

namespace mpmvv::mutation {

/// Whether a complaint is of a golden that cannot judge.
inline bool is_inconclusive(const std::string& complaint) {
  return complaint.ends_with("(inconclusive)");
}

/// Where mutants meet the stages of the gate.
class Bench {
 public:
  virtual ~Bench() = default;

  /// Builds the program with an edit or, where null, without; false when it does not compile.
  virtual bool build(const Edit* edit) = 0;

  /// Takes what was built last through the stage; a mutant that takes more than the limit is stopped, and counts as
  /// caught. A stage that cannot depend on the edited file is passed at once.
  virtual Trial meet(GateStage stage, std::chrono::seconds limit) = 0;

  virtual std::string complaint() const = 0;  ///< the end of what the last build that failed printed
};

/// A bench that can build many mutants at once.
class SchemataBench : public Bench {
 public:
  using Bench::build;

  /// Builds the program and its tests with many edits side by side. Returns the numbers of the edits that are built in:
  /// those that cannot stand side by side, or do not compile, are left out.
  virtual std::vector<int> build(const std::vector<Choice>& choices) = 0;

  /// Chooses the mutant that meets stages from then on, one of those that were built in; null chooses none.
  virtual void choose(const Choice* choice) = 0;
};

}  // namespace mpmvv::mutation
