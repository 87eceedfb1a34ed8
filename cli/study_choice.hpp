#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "studies/plan/study.hpp"

namespace mpmvv::cli {

/// Which studies a user names, and what he sets in them.
struct StudyChoice {
  std::vector<std::string> names;
  std::string studies;                             ///< a folder
  std::vector<std::string> settings, where_taken;  ///< KEY=VALUE
};

/// The options that name studies: FILE..., --studies.
void add_study_choice(CLI::App& command, StudyChoice& choice);

/// Reads them and says what the settings changed. UsageError for what is wrong in them, and where the results store is
/// one of their files.
std::vector<plan::StudyPlan> read_plans(const StudyChoice& choice, const std::string& db);

}  // namespace mpmvv::cli
