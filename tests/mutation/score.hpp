#pragma once
#include <string>
#include <vector>

#include "tests/mutation/mutant.hpp"

namespace mpmvv::mutation {

/// How many mutants each stage has caught, and how many any of them has.
struct Catches {
  int unit_tests = 0, quick = 0, nightly = 0, any = 0;
};

/// Planted mistakes without a `reason` should show. A random mutation that does not compile is no mutant. A mutant that
/// nothing has caught is open until it has met every stage.
struct Score {
  int planted = 0, equivalent = 0, untried = 0, open = 0;  ///< planted: that should show; of these untried and open
  Catches planted_catches;
  int random = 0, random_explained = 0;  ///< explained: survivors with a reason
  Catches random_catches;
  std::vector<std::string> missed, unexplained;       ///< names of planted and of random ones
  bool has_baseline = false, passes_baseline = true;  ///< the tree without a mistake
};

Score score_of(const std::vector<Mutant>& mutants);

}  // namespace mpmvv::mutation
