#include "studies/plan/external_series.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "studies/codes/fields.hpp"
#include "studies/plan/study_inputs.hpp"
#include "studies/support/error.hpp"
#include "studies/support/suggestion.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::plan {

namespace fs = std::filesystem;
using codes::Adapter;
using settings::Setting;
using support::UsageError;

namespace {

const Setting* last_of(const std::vector<Setting>& settings, const std::string& key) {
  const auto last = std::find_if(settings.rbegin(), settings.rend(), [&](const Setting& s) { return s.key == key; });
  return last == settings.rend() ? nullptr : &*last;
}

/// The codes that have an adapter in the folder.
std::vector<std::string> codes_in(const fs::path& folder) {
  std::vector<std::string> codes;
  std::error_code unknown;
  if (!folder.empty())
    for (const auto& entry : fs::directory_iterator(folder, unknown))
      if (fs::exists(entry.path() / "adapter.toml", unknown)) codes.push_back(entry.path().filename());
  return codes;
}

/// Adds a setting whose value the program finds itself; where the study gives one, it must be the same.
void add_found(std::vector<Setting>& settings, const std::string& key, const std::string& value,
               const std::string& where) {
  const Setting* given = last_of(settings, key);
  if (!given) return settings.push_back({key, value, where});
  if (given->value != value)
    throw UsageError(fmt::format("{} = '{}' in {} (it is '{}')", key, given->value, given->where, value));
}

void complete_variant(std::vector<Setting>& settings, const Adapter& adapter, const std::string& where) {
  std::vector<std::string> known;
  for (const auto& [word, values] : adapter.variants) known.push_back(word);
  const Setting* given = last_of(settings, "variant");
  if (!given && known.size() == 1) return settings.push_back({"variant", known.front(), where});
  if (!given && !known.empty())
    throw UsageError(
        fmt::format("no variant for code '{}' in {} (one of: {})", adapter.name, where, fmt::join(known, ", ")));
  if (given && std::ranges::find(known, given->value) == known.end())
    throw UsageError(fmt::format("unknown variant '{}' of code '{}' in {} (known: {})", given->value, adapter.name,
                                 given->where, support::listed(known)));
}

bool is_step(const std::string& key) {
  return key == "cfl" || key == "dt";
}

/// The settings that count, without that of the time step.
std::map<std::string, std::string> settings_beside_step(const SeriesPlan& series) {
  std::map<std::string, std::string> values;
  for (const Setting& setting : series.settings)
    if (!is_step(setting.key)) values[setting.key] = setting.value;
  return values;
}

const Setting* step_of(const SeriesPlan& series) {
  const Setting* cfl = series.setting("cfl");
  return cfl ? cfl : series.setting("dt");
}

/// Requires that no runs of a series, or of two, differ by the time step alone: the code, which chooses its own, would
/// give the same result for all of them.
void require_other_differences(const StudyPlan& plan, const SeriesPlan& series, const std::string& code) {
  const auto refuse = [&](const std::string& what, const std::string& where) {
    throw UsageError(
        fmt::format("the {} in {} of series '{}': code '{}' chooses its time step itself (another key: its result is "
                    "the same at every cfl and dt)",
                    what, where, series.name, code));
  };
  if (plan.searches(series)) refuse("limit", plan.limit->where);
  if (is_step(plan.sweep)) refuse("sweep over " + plan.sweep, plan.sweep_where);
  for (const SeriesPlan& other : plan.series) {
    const Setting *step = step_of(series), *other_step = step_of(other);
    if (!step || !other_step || settings_beside_step(series) != settings_beside_step(other)) continue;
    if (step->key != other_step->key || step->value != other_step->value)
      refuse(fmt::format("{} by which it differs from '{}'", step->key, other.name), step->where);
  }
}

}  // namespace

