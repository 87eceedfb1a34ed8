#include "cli/study_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/shipped.hpp"
#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::cli {

nlohmann::json study_list(const std::string& folder) {
  const std::filesystem::path place = folder.empty() ? shipped("studies") : std::filesystem::path(folder);
  nlohmann::json studies = nlohmann::json::array();
  for (const std::string& name : study_names(place)) {
    const auto file = support::TomlTable::read(place / (name + ".toml"));
    std::vector<std::string> claims = file.texts("claims");
    for (const auto& claim : file.tables("claim"))
      if (const std::string id = claim.text("id"); std::ranges::find(claims, id) == claims.end()) claims.push_back(id);
    studies.push_back({{"name", name}, {"title", file.text("title")}, {"claims", claims}});
  }
  if (studies.empty())
    throw support::UsageError(fmt::format("no study in '{}' (--studies: a folder with study files)", place.string()));
  return studies;
}

}  // namespace mpmvv::cli
