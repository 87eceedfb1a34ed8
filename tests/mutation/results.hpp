#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "studies/store/provenance.hpp"
#include "tests/mutation/mistake.hpp"
#include "tests/mutation/mutant.hpp"

namespace mpmvv::mutation {

/// What the gate said of the mutants of one program.
struct Results {
  std::string digest;  ///< of the program that tried them, see `Provenance`
  std::string commit;
  std::vector<Mutant> mutants;
};

/// The score by kind and stage, and the random mutants that nothing has caught: what a campaign publishes.
nlohmann::ordered_json summary_of(const Results& results);

/// The same and every mutant.
nlohmann::ordered_json to_json(const Results& results);

/// Reads what `to_json` has written; nullopt where there is no file. UsageError when it holds anything else.
std::optional<Results> read_results(const std::filesystem::path& file);

/// Writes the summary into the folder; returns the file's name.
std::filesystem::path publish(const Results& results, const std::filesystem::path& folder);

/// The file that a campaign's results go to, made with the first of them. It is written anew, whole, after every trial:
/// a campaign that is killed loses the trial under way.
class ResultsFile {
 public:
  /// UsageError, with nothing written, when the file cannot be or holds something else.
  ResultsFile(std::filesystem::path file, Reasons reasons, const store::Provenance& own);

  /// What it knows of this program's mutants, reviewed.
  Results known() const;

  /// Puts a mutant in the place of the one with this name, kind and seed. Results of another program are first set
  /// aside, in a file beside it that is named by their digest. That program goes on from there when it comes back.
  void keep(const Mutant& mutant);

 private:
  std::filesystem::path file_;
  Reasons reasons_;
  Results results_;
  std::optional<std::string> other_digest_;  ///< of the program whose results the file holds, if it is another one
};

}  // namespace mpmvv::mutation
