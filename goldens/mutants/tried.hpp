#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "studies/mutant.hpp"

namespace mpmvv {

/// How the gate took mutants, as `mpmvv mutants --json` prints it and `goldens/mutants/tried.json` publishes it.
struct TriedMutants {
  std::string digest;  ///< of the program that tried them, see `Provenance`
  std::string commit;
  std::vector<Mutant> mutants;
};

nlohmann::json to_json(const TriedMutants& tried);

/// Reads what `to_json` has written; none where there is no such file. UsageError when it holds anything else.
TriedMutants read_tried(const std::filesystem::path& file);

}  // namespace mpmvv
