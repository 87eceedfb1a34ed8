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
  /// `where_required` is for the help, " with --form per-particle": where cells, ppc and a time step are required. The
  /// problem always is.
  void add_to(CLI::App& command, const std::string& where_required = "");

  /// What was given.
  std::vector<settings::Setting> settings() const;

  /// UsageError where what was given makes no case. A code that it names has an adapter and the variant; its program
  /// need not be there.
  cases::Case the_case() const;

  /// The problem alone with its values, whatever else is given or not.
  cases::ProblemChoice the_choice() const;

 private:
  std::map<std::string, CLI::Option*> given_, flags_;  ///< by setting key
  std::vector<std::string> parameters_;
};

}  // namespace mpmvv::cli