fs::path CodeFinder::adapter_file(const std::string& code, const fs::path& study_folder,
                                  const std::string& where) const {
  const fs::path own =
      fs::weakly_canonical(fs::current_path() / study_folder).parent_path();  // of adapters/CODE/studies
  std::vector<fs::path> folders{study_folder / "adapters", "adapters", shipped_};
  if (own.parent_path().filename() == "adapters") folders.insert(folders.begin() + 1, own.parent_path());
  std::vector<std::string> known;
  std::error_code unknown;
  for (const fs::path& folder : folders) {
    if (fs::path file = folder / code / "adapter.toml"; !folder.empty() && fs::exists(file, unknown)) return file;
    for (const std::string& other : codes_in(folder)) known.push_back(other);
  }
  std::ranges::sort(known);
  known.erase(std::ranges::unique(known).begin(), known.end());
  throw UsageError(fmt::format("no adapter of code '{}' in {} (adapters/{}/adapter.toml beside the study or here{})",
                               code, where, code,
                               known.empty() ? "" : fmt::format("; there are: {}", fmt::join(known, ", "))));
}

std::vector<fs::path> CodeFinder::adapter_files() const {
  std::map<std::string, fs::path> files;
  for (const fs::path& folder : {fs::path("adapters"), shipped_})
    for (const std::string& code : codes_in(folder)) files.emplace(code, folder / code / "adapter.toml");
  std::vector<fs::path> all;
  for (const auto& [code, file] : files) all.push_back(file);
  return all;
}

const Adapter& CodeFinder::adapter(const std::string& code, const fs::path& file, const std::string& where) {
  if (const auto known = adapters_.find(code); known != adapters_.end()) {
    std::error_code unknown;
    if (!fs::equivalent(known->second.folder, file.parent_path(), unknown))
      throw UsageError(
          fmt::format("code '{}' in {} has another adapter, {}, than a study before it, {} (one at a time)", code,
                      where, file.string(), (known->second.folder / "adapter.toml").string()));
    return known->second;
  }
  return adapters_.emplace(code, codes::read_adapter(file)).first->second;
}

std::string CodeFinder::complete(std::vector<Setting>& settings, const fs::path& study_folder) {
  const Setting* found = last_of(settings, "code");
  if (!found) return "";
  const Setting code = *found;
  const bool is_known = adapters_.contains(code.value);
  const Adapter& adapter = this->adapter(code.value, adapter_file(code.value, study_folder, code.where), code.where);
  plan::complete_variant(settings, adapter, code.where);
  if (!is_known)
    if (auto there = codes::find_code(adapter)) codes_.emplace(code.value, std::move(*there));
  if (!codes_.contains(code.value)) return codes::how_to_get(adapter);
  const codes::Code& there = codes_.at(code.value);
  add_found(settings, "code_version", there.version, code.where);
  add_found(settings, "adapter", there.digest, code.where);
  return "";
}

void CodeFinder::complete_variant(std::vector<Setting>& settings, const fs::path& study_folder) {
  const Setting* found = last_of(settings, "code");
  if (!found) return;
  const Setting code = *found;
  plan::complete_variant(settings, codes::read_adapter(adapter_file(code.value, study_folder, code.where)), code.where);
}

std::string complete_series(StudyPlan& plan, const fs::path& file, CodeFinder& finder) {
  std::string absent;
  for (SeriesPlan& series : plan.series) {
    const std::string complaint = finder.complete(series.settings, file.parent_path());
    if (!complaint.empty()) absent = complaint;
    const Setting* code = series.setting("code");
    if (!code || !complaint.empty()) continue;
    std::vector<cases::Case> cases = sweep_cases(plan, series);
    if (plan.searches(series))
      for (const SeriesPlan& replicate : replicates_of(plan, series))
        for (const cases::Case& c : scan_cases(plan, replicate)) cases.push_back(c);
    const codes::Code& there = finder.codes().at(code->value);
    for (const cases::Case& c : cases) codes::require_able(there.adapter, c);
    if (!cases.empty()) codes::require_sound_templates(cases.front(), there);
  }
  for (const SeriesPlan& series : plan.series) {  // when all have their variants
    const Setting* code = series.setting("code");
    const auto there = code ? finder.codes().find(code->value) : finder.codes().end();
    if (there != finder.codes().end() && !there->second.adapter.stepping.is_given)
      require_other_differences(plan, series, code->value);
  }
  return absent;
}

}  // namespace mpmvv::plan
