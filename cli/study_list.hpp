#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mpmvv::cli {

/// The studies of a folder with their titles and the ids of their claims; without a folder, of the one that comes with
/// the program.
nlohmann::json study_list(const std::string& folder);

}  // namespace mpmvv::cli
