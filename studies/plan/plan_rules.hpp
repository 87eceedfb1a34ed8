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

/// Names of series that a table lists under `key`, or the one there; each must exist (checks make theirs when they
/// run).
std::vector<std::string> series_names(const support::TomlTable& table, const char* key, const StudyPlan& plan);
std::string series_name(const support::TomlTable& table, const char* key, const StudyPlan& plan);

fits::Window read_window(const support::TomlTable& table, const char* key);

/// A window must hold enough swept values, and its ends must be such; the curves of a check are known only when it has
/// run.
void require_points(const StudyPlan& plan, const fits::Window& window, int least, const std::string& where);

/// Throws for a sweep whose values say nothing of a step size: the terms of an expansion, the seed of a shuffle. A
/// power law over them has no order, and no limit at zero. What a check has its curves over is its own affair.
void require_step_size(const StudyPlan& plan, const std::string& where);

/// Throws where a series is neither swept nor searched; where one of its settings has no effect, because the sweep, the
/// limit's search or the replicates overwrite it in every run; and where a limit lacks a value for the swept key.
void require_no_idle_settings(const StudyPlan& plan, const SeriesPlan& series);

/// Throws where two runs that should differ (two series, two replicates) differ at most in what is measured.
void require_different_runs(std::vector<cases::Case> cases, const std::string& what, const std::string& where);

/// Throws unless every series measures its cost (`repeat`).
void require_cost(const StudyPlan& plan, const std::string& where);

/// Throws when a named series (any series, when none is named) does not measure `norm`: errors over all steps and of
/// nodes, velocities and stresses are measured only where a series asks for them. Curves of a check have the quantity
/// `y`.
void require_measured(const StudyPlan& plan, const std::string& norm, const std::vector<std::string>& names,
                      const std::string& where);

/// The series that a table names; when it names none, all but those that turn the norm's setting off. Checked by
/// require_measured.
std::vector<std::string> measured_series(const StudyPlan& plan, const std::string& norm, std::vector<std::string> names,
                                         const std::string& where);

/// The series of a figure of particles: those named, or all that do not turn `particle_errors` off. Throws unless each
/// of these asks for them, and when the study has replicates.
std::vector<std::string> series_with_particles(const StudyPlan& plan, std::vector<std::string> names,
                                               const std::string& where);

}  // namespace mpmvv::plan
