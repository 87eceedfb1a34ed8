#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mpmvv::reports {

/// What a stage of the gate said of a mutant.
struct StageResult {
  bool caught = false;
  std::vector<std::string> by = {};  ///< the first test or the goldens that did not pass
};

/// A variant of the program with one mistake, and how the gate took it. A stage that it has not met has no result.
struct MutantResult {
  std::string name = {}, what = {};
  std::string file = {};
  int line = 0;                         ///< the first one changed
  std::string before = {}, after = {};  ///< its text, without and with the mistake
  std::string reason = {};              ///< why nothing can show it; empty when something should
  bool builds = true;
  bool by_earlier_gate = false;  ///< tried before tests or goldens were added, the sources being the same
  std::optional<StageResult> unit_tests = {}, quick = {}, nightly = {};

  bool is_untried() const { return builds && !unit_tests && !quick && !nightly; }
  bool caught() const {
    return (unit_tests && unit_tests->caught) || (quick && quick->caught) || (nightly && nightly->caught);
  }
};

/// How many of the planted mistakes that should show each part of the gate has caught.
struct PlantedScore {
  int should_show = 0, equivalent = 0;                     ///< an equivalent one changes no result
  int unit_tests = 0, quick = 0, nightly = 0, caught = 0;  ///< caught: by any of them
  int untried = 0, open = 0;                               ///< open: not caught, and some stage not met
  std::vector<std::string> missed = {};                    ///< names
};

/// How many of the random mutations that compile the gate has caught.
struct RandomScore {
  int tried = 0, caught = 0;
  int explained = 0;  ///< survivors with a reason
};

/// What a mutation campaign (tests/mutation) has found: all of it, or the summary that it has published.
struct MutationResults {
  std::string digest;  ///< of the release program of the sources that were tried, see `Provenance`
  std::string commit;
  PlantedScore planted;
  RandomScore random;
  std::optional<bool> unchanged_passes =
      {};                                    ///< whether the tree without a mistake passes the gate, where it was tried
  std::vector<MutantResult> mistakes = {};   ///< the planted ones; none in a summary
  std::vector<MutantResult> survivors = {};  ///< random ones that compile and nothing has caught

  int tried() const { return planted.should_show - planted.untried + random.tried; }
};

/// Reads what the campaign writes; nullopt when the file is absent. support::UsageError on anything else.
std::optional<MutationResults> read_mutation_results(const std::filesystem::path& file);

}  // namespace mpmvv::reports
