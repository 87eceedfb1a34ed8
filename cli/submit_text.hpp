#pragma once
#include <chrono>
#include <filesystem>
#include <string>

#include "studies/support/process.hpp"

namespace mpmvv::cli {

/// Why a script has not submitted all that it should: "'submit.sh' ended with 1: ...", with the last lines that it
/// printed. `queued` says how what it may have queued is found.
std::string submit_fault(const std::filesystem::path& script, const support::ProcessEnd& end,
                         std::chrono::minutes limit, const std::string& queued);

}  // namespace mpmvv::cli
