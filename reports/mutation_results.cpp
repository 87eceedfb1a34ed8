#include "reports/mutation_results.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::reports {

namespace {

using nlohmann::json;

std::optional<StageResult> stage_from(const json& mutant, const char* stage) {
  const auto found = mutant.find(stage);
  if (found == mutant.end() || found->is_null()) return std::nullopt;
  return StageResult{found->at("caught"), found->at("by")};
}

MutantResult mutant_from(const json& all, const std::string& gate) {
  MutantResult mutant{.name = all.value("name", ""),
                      .what = all.value("what", ""),
                      .file = all.at("file"),
                      .line = all.value("line", 0),
                      .before = all.at("before"),
                      .after = all.at("after"),
                      .reason = all.at("reason"),
                      .builds = all.value("builds", true),
                      .unit_tests = stage_from(all, "unit_tests"),
                      .quick = stage_from(all, "quick"),
                      .nightly = stage_from(all, "nightly")};
  mutant.by_earlier_gate = !mutant.is_untried() && all.value("gate", gate) != gate;
  return mutant;
}

PlantedScore planted_from(const json& all) {
  return {.should_show = all.at("should_show"),
          .equivalent = all.at("equivalent"),
          .unit_tests = all.at("unit_tests"),
          .quick = all.at("quick"),
          .nightly = all.at("nightly"),
          .caught = all.at("caught"),
          .untried = all.at("untried"),
          .open = all.at("open"),
          .missed = all.at("missed")};
}

RandomScore random_from(const json& all) {
  return {.tried = all.at("tried"), .caught = all.at("caught"), .explained = all.at("explained")};
}

MutationResults results_from(const json& all) {
  MutationResults results{.digest = all.at("digest"),
                          .commit = all.at("commit"),
                          .planted = planted_from(all.at("planted")),
                          .random = random_from(all.at("random"))};
  if (const json& passes = all.at("unchanged_passes"); !passes.is_null()) results.unchanged_passes = passes.get<bool>();
  const std::string gate = all.at("gate");
  if (!all.contains("mutants"))
    for (const json& survivor : all.at("survivors")) results.survivors.push_back(mutant_from(survivor, gate));
  for (const json& mutant : all.value("mutants", json::array())) {
    MutantResult result = mutant_from(mutant, gate);
    if (mutant.at("kind") == "planted")
      results.mistakes.push_back(std::move(result));
    else if (mutant.at("kind") == "random" && result.builds && !result.caught())
      results.survivors.push_back(std::move(result));
  }
  return results;
}

}  // namespace

std::optional<MutationResults> read_mutation_results(const std::filesystem::path& file) {
  const auto text = support::read_file(file);
  if (!text) return std::nullopt;
  try {
    return results_from(json::parse(*text));
  } catch (const json::exception&) {
    throw support::UsageError(
        fmt::format("{} is not what `./run mutants` writes (which makes it anew)", file.string()));
  }
}

}  // namespace mpmvv::reports
