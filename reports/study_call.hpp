#pragma once
#include <string>
#include <vector>

namespace mpmvv::reports {

/// How a study is run once more.
struct StudyCall {
  std::string study;         ///< its name where it comes with the program, else its file
  std::string options = {};  ///< of a trial, " --set shuffle=3"
};

/// "mpmvv study s-fig10 mine.toml --db results.db"; trials have a command of their own for each choice of options, on
/// `db_of_trials`.
std::string study_command(const std::vector<StudyCall>& calls, const std::string& db, const std::string& db_of_trials);

}  // namespace mpmvv::reports
