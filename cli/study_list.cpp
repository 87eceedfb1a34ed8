#include "cli/study_list.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/shipped.hpp"
#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::cli {

namespace {

/// The ids of the claims that a study names, for figures or for criteria.
std::vector<std::string> claims_of(const support::TomlTable& study) {
  std::vector<std::string> ids = study.texts("claims");
  for (const auto& claim : study.tables("claim"))
    if (const std::string id = claim.text("id"); std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
  return ids;
}

/// The claims that a study judges by criteria; none of a file that cannot be read, which is for others to complain of.
std::set<std::string> claims_judged_in(const std::filesystem::path& file) {
  std::set<std::string> ids;
  try {
    for (const auto& criterion : support::TomlTable::read(file).tables("criterion"))
      ids.insert(criterion.text("claim"));
  } catch (const support::UsageError&) {
    return {};
  }
  return ids;
}

}  // namespace

nlohmann::json study_list(const std::string& folder) {
  const std::filesystem::path place = folder.empty() ? shipped("studies") : std::filesystem::path(folder);
  nlohmann::json studies = nlohmann::json::array();
  for (const std::string& name : study_names(place)) {
    const auto file = support::TomlTable::read(place / (name + ".toml"));
    studies.push_back({{"name", name}, {"title", file.text("title")}, {"claims", claims_of(file)}});
  }
  if (studies.empty()) refuse_without_study(place.string());
  return studies;
}

void name_studies_not_run(std::vector<claims::Claim>& claims, const std::vector<records::StudyResult>& results) {
  const std::filesystem::path place = shipped("studies");
  for (const std::string& name : study_names(place)) {
    const auto result = std::ranges::find(results, name, &records::StudyResult::name);
    const std::set<std::string> judged = claims_judged_in(place / (name + ".toml"));
    for (claims::Claim& claim : claims) {
      const bool is_there =
          result != results.end() && std::ranges::find(result->claims, claim.id) != result->claims.end();
      if (!is_there && judged.contains(claim.id)) claim.not_run.push_back(name);
    }
  }
}

}  // namespace mpmvv::cli
