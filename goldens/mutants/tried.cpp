#include "goldens/mutants/tried.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv {

using support::read_file;
using support::UsageError;
using support::write_if_changed;

namespace {

using nlohmann::json;

constexpr std::array<std::pair<const char*, GateStage>, 3> stages{
    {{"unit_tests", GateStage::unit_tests}, {"quick", GateStage::quick}, {"nightly", GateStage::nightly}}};

json trial_json(const Trial* trial) {
  if (!trial) return nullptr;
  return {{"caught", trial->caught}, {"by", trial->by}, {"seconds", trial->seconds}};
}

json mutant_json(const Mutant& mutant) {
  json all{{"name", mutant.name},     {"kind", to_string(mutant.kind)}, {"what", mutant.what},   {"file", mutant.file},
           {"line", mutant.line},     {"before", mutant.before},        {"after", mutant.after}, {"gate", mutant.gate},
           {"reason", mutant.reason}, {"builds", mutant.builds}};
  for (const auto& [key, stage] : stages) all[key] = trial_json(mutant.trial(stage));
  return all;
}

Mutant mutant_from(const json& all) {
  Mutant mutant{.name = all.at("name"),
                .kind = mutant_kind_from(all.at("kind")),
                .what = all.at("what"),
                .file = all.at("file"),
                .line = all.at("line"),
                .before = all.at("before"),
                .after = all.at("after"),
                .gate = all.at("gate"),
                .builds = all.at("builds"),
                .reason = all.at("reason")};
  for (const auto& [key, stage] : stages)
    if (const json& trial = all.at(key); !trial.is_null())
      mutant.trials.push_back({stage, trial.at("caught"), trial.at("by"), trial.at("seconds")});
  return mutant;
}

std::filesystem::path file_in(const std::filesystem::path& folder) {
  return folder / "tried.json";
}

TriedMutants tried_from(const json& all) {
  TriedMutants tried{all.at("digest"), all.at("commit"), {}};
  for (const json& mutant : all.at("mutants")) tried.mutants.push_back(mutant_from(mutant));
  return tried;
}

}  // namespace

json to_json(const TriedMutants& tried) {
  json mutants = json::array();
  for (const Mutant& mutant : tried.mutants) mutants.push_back(mutant_json(mutant));
  return {{"digest", tried.digest}, {"commit", tried.commit}, {"mutants", mutants}};
}

TriedMutants read_tried(const std::filesystem::path& folder) {
  const auto file = file_in(folder);
  if (!std::filesystem::exists(file)) return {};
  const auto refuse = [&file](const char* why) {
    throw UsageError(fmt::format("{}: {} (what `mpmvv mutants --publish` writes)", file.string(), why));
  };
  const auto text = read_file(file);
  if (!text) refuse("cannot be read");
  try {
    return tried_from(json::parse(*text));
  } catch (const json::exception&) {
    refuse("not of this form");
  } catch (const std::invalid_argument& e) {
    refuse(e.what());
  }
  return {};
}

std::filesystem::path publish(const TriedMutants& tried, const std::filesystem::path& folder) {
  const auto file = file_in(folder);
  write_if_changed(file, to_json(tried).dump(1) + "\n");
  return file;
}

std::vector<Mutant> with_published(std::vector<Mutant> stored, const std::vector<Mutant>& published) {
  std::vector<Mutant> all;
  for (const Mutant& mutant : published)
    if (!find_mutant(stored, mutant)) all.push_back(mutant);
  for (Mutant& mutant : stored) {
    if (const Mutant* same = find_mutant(published, mutant))
      for (const Trial& trial : same->trials)
        if (!mutant.trial(trial.stage)) mutant.trials.push_back(trial);
    all.push_back(std::move(mutant));
  }
  return all;
}

}  // namespace mpmvv
