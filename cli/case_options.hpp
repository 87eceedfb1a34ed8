#pragma once
#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "studies/settings/settings.hpp"

namespace mpmvv::cli {

/// The options of commands that take one case: an option for each setting key, and --param.
class CaseOptions {
 public:
  void add_to(CLI::App& command);

  /// What was given.
  std::vector<settings::Setting> settings() const;

  /// UsageError where what was given makes no case.
  cases::Case the_case() const;

 private:
  std::map<std::string, CLI::Option*> given_, flags_;  ///< by setting key
  std::vector<std::string> parameters_;
};

}  // namespace mpmvv::cli
