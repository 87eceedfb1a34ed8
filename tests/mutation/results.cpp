#include "tests/mutation/results.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "tests/mutation/score.hpp"

namespace mpmvv::mutation {

namespace fs = std::filesystem;

namespace {

using json = nlohmann::ordered_json;

constexpr std::array<std::pair<const char*, GateStage>, 3> stages{
    {{"unit_tests", GateStage::unit_tests}, {"quick", GateStage::quick}, {"nightly", GateStage::nightly}}};

json trial_json(const Trial* trial) {
  if (!trial) return nullptr;
  return {{"caught", trial->caught}, {"by", trial->by}, {"seconds", trial->seconds}};
}

json mutant_json(const Mutant& mutant) {
  json all{{"name", mutant.name},     {"kind", to_string(mutant.kind)}, {"what", mutant.what},   {"file", mutant.file},
           {"line", mutant.line},     {"before", mutant.before},        {"after", mutant.after}, {"gate", mutant.gate},
           {"reason", mutant.reason}, {"builds", mutant.builds},        {"seed", mutant.seed}};
  for (const auto& [key, stage] : stages) all[key] = trial_json(mutant.trial(stage));
  return all;
}

Mutant mutant_from(const json& all, const std::string& where) {
  Mutant mutant{.name = all.at("name"),
                .kind = support::from_word<Mutant::Kind>(all.at("kind"), "kind of mutant", where),
                .what = all.at("what"),
                .file = all.at("file"),
                .line = all.at("line"),
                .before = all.at("before"),
                .after = all.at("after"),
                .gate = all.at("gate"),
                .builds = all.at("builds"),
                .reason = all.at("reason"),
                .seed = all.at("seed")};
  for (const auto& [key, stage] : stages)
    if (const json& trial = all.at(key); !trial.is_null())
      mutant.trials.push_back({stage, trial.at("caught"), trial.at("by"), trial.at("seconds")});
  return mutant;
}

/// The gate that the unchanged tree has met last.
std::string newest_gate(const std::vector<Mutant>& mutants) {
  std::string gate;
  for (const Mutant& mutant : mutants)
    if (mutant.kind == Mutant::Kind::baseline) gate = mutant.gate;
  return gate;
}

json survivors_json(const std::vector<Mutant>& mutants) {
  json survivors = json::array();
  for (const Mutant& m : mutants)
    if (m.kind == Mutant::Kind::random && m.builds && !m.caught())
      survivors.push_back({{"file", m.file}, {"before", m.before}, {"after", m.after}, {"reason", m.reason}});
  return survivors;
}

}  // namespace

json summary_of(const Results& results) {
  const Score score = score_of(results.mutants);
  std::set<std::uint64_t> seeds;
  for (const Mutant& mutant : results.mutants)
    if (mutant.kind == Mutant::Kind::random) seeds.insert(mutant.seed);
  const auto with_catches = [](json counts, const Catches& catches) {
    counts["caught"] = catches.any;
    counts["unit_tests"] = catches.unit_tests, counts["quick"] = catches.quick, counts["nightly"] = catches.nightly;
    return counts;
  };
  return {{"digest", results.digest},
          {"commit", results.commit},
          {"gate", newest_gate(results.mutants)},
          {"seeds", seeds},
          {"unchanged_passes", score.has_baseline ? json(score.passes_baseline) : json(nullptr)},
          {"planted", with_catches({{"should_show", score.planted},
                                    {"equivalent", score.equivalent},
                                    {"untried", score.untried},
                                    {"open", score.open},
                                    {"missed", score.missed}},
                                   score.planted_catches)},
          {"random",
           with_catches(
               {{"tried", score.random}, {"explained", score.random_explained}, {"unexplained", score.unexplained}},
               score.random_catches)},
          {"survivors", survivors_json(results.mutants)}};
}

json to_json(const Results& results) {
  json all = summary_of(results);
  all["mutants"] = json::array();
  for (const Mutant& mutant : results.mutants) all["mutants"].push_back(mutant_json(mutant));
  return all;
}

std::optional<Results> read_results(const fs::path& file) {
  std::error_code absent;
  if (!fs::exists(fs::symlink_status(file, absent))) return std::nullopt;
  const std::string text = support::require_file(file, "what `./run mutants` writes");
  const auto refuse = [&file](const char* why) {
    throw support::UsageError(fmt::format("{}: {} (what `./run mutants` writes)", file.string(), why));
  };
  try {
    const json all = json::parse(text);
    Results results{all.at("digest"), all.at("commit"), {}};
    for (const json& mutant : all.at("mutants")) results.mutants.push_back(mutant_from(mutant, file.string()));
    if (!support::is_file_stem(results.digest)) refuse("a digest that cannot name a file");
    return results;
  } catch (const json::exception&) {
    refuse("not of this form");
  }
  return std::nullopt;
}

fs::path publish(const Results& results, const fs::path& folder) {
  const fs::path file = folder / "summary.json";
  support::write_if_changed(file, summary_of(results).dump(1) + "\n");
  return file;
}

namespace {

/// Where the results of another program are set aside.
fs::path aside(const fs::path& file, const std::string& digest) {
  return fs::path(file).replace_filename(
      fmt::format("{}-{}{}", file.stem().string(), digest.substr(0, 8), file.extension().string()));
}

}  // namespace

ResultsFile::ResultsFile(fs::path file, Reasons reasons, const store::Provenance& own)
    : file_(std::move(file)), reasons_(std::move(reasons)), results_{own.digest, "", {}} {
  const fs::path folder = fs::absolute(file_).parent_path();
  if (access(folder.c_str(), W_OK) != 0)
    throw support::UsageError(fmt::format("no folder '{}' that may be written for results '{}' (make it first)",
                                          folder.string(), file_.string()));
  auto kept = read_results(file_);
  if (kept && kept->digest != own.digest) {
    other_digest_ = kept->digest;
    kept = read_results(aside(file_, own.digest));
  }
  if (kept && kept->digest == own.digest) results_ = std::move(*kept);
  results_.commit = own.commit + (own.dirty ? " with changes" : "");
}

Results ResultsFile::known() const {
  return {results_.digest, results_.commit, reasons_.reviewed(results_.mutants)};
}

void ResultsFile::keep(const Mutant& mutant) {
  const auto same = std::ranges::find_if(results_.mutants, [&](const Mutant& m) {
    return m.name == mutant.name && m.kind == mutant.kind && m.seed == mutant.seed;
  });
  if (same == results_.mutants.end())
    results_.mutants.push_back(mutant);
  else
    *same = mutant;
  if (other_digest_) {
    support::move_file(file_, aside(file_, *other_digest_));
    other_digest_.reset();
  }
  support::write_if_changed(file_, to_json(known()).dump(1) + "\n");
}

}  // namespace mpmvv::mutation
