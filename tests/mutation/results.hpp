#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tests/mutation/mutant.hpp"

namespace mpmvv::mutation {

/// How the gate took mutants, as `mpmvv mutants --json` prints it and `goldens/mutants/tried.json` publishes it.
struct TriedMutants {
  std::string digest;  ///< of the program that tried them, see `Provenance`
  std::string commit;
  std::vector<Mutant> mutants;
};

nlohmann::json to_json(const TriedMutants& tried);

/// What is published in the folder of the mutants' lists; none where nothing is. UsageError when the file holds
/// anything else than `publish` has written.
TriedMutants read_tried(const std::filesystem::path& folder);

/// Writes the folder's file; returns its name.
std::filesystem::path publish(const TriedMutants& tried, const std::filesystem::path& folder);

/// What a store knows and what is published: of the same mutant in the same gate the trials of both, the store's first.
std::vector<Mutant> with_published(std::vector<Mutant> stored, const std::vector<Mutant>& published);

}  // namespace mpmvv::mutation
