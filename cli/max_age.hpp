#pragma once
#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/records/result.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::cli {

/// Adds the option --max-age, in hours, to a command that judges goldens.
void add_max_age(CLI::App& command, std::optional<int>& hours);

/// Those of the studies that were last run more than so many hours ago, with a text that says so. None without a limit.
std::map<std::string, std::string> outdated(const std::vector<records::StudyResult>& studies, const store::Store& store,
                                            std::optional<int> hours);

}  // namespace mpmvv::cli
