#pragma once
#include <nlohmann/json.hpp>

namespace mpmvv::cli {

/// The other codes that have an adapter here or among those that come with the program: by name, with program and
/// version where these are there, else with what is missing.
nlohmann::json codes_json();

void print_codes(const nlohmann::json& codes);

}  // namespace mpmvv::cli
