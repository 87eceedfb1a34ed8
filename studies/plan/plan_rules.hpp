#pragma once
#include <string>
#include <vector>

#include "studies/plan/study.hpp"
#include "studies/support/toml_file.hpp"

/// What the parts of a study file (fits, figures, criteria) may name, held against the plan read so far. Each throws
/// UsageError with file and line.
namespace mpmvv::plan {

void require_word(const std::string& what, const std::string& word, const std::vector<std::string>& known,
                  const std::string& where);

/// The norm that a table names under `key`.
std::string norm_of(const support::TomlTable& table, const char* key);

/// Names of series that a table lists under `key`; each must exist (checks make theirs when they run).
std::vector<std::string> series_names(const support::TomlTable& table, const char* key, const StudyPlan& plan);

fits::Window read_window(const support::TomlTable& table, const char* key);

/// A window must hold enough swept values; the curves of a check are known only when it has run.
void require_points(const StudyPlan& plan, const fits::Window& window, int least, const std::string& where);

/// Every setting of a series must count in some run: not one that the sweep, the search of a limit or the replicates
/// set in all of them. And a limit must have a value of what the sweep varies.
void require_no_idle_settings(const StudyPlan& plan, const SeriesPlan& series);

/// What stands for several runs must differ in more than what is measured of them.
void require_different_runs(std::vector<cases::Case> cases, const std::string& what, const std::string& where);

/// Cost is there when every series asks for it.
void require_cost(const StudyPlan& plan, const std::string& where);

/// `y` is what a check's curves have; errors over all steps, of nodes, velocities and stresses are there when each of
/// these series (all, where none is named) asks for them.
void require_measured(const StudyPlan& plan, const std::string& norm, const std::vector<std::string>& names,
                      const std::string& where);

/// The series named, held against the same; where none is, all but those whose setting says that they do without.
std::vector<std::string> measured_series(const StudyPlan& plan, const std::string& norm, std::vector<std::string> names,
                                         const std::string& where);

}  // namespace mpmvv::plan
