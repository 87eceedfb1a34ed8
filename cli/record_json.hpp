#pragma once
#include <nlohmann/json_fwd.hpp>

#include "studies/records/record.hpp"

namespace mpmvv::cli {

/// A record as `mpmvv run --json` prints it.
nlohmann::json record_json(const records::Record& r);

}  // namespace mpmvv::cli
