#pragma once
#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "studies/plan/external_series.hpp"
#include "studies/plan/study.hpp"

namespace mpmvv::cli {

/// Which studies a user names, and which settings are given for them.
struct StudyChoice {
  std::vector<std::string> names;
  std::string studies;                             ///< a folder
  std::vector<std::string> settings, where_taken;  ///< KEY=VALUE
};

/// The options that name studies: FILE..., --studies.
void add_study_choice(CLI::App& command, StudyChoice& choice);

/// What becomes of a study whose code is not there.
enum class AbsentCode { left_out, refused };

/// The studies that a command works on, and how many were left out because their code is not there.
struct ChosenStudies {
  std::vector<plan::StudyPlan> plans;
  std::size_t left_out = 0;
};

/// Reads the studies, and notes what the settings changed and which studies are left out. UsageError for a mistake in a
/// study, and where the results store is one of their files.
ChosenStudies read_plans(const StudyChoice& choice, const std::string& db, plan::CodeFinder& codes, AbsentCode absent);

}  // namespace mpmvv::cli
