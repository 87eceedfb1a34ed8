#pragma once
#include <chrono>
#include <string>

#include "goldens/mutants/edit.hpp"
#include "studies/mutant.hpp"

namespace mpmvv {

/// Where mutants meet the stages of the gate.
class Bench {
 public:
  virtual ~Bench() = default;

  /// Builds the program with an edit or, where null, without; false when it does not compile.
  virtual bool build(const Edit* edit) = 0;

  /// Takes what was built last through the stage; what takes more than the limit is stopped, and caught.
  virtual Trial meet(GateStage stage, std::chrono::seconds limit) = 0;

  virtual std::string complaint() const = 0;  ///< the end of what the last build that failed printed
};

}  // namespace mpmvv
