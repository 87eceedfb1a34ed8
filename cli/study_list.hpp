#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "studies/claims/claim.hpp"
#include "studies/records/result.hpp"

namespace mpmvv::cli {

/// The studies of a folder with their titles and the ids of their claims; without a folder, of the one that comes with
/// the program.
nlohmann::json study_list(const std::string& folder);

/// Says of claims which studies that come with the program judge them, too, but are not among the results.
void name_studies_not_run(std::vector<claims::Claim>& claims, const std::vector<records::StudyResult>& results);

}  // namespace mpmvv::cli
